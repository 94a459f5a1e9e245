#pragma once

#include <functional>
#include <span>
#include <vector>

#include "core/analysis/envelope/envelope.h"
#include "ui/charts/value_fit.h"

namespace feedscope::ui {

/// The pixel columns of one run in the charts. When the range moves by whole columns, those still visible are
/// kept, so that panning costs only the new ones.
class ColumnCache {
 public:
  /// Time at a position along the abscissa [s], not descending.
  using TimeAt = std::function<double(double)>;
  /// One band between each pair of neighbours in `times` [s].
  using BandsOf = std::function<std::vector<Band>(std::span<const double>)>;

  /// Updates to `count` columns over `range`.
  void update(const BandsOf& bands_of, const Interval& range, int count, const TimeAt& time_at);
  /// Updates to columns of a run, which are empty beyond its `end` [s]. `rapids`: whether the columns include
  /// them.
  void update(const Envelope& envelope, double end, const Interval& range, int count, const TimeAt& time_at,
              bool rapids = true);
  /// Discards all columns: for another run, abscissa or choice of rapids.
  void clear();

  const std::vector<Band>& bands() const { return bands_; }
  /// Of the column borders, one more than columns [s].
  const std::vector<double>& times() const { return times_; }

 private:
  int shift_to(const Interval& range, int count) const;

  double start_ = 0;  ///< position of the first border
  double width_ = 0;  ///< of a column
  std::vector<double> times_;
  std::vector<Band> bands_;
};

}  // namespace feedscope::ui

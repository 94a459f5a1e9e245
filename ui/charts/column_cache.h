#pragma once

#include <functional>
#include <span>
#include <vector>

#include "core/analysis/envelope/envelope.h"
#include "ui/charts/value_fit.h"

namespace feedscope::ui {

/// The pixel columns of one run in the charts. What stays in sight when the range moves by whole columns is
/// not asked for again, so that panning costs only what comes into sight.
class ColumnCache {
 public:
  /// Time at a position along the abscissa [s], never falling.
  using TimeAt = std::function<double(double)>;
  /// One band for each pair of neighbours in `times` [s].
  using BandsOf = std::function<std::vector<Band>(std::span<const double>)>;

  /// Brings `count` columns over `range` up to date.
  void update(const BandsOf& bands_of, const Interval& range, int count, const TimeAt& time_at);
  /// The same of a run, whose columns are empty beyond its `end` [s]. `rapids`: whether they are in the
  /// columns.
  void update(const Envelope& envelope, double end, const Interval& range, int count, const TimeAt& time_at,
              bool rapids = true);
  /// Another run or abscissa, or rapids that were not in the columns before.
  void clear();

  const std::vector<Band>& bands() const { return bands_; }
  /// Of the columns' borders, one more than columns [s].
  const std::vector<double>& times() const { return times_; }

 private:
  int shift_to(const Interval& range, int count) const;

  double start_ = 0;  ///< position of the first border
  double width_ = 0;  ///< of a column
  std::vector<double> times_;
  std::vector<Band> bands_;
};

}  // namespace feedscope::ui

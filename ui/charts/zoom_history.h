#pragma once

#include <array>
#include <optional>
#include <vector>

#include "ui/charts/chart_spec.h"
#include "ui/charts/value_fit.h"

namespace feedscope::ui {

/// What the charts show.
struct ChartView {
  Interval time;                                                 ///< [s]
  std::array<std::optional<Interval>, chart_count> values = {};  ///< ordinates that the user chose

  bool operator==(const ChartView&) const = default;
};

/// The views that the user came to rest at, to go back to and forward again.
class ZoomHistory {
 public:
  /// Another run: begins again.
  void start(const ChartView& view);
  /// The user rests at a view; what lay ahead is forgotten if it is a new one.
  void rest(const ChartView& view);
  const ChartView& current() const { return views_[at_]; }
  bool can_go_back() const { return at_ > 0; }
  bool can_go_forward() const { return at_ + 1 < views_.size(); }
  /// The view to show; only if can_go_back().
  const ChartView& back() { return views_[--at_]; }
  /// The view to show; only if can_go_forward().
  const ChartView& forward() { return views_[++at_]; }

 private:
  std::vector<ChartView> views_{ChartView()};
  std::size_t at_ = 0;
};

}  // namespace feedscope::ui

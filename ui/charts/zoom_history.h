#pragma once

#include <array>
#include <optional>
#include <vector>

#include "ui/charts/chart_spec.h"
#include "ui/charts/value_fit.h"

namespace feedscope::ui {

/// Shown range and ordinates of the charts.
struct ChartView {
  Interval time;                                                 ///< [s]
  std::array<std::optional<Interval>, chart_count> values = {};  ///< ordinates chosen by the user

  bool operator==(const ChartView&) const = default;
};

/// Views at which the user stopped, to go back and forward through.
class ZoomHistory {
 public:
  /// Another run: clears the history.
  void start(const ChartView& view);
  /// The user stops at a view; a new one discards the views after it.
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

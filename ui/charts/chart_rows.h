#pragma once

#include <QVBoxLayout>
#include <array>

#include "ui/charts/chart_header.h"
#include "ui/charts/kinematic_chart.h"

namespace feedscope::ui {

/// The charts of a panel, one above the other, each below its header.
struct ChartRows {
  static constexpr int stretch = 3;  ///< of a chart in the layout

  std::array<ChartHeader*, chart_count> headers{};
  std::array<KinematicChart*, chart_count> charts{};

  /// Shows those that `envelope` has values for (null: the ones of every run); the last of them carries the
  /// abscissa, with this title.
  void show(const Envelope* envelope, const QString& abscissa, QVBoxLayout& layout) const;
  /// In the headers, at `state`; null: no values. `actual`: of a machine with drives, else null.
  void show_values(const State* state, const ActualPath* actual) const;
  /// Of velocity, acceleration and jerk.
  void set_limits(const AxisVector<AxisLimits>& limits) const;
};

}  // namespace feedscope::ui

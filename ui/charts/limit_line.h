#pragma once

#include <QString>
#include <optional>
#include <vector>

#include "core/analysis/load/run_load.h"
#include "core/machine/machine.h"
#include "ui/charts/chart_spec.h"

namespace feedscope::ui {

/// A permitted largest magnitude, drawn dashed on the sides of zero that the chart shows.
struct LimitLine {
  double value = 0;  ///< in the chart's unit
  QString label;
  std::optional<std::size_t> axis;  ///< 0 X, 1 Y, 2 Z; none: several share it, or it is of no axis
};

/// Those of the axes, `kind` being one of their limits: one line for all that have the same.
std::vector<LimitLine> limit_lines(const ChartSpec& spec, const AxisVector<AxisLimits>& limits,
                                   double AxisLimits::*kind);

/// Those of the operations in a chart of their quantities, each value once.
std::vector<LimitLine> bound_lines(const ChartSpec& spec, const RunLoad& load);

}  // namespace feedscope::ui

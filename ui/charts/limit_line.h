#pragma once

#include <QColor>
#include <QRectF>
#include <QString>
#include <functional>
#include <optional>
#include <vector>

#include "core/analysis/load/run_load.h"
#include "core/machine/machine.h"
#include "ui/charts/chart_spec.h"
#include "ui/theme/theme.h"

class QPainter;

namespace feedscope::ui {

/// A permitted largest magnitude, drawn dashed on the sides of zero that the chart shows.
struct LimitLine {
  double value = 0;  ///< in the chart's unit
  QString label;
  std::optional<std::size_t> axis;  ///< place in cause_axes; none: several share it, or it is of no axis
};

/// Those of the axes, `kind` being one of their limits: one line for all that have the same.
std::vector<LimitLine> limit_lines(const ChartSpec& spec, const AxisVector<AxisLimits>& limits,
                                   double AxisLimits::*kind);

/// The same of rotary axes.
std::vector<LimitLine> rotary_limit_lines(const ChartSpec& spec, const MachineKinematics& kinematics,
                                          double RotaryAxis::*kind);

/// Those of the operations in a chart of their quantities, each value once.
std::vector<LimitLine> bound_lines(const ChartSpec& spec, const RunLoad& load);

QColor colour_of(const LimitLine& limit, const ThemeColours& colours);
/// Lines without names. `width`: of a line, `height_of`: place of a value [px].
void draw_limit_lines(QPainter& painter, const QRectF& plot, const std::vector<LimitLine>& limits,
                      const ThemeColours& colours, double width,
                      const std::function<double(double)>& height_of);

}  // namespace feedscope::ui

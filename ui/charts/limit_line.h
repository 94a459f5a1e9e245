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
  std::optional<std::size_t> axis;  ///< index in cause_axes; none: shared by several, or not of an axis
};

/// Limits of the axes for the quantity `kind`; axes with an equal limit share one line.
std::vector<LimitLine> limit_lines(const ChartSpec& spec, const AxisVector<AxisLimits>& limits,
                                   double AxisLimits::*kind);

/// Limits of rotary axes in the same form.
std::vector<LimitLine> rotary_limit_lines(const ChartSpec& spec, const MachineKinematics& kinematics,
                                          double RotaryAxis::*kind);

/// Bounds of the operations in a chart of their quantities, each value once.
std::vector<LimitLine> bound_lines(const ChartSpec& spec, const RunLoad& load);

QColor colour_of(const LimitLine& limit, const ThemeColours& colours);
/// Draws lines without names. `width`: of a line, `height_of`: position of a value [px].
void draw_limit_lines(QPainter& painter, const QRectF& plot, const std::vector<LimitLine>& limits,
                      const ThemeColours& colours, double width,
                      const std::function<double(double)>& height_of);

}  // namespace feedscope::ui

#pragma once

#include <QPointF>
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
  std::vector<std::size_t> axes;  ///< indices in cause_axes; none: of all axes, or not of an axis
};

/// Limits of the axes for the quantity `kind`, without labels, each axis by itself.
std::vector<LimitLine> limit_lines(const ChartSpec& spec, const AxisVector<AxisLimits>& limits,
                                   double AxisLimits::*kind);

/// Limits of rotary axes in the same form.
std::vector<LimitLine> rotary_limit_lines(const ChartSpec& spec, const MachineKinematics& kinematics,
                                          double RotaryAxis::*kind);

/// Bounds of the operations in a chart of their quantities, each value once.
std::vector<LimitLine> bound_lines(const ChartSpec& spec, const RunLoad& load);

/// The limits of those axes that `moves`, labelled; equal ones are one line. Other bounds stay as they are.
std::vector<LimitLine> limits_of_moving(const std::vector<LimitLine>& limits,
                                        const std::function<bool(const LimitLine&)>& moves);

/// Draws a line in the colours of its axes. `width`: [px].
void draw_limit_line(QPainter& painter, const QPointF& from, const QPointF& to, const LimitLine& limit,
                     const ThemeColours& colours, double width);
/// Draws lines without names. `width`: of a line, `height_of`: position of a value [px].
void draw_limit_lines(QPainter& painter, const QRectF& plot, const std::vector<LimitLine>& limits,
                      const ThemeColours& colours, double width,
                      const std::function<double(double)>& height_of);

}  // namespace feedscope::ui

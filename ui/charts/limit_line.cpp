#include "ui/charts/limit_line.h"

#include <QCoreApplication>
#include <QPainter>
#include <algorithm>

#include "core/analysis/load/limit_tracker.h"

namespace feedscope::ui {
namespace {

struct LimitLines {
  Q_DECLARE_TR_FUNCTIONS(LimitLines)
};

/// Adds a line, or its name to the previous line if both have the same value.
void add_line(std::vector<LimitLine>& lines, double value, char name, std::size_t place) {
  const QString axis{QChar(name)};
  if (!lines.empty() && lines.back().value == value) {
    lines.back().label += ' ' + axis;
    lines.back().axis.reset();
  } else {
    lines.push_back({value, axis, place});
  }
}

std::vector<LimitLine> labelled(std::vector<LimitLine> lines) {
  for (LimitLine& line : lines) {
    line.label = LimitLines::tr("limit of %1").arg(line.label);
  }
  return lines;
}

}  // namespace

std::vector<LimitLine> limit_lines(const ChartSpec& spec, const AxisVector<AxisLimits>& limits,
                                   double AxisLimits::*kind) {
  std::vector<LimitLine> lines;
  for (std::size_t i = 0; i < limits.size(); ++i) {
    add_line(lines, spec.convert(limits[i].*kind), limits.name(i), i);
  }
  return labelled(std::move(lines));
}

std::vector<LimitLine> rotary_limit_lines(const ChartSpec& spec, const MachineKinematics& kinematics,
                                          double RotaryAxis::*kind) {
  std::vector<LimitLine> lines;
  for (const RotaryAxis& axis : kinematics.rotary) {
    add_line(lines, spec.convert(axis.*kind), axis.name, *cause_axes.find(axis.name));
  }
  return labelled(std::move(lines));
}

std::vector<LimitLine> bound_lines(const ChartSpec& spec, const RunLoad& load) {
  std::vector<LimitLine> lines;
  for (std::size_t i = 0; i < load_limit_count; ++i) {
    const auto limit = static_cast<LoadLimit>(i);
    const QuantityId id = load_quantities()[quantity_of(limit)].id;
    if (std::ranges::find(spec.curves, id, &CurveSpec::quantity) == spec.curves.end()) {
      continue;
    }
    for (const LoadedOperation& operation : load.model().operations()) {
      const std::optional<double> bound = bound_of(limit, operation.operation);
      const double value = bound ? spec.convert(*bound) : 0;
      const QString label =
          limit == LoadLimit::least_chip ? LimitLines::tr("least chip") : LimitLines::tr("bound");
      if (bound && std::ranges::find(lines, value, &LimitLine::value) == lines.end()) {
        lines.push_back({value, label, std::nullopt});
      }
    }
  }
  return lines;
}

QColor colour_of(const LimitLine& limit, const ThemeColours& colours) {
  return limit.axis ? colours.axes[*limit.axis % colours.axes.size()] : colours.shared;
}

void draw_limit_lines(QPainter& painter, const QRectF& plot, const std::vector<LimitLine>& limits,
                      const ThemeColours& colours, double width,
                      const std::function<double(double)>& height_of) {
  for (const LimitLine& limit : limits) {
    painter.setPen(QPen(colour_of(limit, colours), width, Qt::DashLine));
    for (const double value : {limit.value, -limit.value}) {
      painter.drawLine(QPointF(plot.left(), height_of(value)), QPointF(plot.right(), height_of(value)));
    }
  }
}

}  // namespace feedscope::ui

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

}  // namespace

std::vector<LimitLine> limit_lines(const ChartSpec& spec, const AxisVector<AxisLimits>& limits,
                                   double AxisLimits::*kind) {
  std::vector<LimitLine> lines;
  for (std::size_t i = 0; i < limits.size(); ++i) {
    lines.push_back({spec.convert(limits[i].*kind), {}, {i}});
  }
  return lines;
}

std::vector<LimitLine> rotary_limit_lines(const ChartSpec& spec, const MachineKinematics& kinematics,
                                          double RotaryAxis::*kind) {
  std::vector<LimitLine> lines;
  for (const RotaryAxis& axis : kinematics.rotary) {
    lines.push_back({spec.convert(axis.*kind), {}, {*cause_axes.find(axis.name)}});
  }
  return lines;
}

std::vector<LimitLine> limits_of_moving(const std::vector<LimitLine>& limits,
                                        const std::function<bool(const LimitLine&)>& moves) {
  std::vector<LimitLine> lines;
  for (const LimitLine& limit : limits) {
    if (!limit.axes.empty() && !moves(limit)) {
      continue;
    }
    const auto same = std::ranges::find_if(lines, [&](const LimitLine& line) {
      return line.value == limit.value && !line.axes.empty() && !limit.axes.empty();
    });
    if (same == lines.end()) {
      lines.push_back(limit);
    } else {
      same->axes.insert(same->axes.end(), limit.axes.begin(), limit.axes.end());
    }
  }
  for (LimitLine& line : lines) {
    QStringList names;
    for (const std::size_t axis : line.axes) {
      names.append(QChar(cause_axes[axis].name));
    }
    line.label = names.isEmpty() ? line.label : LimitLines::tr("limit of %1").arg(names.join(' '));
  }
  if (lines.size() == 1 && lines.front().axes.size() > 1) {
    lines.front().axes.clear();
  }
  return lines;
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
        lines.push_back({value, label, {}});
      }
    }
  }
  return lines;
}

void draw_limit_line(QPainter& painter, const QPointF& from, const QPointF& to, const LimitLine& limit,
                     const ThemeColours& colours, double width) {
  QPen pen(colours.shared, width, Qt::DashLine);
  if (limit.axes.empty()) {
    painter.setPen(pen);
    painter.drawLine(from, to);
  }
  constexpr double dash = 6;  // with its gap, in widths of the line
  const double period = dash * static_cast<double>(limit.axes.size());
  for (std::size_t i = 0; i < limit.axes.size(); ++i) {  // dashes of one axis after the other
    pen.setColor(colours.axes[limit.axes[i] % colours.axes.size()]);
    if (limit.axes.size() > 1) {
      constexpr double drawn = 4;
      pen.setDashPattern({drawn, period - drawn});
      pen.setDashOffset(period - dash * static_cast<double>(i));
      pen.setCapStyle(Qt::FlatCap);
    }
    painter.setPen(pen);
    painter.drawLine(from, to);
  }
}

void draw_limit_lines(QPainter& painter, const QRectF& plot, const std::vector<LimitLine>& limits,
                      const ThemeColours& colours, double width,
                      const std::function<double(double)>& height_of) {
  for (const LimitLine& limit : limits) {
    for (const double value : {limit.value, -limit.value}) {
      draw_limit_line(painter, QPointF(plot.left(), height_of(value)),
                      QPointF(plot.right(), height_of(value)), limit, colours, width);
    }
  }
}

}  // namespace feedscope::ui

#include "ui/charts/limit_line.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>

#include "core/analysis/load/limit_tracker.h"
#include "ui/theme/type_size.h"

namespace feedscope::ui {
namespace {

struct LimitLines {
  Q_DECLARE_TR_FUNCTIONS(LimitLines)
};

/// Next to the one before where both have the same value.
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

QFont chart_note_font(QFont font) {
  font.setPixelSize(type_pixels(10));
  return font;
}

double room_for_names(const std::vector<LimitLine>& limits, const Interval& values, const QFont& font,
                      double plot) {
  const double wanted = QFontMetricsF(chart_note_font(font)).height() + 2;
  double highest = values.lower;
  for (const LimitLine& limit : limits) {
    highest = limit.value < values.upper ? std::max(highest, limit.value) : highest;
  }
  if (!(highest > values.lower) || plot < 2 * wanted) {
    return 0;
  }
  // (upper - highest) / (upper - lower) * plot = wanted
  const double share = wanted / plot;
  const double upper = (highest - share * values.lower) / (1 - share);
  return std::max(0.0, upper - values.upper);
}

void draw_limit_lines(QPainter& painter, const QRectF& plot, const std::vector<LimitLine>& limits,
                      const ThemeColours& colours, const QFont& font,
                      const std::function<double(double)>& height_of) {
  painter.setFont(chart_note_font(font));
  const QFontMetricsF metrics(painter.font());
  QColor behind = colours.plot;
  behind.setAlpha(230);
  double label_right = plot.right() - 4;
  double highest = plot.bottom();  // of the limits that are seen: their names are above it, where no curve is
  for (const LimitLine& limit : limits) {
    const double top = height_of(limit.value);
    highest = top > plot.top() && top < highest ? top : highest;
  }
  const double above = highest - metrics.height() - 1;
  for (const LimitLine& limit : limits) {
    const double top = height_of(limit.value);
    const double bottom = height_of(-limit.value);
    painter.setPen(
        QPen(limit.axis ? colours.axes[*limit.axis % colours.axes.size()] : colours.shared, 1, Qt::DashLine));
    painter.drawLine(QPointF(plot.left(), top), QPointF(plot.right(), top));
    painter.drawLine(QPointF(plot.left(), bottom), QPointF(plot.right(), bottom));
    if (top > plot.top() && top < plot.bottom()) {
      const double width = metrics.horizontalAdvance(limit.label);
      const double label_top = above >= plot.top() ? above : top + 1;
      const QRectF label(label_right - width, label_top, width, metrics.height());
      painter.fillRect(label.adjusted(-2, 1, 2, -1), behind);
      painter.drawText(label, Qt::AlignCenter, limit.label);
      label_right -= width + 12;
    }
  }
}

}  // namespace feedscope::ui

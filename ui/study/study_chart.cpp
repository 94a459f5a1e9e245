#include "ui/study/study_chart.h"

#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/base/ticks.h"
#include "ui/language/core_texts.h"
#include "ui/language/shown_numbers.h"
#include "ui/language/texts.h"
#include "ui/shared/plot_grid.h"
#include "ui/shared/plot_text.h"
#include "ui/study/study_marks.h"
#include "ui/theme/theme.h"
#include "ui/theme/type_size.h"

namespace feedscope::ui {
namespace {

constexpr int text_size = 12;
constexpr int title_size = 15;
constexpr double margin = 14;
constexpr double tick_room = 58;
constexpr double gap = 26;
constexpr double marker = 4.5;
constexpr double near_marker = 9;

QFont sized(QFont font, int pixels, bool bold = false) {
  font.setPixelSize(pixels);
  font.setBold(bold);
  return font;
}

QString number(double value, int digits) {
  return QLocale().toString(value, 'g', digits);
}

bool strikes(const QLineF& line, const QRectF& label) {
  const std::array<QPointF, 4> corners{label.topLeft(), label.topRight(), label.bottomRight(),
                                       label.bottomLeft()};
  bool crosses = label.contains(line.p1()) || label.contains(line.p2());
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const QLineF side(corners[i], corners[(i + 1) % corners.size()]);
    crosses = crosses || side.intersects(line) == QLineF::BoundedIntersection;
  }
  return crosses;
}

GridLook grid_look(const QPalette& palette) {
  const ThemeColours& colours = theme_colours(palette);
  return {colours.grid, colours.frame, colours.text};
}

/// 1, 2 and 5 times powers of ten in [from, to].
std::vector<double> log_ticks(double from, double to) {
  std::vector<double> ticks;
  for (double tick = round_up_125(from * (1 - 1e-9)); tick <= to * (1 + 1e-9);
       tick = round_up_125(tick * 1.01)) {
    ticks.push_back(tick);
  }
  return ticks;
}

}  // namespace

/// Plots one above the other over one axis.
struct StudyChart::Layout {
  QRectF head;
  std::vector<QRectF> legend;
  QRectF time;
  QRectF error;
  double from = 0;  ///< of the setting, or its logarithm on a logarithmic axis
  double to = 1;
  bool logarithmic = false;
  double min_time = 0;
  double max_time = 1;
  double max_error = 1;  ///< [mm]

  double x(double value) const {
    const double at = logarithmic ? std::log(value) : value;
    return time.left() + (to > from ? (at - from) / (to - from) : 0.5) * time.width();
  }
  double y(double value, bool is_error) const {
    const QRectF& plot = is_error ? error : time;
    const double share = is_error ? value / max_error : (value - min_time) / (max_time - min_time);
    return plot.bottom() - share * plot.height();
  }
  QPointF place(const StudyPoint& point, bool is_error) const {
    return {x(point.value), y(is_error ? point.error : point.time, is_error)};
  }
};

StudyChart::StudyChart(QWidget* parent) : QWidget(parent) {
  setFont(sized(font(), text_size));
}

void StudyChart::set_study(const QString& title, const QString& details, StudyCurves study) {
  title_ = title;
  details_ = details;
  study_ = std::move(study);
  update();
}

void StudyChart::set_recorded(std::vector<RecordedTime> recorded) {
  study_.recorded = std::move(recorded);
  update();
}

double StudyChart::height_of_times() const {
  const Layout layout = lay_out();
  double low = layout.time.bottom();
  double high = layout.time.top();
  for (const StudyCurve& curve : study_.curves) {
    for (const StudyPoint& point : curve.points) {
      const double y = layout.place(point, false).y();
      low = std::min(low, y);
      high = std::max(high, y);
    }
  }
  return std::max(0.0, high - low) / layout.time.height();
}

QSize StudyChart::minimumSizeHint() const {
  return {420, 320};
}

QSize StudyChart::sizeHint() const {
  return {960, 640};
}

StudyChart::Layout StudyChart::lay_out() const {
  Layout layout;
  layout.logarithmic = study_.logarithmic;
  const QFontMetricsF metrics(font());
  const double line = metrics.height();
  layout.head =
      QRectF(margin, margin - 4, width() - 2 * margin, QFontMetricsF(sized(font(), title_size)).height());
  std::vector<double> widths;
  for (const StudyCurve& curve : study_.curves) {
    widths.push_back(metrics.horizontalAdvance(curve.name) + 34);
  }
  const QRectF legend(margin, layout.head.bottom() + 6, width() - 2 * margin, line);
  layout.legend = entries_in_rows(widths, legend, line, line + 2, 0);
  const double y = layout.legend.empty() ? legend.top() : layout.legend.back().top();
  const double top = y + (study_.curves.empty() ? 0 : line) + line + 12;
  const double bottom = height() - margin - 2 * line - 8;
  const double room = std::max(bottom - top - line - gap, 40.0);
  const double left = margin + tick_room;
  layout.time = QRectF(left, top, std::max(width() - left - 2 * margin, 40.0), room * 0.5);
  layout.error = QRectF(left, layout.time.bottom() + gap + line, layout.time.width(), room * 0.5);
  double from = std::numeric_limits<double>::infinity();
  double to = -from;
  double time = 0;
  double least = std::numeric_limits<double>::infinity();
  double error = study_.within.value_or(0);
  for (const StudyCurve& curve : study_.curves) {
    for (const StudyPoint& point : curve.points) {
      const double at = layout.logarithmic ? std::log(point.value) : point.value;
      from = std::min(from, at);
      to = std::max(to, at);
      time = std::max(time, point.time);
      least = std::min(least, point.time);
      error = std::max(error, point.error);
    }
  }
  for (const RecordedTime& recorded : study_.recorded) {
    time = std::max(time, recorded.time);
    least = std::min(least, recorded.time);
    error = std::max(error, recorded.error);
  }
  if (from <= to) {
    const double pad = (to - from) * 0.04;
    layout.from = from - pad;
    layout.to = to + pad;
  }
  constexpr double head_room = 1.08;
  layout.max_time = time > 0 ? time * head_room : 1;
  constexpr double worth_zero =
      0.5;  // of the longest time: where all are above it, an axis from 0 would be flat
  if (time > 0 && least > worth_zero * time) {
    constexpr double min_span = 1e-3;  // of the time: smaller differences appear level
    const double span = std::max(time - least, min_span * time);
    const double middle = (time + least) / 2;
    layout.min_time = middle - (head_room - 0.5 + 0.1) * span;
    layout.max_time = middle + (head_room - 0.5 + 0.1) * span;
  }
  layout.max_error = error > 0 ? error * head_room : 1e-3;
  return layout;
}

void StudyChart::paintEvent(QPaintEvent*) {
  const Layout layout = lay_out();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), theme_colours(palette()).plot);
  if (study_.curves.empty()) {  // empty axes would be misleading
    painter.setFont(font());
    painter.setPen(theme_colours(palette()).muted);
    painter.drawText(
        rect().adjusted(margin, margin, -margin, -margin), Qt::AlignCenter | Qt::TextWordWrap,
        tr("Cycle time and contour error over a setting: choose it and its range, then press Study."));
    return;
  }
  draw_head(painter, layout);
  draw_settings_axis(painter, layout);
  draw_plot(painter, layout, false);
  draw_plot(painter, layout, true);
}

void StudyChart::draw_head(QPainter& painter, const Layout& layout) const {
  painter.setFont(font());
  painter.setPen(theme_colours(palette()).text);
  paint_title(painter, layout.head, title_, details_);
  for (std::size_t i = 0; i < layout.legend.size(); ++i) {
    const QRectF& entry = layout.legend[i];
    const QColor color = study_hue(i, palette());
    painter.setPen(QPen(color, line_pixels(2)));
    painter.drawLine(QPointF(entry.left(), entry.center().y()),
                     QPointF(entry.left() + 18, entry.center().y()));
    painter.fillPath(study_marker(i, QPointF(entry.left() + 9, entry.center().y()), marker), color);
    painter.setPen(theme_colours(palette()).text);
    painter.drawText(entry.adjusted(23, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter, study_.curves[i].name);
  }
}

QString StudyChart::bound_text() const {
  return tr("bound %1").arg(significant_text(*study_.within, Dimension::error, 3));
}

QRectF StudyChart::bound_label(const Layout& layout) const {
  const QFontMetricsF metrics(font());
  const double y = layout.y(*study_.within, true);
  return {layout.error.left() + 6, y - metrics.height() - 2, metrics.horizontalAdvance(bound_text()) + 4,
          metrics.height()};
}

void StudyChart::draw_plot(QPainter& painter, const Layout& layout, bool is_error) const {
  const QRectF& plot = is_error ? layout.error : layout.time;
  const double most = is_error ? in_shown_unit(layout.max_error, Dimension::error) : layout.max_time;
  const double least = is_error ? 0 : layout.min_time;
  const double line = QFontMetricsF(font()).height();
  constexpr int max_ticks = 6;
  Ticks ticks;
  for (int count = max_ticks; count > 1; --count) {
    ticks = is_error ? round_ticks(least, most, count) : clock_ticks(least, most, count);
    if (ticks.step * plot.height() > line * (most - least)) {  // else labels would be left out
      break;
    }
  }
  painter.setFont(sized(font(), text_size, true));
  painter.setPen(theme_colours(palette()).text);
  painter.drawText(
      QRectF(margin, plot.top() - line - 6, plot.right() - margin, line), Qt::AlignLeft | Qt::AlignVCenter,
      is_error
          ? with_unit_of(study_.actual ? tr("Largest actual contour error") : tr("Largest contour error"),
                         Dimension::error)
          : time_scale_title(tr("Cycle time"), ticks));
  painter.setFont(font());
  PlotGrid grid(painter, plot, grid_look(palette()));
  for (std::size_t i = 0; i < ticks.values.size(); ++i) {
    grid.level(plot.bottom() - (ticks.values[i] - least) / (most - least) * plot.height(),
               is_error ? tick_text(ticks, i) : time_tick_text(ticks, i),
               ticks.values[i] == 0 ? GridLine::strong : GridLine::usual);
  }
  if (is_error && study_.within) {
    const double y = layout.y(*study_.within, true);
    painter.setPen(QPen(theme_colours(palette()).text, line_pixels(1.4), Qt::DashLine));
    painter.drawLine(QPointF(plot.left(), y), QPointF(plot.right(), y));
    painter.drawText(bound_label(layout), Qt::AlignLeft | Qt::AlignVCenter, bound_text());
  }
  draw_recorded(painter, layout, is_error);
  for (std::size_t i = 0; i < study_.curves.size(); ++i) {
    draw_curve(painter, layout, i, is_error);
  }
  draw_labels(painter, layout, is_error);
}

QString StudyChart::recorded_text(std::size_t index, bool is_error) const {
  const RecordedTime& recorded = study_.recorded[index];
  return tr("%1: %2").arg(recorded.name, is_error ? significant_text(recorded.error, Dimension::error, 3)
                                                  : clock_text(recorded.time));
}

std::vector<QLineF> StudyChart::curve_lines(const Layout& layout, bool is_error) const {
  std::vector<QLineF> lines;
  for (const StudyCurve& curve : study_.curves) {
    for (std::size_t i = 1; i < curve.points.size(); ++i) {
      lines.emplace_back(layout.place(curve.points[i - 1], is_error),
                         layout.place(curve.points[i], is_error));
    }
  }
  return lines;
}

std::vector<QRectF> StudyChart::recorded_labels(const Layout& layout, bool is_error) const {
  const QFontMetricsF metrics(font());
  const QRectF& plot = is_error ? layout.error : layout.time;
  const std::vector<QLineF> lines = curve_lines(layout, is_error);
  std::vector<QRectF> taken;
  if (is_error && study_.within) {
    taken.push_back(bound_label(layout));
  }
  std::vector<QRectF> labels;
  for (std::size_t i = 0; i < study_.recorded.size(); ++i) {
    const RecordedTime& recorded = study_.recorded[i];
    const double level = layout.y(is_error ? recorded.error : recorded.time, is_error);
    const QSizeF size(metrics.horizontalAdvance(recorded_text(i, is_error)) + 4, metrics.height());
    QRectF best;
    auto least = std::numeric_limits<std::ptrdiff_t>::max();
    for (const double top : {level - size.height() - 2, level + 2}) {
      for (const double share : {1.0, 0.75, 0.5, 0.25, 0.0}) {
        const QRectF label(
            QPointF(plot.left() + 4 + share * std::max(0.0, plot.width() - size.width() - 8), top), size);
        constexpr std::ptrdiff_t worse = 100;
        const std::ptrdiff_t faults =
            std::ranges::count_if(lines, [&](const QLineF& line) { return strikes(line, label); }) +
            worse *
                std::ranges::count_if(taken, [&](const QRectF& other) { return other.intersects(label); }) +
            (plot.contains(label) ? 0 : worse);
        if (faults < least) {
          least = faults;
          best = label;
        }
      }
    }
    labels.push_back(best);
    taken.push_back(best);
  }
  return labels;
}

void StudyChart::draw_recorded(QPainter& painter, const Layout& layout, bool is_error) const {
  const std::vector<QRectF> labels = recorded_labels(layout, is_error);
  for (std::size_t i = 0; i < study_.recorded.size(); ++i) {
    const RecordedTime& recorded = study_.recorded[i];
    const double y = layout.y(is_error ? recorded.error : recorded.time, is_error);
    painter.setPen(QPen(recorded.colour, line_pixels(1.6), Qt::DotLine));
    painter.drawLine(QPointF(layout.time.left(), y), QPointF(layout.time.right(), y));
    painter.setPen(theme_colours(palette()).text);
    painter.drawText(labels[i], Qt::AlignCenter, recorded_text(i, is_error));
  }
}

void StudyChart::draw_curve(QPainter& painter, const Layout& layout, std::size_t index, bool is_error) const {
  const StudyCurve& curve = study_.curves[index];
  const QColor color = study_hue(index, palette());
  QPolygonF line;
  for (const StudyPoint& point : curve.points) {
    line.append(layout.place(point, is_error));
  }
  painter.setPen(QPen(color, line_pixels(1.8)));
  painter.drawPolyline(line);
  for (const QPointF& at : line) {
    painter.fillPath(study_marker(index, at, marker), color);
  }
  painter.setPen(QPen(theme_colours(palette()).text, line_pixels(1.8)));
  painter.setBrush(Qt::NoBrush);
  for (const std::size_t best : curve.best) {
    painter.drawEllipse(line[static_cast<qsizetype>(best)], 2 * marker, 2 * marker);
  }
}

QRectF StudyChart::free_label(const Layout& layout, const QPointF& at, const QSizeF& size, bool is_error,
                              const std::vector<QRectF>& taken) const {
  const QRectF& plot = is_error ? layout.error : layout.time;
  std::vector<QLineF> lines = curve_lines(layout, is_error);
  if (is_error && study_.within) {
    const double y = bound_label(layout).bottom() + 2;
    lines.emplace_back(plot.left(), y, plot.right(), y);
  }
  for (const RecordedTime& recorded : study_.recorded) {
    const double y = layout.y(is_error ? recorded.error : recorded.time, is_error);
    lines.emplace_back(plot.left(), y, plot.right(), y);
  }
  QRectF best;
  int least = std::numeric_limits<int>::max();
  for (const double rows : {-1.2, 0.2, -2.2, 1.2, -0.5, -3.2, 2.2}) {
    for (const double left : {at.x() + 3 * marker, at.x() - 3 * marker - size.width()}) {
      const double below = rows > 0 ? 2 * marker : 0;
      const QRectF label(QPointF(left, at.y() + rows * size.height() + below), size);
      constexpr int out_of_plot = 1000;
      constexpr int on_a_label = 100;
      int faults = plot.contains(label) ? 0 : out_of_plot;
      for (const QRectF& other : taken) {
        faults += other.intersects(label) ? on_a_label : 0;
      }
      for (const QLineF& line : lines) {
        faults += strikes(line, label) ? 1 : 0;
      }
      if (faults < least) {
        least = faults;
        best = label;
      }
    }
  }
  return best;
}

void StudyChart::draw_labels(QPainter& painter, const Layout& layout, bool is_error) const {
  const QFontMetricsF metrics(font());
  std::vector<QRectF> taken;
  if (is_error && study_.within) {
    taken.push_back(bound_label(layout));
  }
  for (const QRectF& label : recorded_labels(layout, is_error)) {
    taken.push_back(label);
  }
  for (const StudyCurve& curve : study_.curves) {
    if (curve.best.empty()) {
      continue;
    }
    const StudyPoint& best = curve.points[curve.best.front()];
    const QString text =
        is_error ? significant_text(best.error, Dimension::error, 3)
                 : tr("%1 at %2")
                       .arg(clock_text(best.time),
                            QStringLiteral("%1 %2").arg(number(best.value, 3), study_.unit).trimmed());
    const QSizeF size(metrics.horizontalAdvance(text) + 4, metrics.height());
    const QRectF label = free_label(layout, layout.place(best, is_error), size, is_error, taken);
    QColor behind = theme_colours(palette()).plot;
    behind.setAlpha(210);
    painter.fillRect(label, behind);
    painter.setPen(theme_colours(palette()).text);
    painter.drawText(label, Qt::AlignCenter, text);
    taken.push_back(label);
  }
}

void StudyChart::draw_settings_axis(QPainter& painter, const Layout& layout) const {
  const double line = QFontMetricsF(font()).height();
  painter.setFont(font());
  const QRectF& plot = layout.error;
  std::vector<double> ticks;
  if (layout.logarithmic) {
    ticks = log_ticks(std::exp(layout.from), std::exp(layout.to));
  } else {
    ticks = round_ticks(layout.from, layout.to, 8).values;
  }
  PlotGrid grid(painter, plot, grid_look(palette()));
  grid.share(layout.time);
  for (const double tick : ticks) {
    grid.upright(layout.x(tick), number(tick, 4));
  }
  painter.setPen(theme_colours(palette()).text);
  painter.drawText(
      QRectF(plot.left(), plot.bottom() + 8 + line, plot.width(), line), Qt::AlignCenter,
      study_.unit.isEmpty() ? study_.title : QStringLiteral("%1 [%2]").arg(study_.title, study_.unit));
}

std::optional<StudyChart::Hit> StudyChart::run_at(const QPointF& place) const {
  const Layout layout = lay_out();
  std::optional<Hit> nearest;
  double least = near_marker;
  for (std::size_t c = 0; c < study_.curves.size(); ++c) {
    for (std::size_t p = 0; p < study_.curves[c].points.size(); ++p) {
      for (const bool is_error : {false, true}) {
        const double distance = QLineF(layout.place(study_.curves[c].points[p], is_error), place).length();
        if (distance <= least) {
          least = distance;
          nearest = Hit{c, p};
        }
      }
    }
  }
  return nearest;
}

void StudyChart::mousePressEvent(QMouseEvent* event) {
  if (const std::optional<Hit> hit = run_at(event->position())) {
    emit run_clicked(hit->curve, hit->point);
  }
  QWidget::mousePressEvent(event);
}

}  // namespace feedscope::ui

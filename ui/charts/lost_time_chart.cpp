#include "ui/charts/lost_time_chart.h"

#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "core/base/ticks.h"
#include "ui/charts/plot_margins.h"
#include "ui/language/signed_number.h"
#include "ui/shared/plot_grid.h"
#include "ui/theme/theme.h"
#include "ui/theme/type_size.h"

namespace feedscope::ui {

namespace {

constexpr int below = 4;
constexpr double curve_width = 1.8;
constexpr int most_ticks = 3;

int head_height() {
  return type_pixels(18);
}

int plot_height() {
  return type_pixels(38);
}

/// Linear between the samples, constant beyond them.
double value_at(const std::vector<double>& times, const std::vector<double>& values, double time) {
  const auto after = std::ranges::lower_bound(times, time);
  if (after == times.begin()) {
    return values.front();
  }
  if (after == times.end()) {
    return values.back();
  }
  const auto i = static_cast<std::size_t>(after - times.begin());
  const double span = times[i] - times[i - 1];
  return std::lerp(values[i - 1], values[i], span > 0 ? (time - times[i - 1]) / span : 1);
}

}  // namespace

LostTimeChart::LostTimeChart(const ViewRange& range, QWidget* parent) : QWidget(parent), range_(range) {
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  setAccessibleName(tr("Time lost against other runs"));
  setToolTip(
      tr("Time that the current run has lost against the others since the start, at the same place of the "
         "path; below 0 it is ahead"));
  hide();
}

void LostTimeChart::show_runs(const std::shared_ptr<const Trajectory>& run,
                              const std::vector<RunOverlay>& others, const std::vector<double>& times) {
  if (off_ || run == nullptr || others.empty() || times.size() < 2) {
    job_.cancel();
    set_lost({});
    return;
  }
  LostTimes at;
  const auto columns = static_cast<double>(times.size() - 1);
  for (std::size_t i = 0; i < times.size() && (i < 2 || times[i - 1] < run->duration()); ++i) {
    at.times.push_back(times[i]);
    at.positions.push_back(std::lerp(range_.lower(), range_.upper(), static_cast<double>(i) / columns));
  }
  job_.start(
      [run, others, at](JobControl& control) { return lost_times(*run, others, at, &control.progress); },
      [this](const JobOutcome<LostTimes>& outcome) {
        if (outcome.result) {
          set_lost(*outcome.result);
        }
      });
}

void LostTimeChart::set_lost(LostTimes lost) {
  lost_ = std::move(lost);
  setVisible(has_room_ && !lost_.others.empty());
  update();
}

void LostTimeChart::set_room(bool room) {
  has_room_ = room;
  setVisible(has_room_ && !lost_.others.empty());
}

void LostTimeChart::set_cursor(std::optional<double> position, std::optional<double> time) {
  cursor_ = position;
  cursor_time_ = time;
  update();
}

QString LostTimeChart::value_text(std::size_t other) const {
  const std::vector<double>& lost = lost_.others[other].lost;
  const bool at_cursor =
      cursor_time_ && *cursor_time_ >= lost_.times.front() && *cursor_time_ <= lost_.times.back();
  const double value = at_cursor ? value_at(lost_.times, lost, *cursor_time_) : lost.back();
  return tr("%1 s").arg(signed_number(value, 3));
}

Interval LostTimeChart::values() const {
  Interval values;
  for (const LostTime& other : lost_.others) {
    const auto [least, most] = std::ranges::minmax(other.lost);
    values.lower = std::min(values.lower, least);
    values.upper = std::max(values.upper, most);
  }
  constexpr double least_span = 1e-3;  // [s]
  constexpr double room = 0.06;
  const double span = std::max(values.width(), least_span);
  return {values.lower - room * span, std::max(values.upper, values.lower + least_span) + room * span};
}

QSize LostTimeChart::sizeHint() const {
  return {400, head_height() + plot_height() + below};
}

QRectF LostTimeChart::plot() const {
  return QRectF(rect()).adjusted(plot_left_margin(), head_height(), -plot_right_margin, -below);
}

void LostTimeChart::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  draw(painter);
}

void LostTimeChart::draw(QPainter& painter) const {
  painter.setRenderHint(QPainter::Antialiasing);
  draw_head(painter);
  painter.fillRect(QRectF(0, head_height(), width(), height() - head_height()),
                   theme_colours(palette()).plot);
  if (!lost_.others.empty() && !lost_.positions.empty()) {
    draw_curves(painter);
  }
}

void LostTimeChart::draw_head(QPainter& painter) const {
  const int gap = type_pixels(14);
  const int swatch = type_pixels(14);
  const QColor text = palette().color(QPalette::WindowText);
  QFont bold = font();
  bold.setBold(true);
  painter.setFont(bold);
  painter.setPen(text);
  const QString title = tr("Time lost against");
  painter.drawText(QRect(type_pixels(8), 0, width(), head_height()), Qt::AlignLeft | Qt::AlignVCenter, title);
  int x = type_pixels(8) + QFontMetrics(bold).horizontalAdvance(title) + gap;
  painter.setFont(font());
  const QFontMetrics metrics(font());
  for (std::size_t i = 0; i < lost_.others.size(); ++i) {
    const QString entry = QStringLiteral("%1  %2").arg(lost_.others[i].name, value_text(i));
    const int room = width() - plot_right_margin - x - swatch - 4;
    if (room < metrics.height()) {
      return;
    }
    painter.setPen(QPen(lost_.others[i].color, line_pixels(3, *this)));
    painter.drawLine(x, head_height() / 2, x + swatch, head_height() / 2);
    painter.setPen(text);
    const QString shown = metrics.elidedText(entry, Qt::ElideMiddle, room);
    painter.drawText(QRect(x + swatch + 4, 0, room, head_height()), Qt::AlignLeft | Qt::AlignVCenter, shown);
    x += swatch + 4 + metrics.horizontalAdvance(shown) + gap;
  }
}

void LostTimeChart::draw_curves(QPainter& painter) const {
  const ThemeColours& colours = theme_colours(palette());
  const QRectF area = plot();
  const Interval ordinate = values();
  const double per_position = area.width() / std::max(range_.upper() - range_.lower(), 1e-12);
  const auto x_of = [&](double position) { return area.left() + (position - range_.lower()) * per_position; };
  const auto y_of = [&](double value) {
    return area.bottom() - (value - ordinate.lower) / ordinate.width() * area.height();
  };
  QFont small = font();
  small.setPixelSize(type_pixels(11));
  painter.setFont(small);
  {
    PlotGrid grid(painter, area, {colours.grid, colours.frame, colours.text});
    const Ticks ticks = round_ticks(ordinate.lower, ordinate.upper, most_ticks);
    for (std::size_t i = 0; i < ticks.values.size(); ++i) {
      const bool zero = std::abs(ticks.values[i]) < 1e-9 * ticks.step;
      grid.level(y_of(ticks.values[i]), tick_text(ticks, i), zero ? GridLine::strong : GridLine::usual);
    }
  }
  painter.setClipRect(area);
  for (const LostTime& other : lost_.others) {
    QPolygonF line;
    for (std::size_t i = 0; i < lost_.positions.size(); ++i) {
      line.append({x_of(lost_.positions[i]), y_of(other.lost[i])});
    }
    painter.setPen(
        QPen(other.color, line_pixels(curve_width, *this), Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin));
    painter.drawPolyline(line);
  }
  if (cursor_ && *cursor_ >= range_.lower() && *cursor_ <= range_.upper()) {
    painter.setPen(QPen(colours.cursor, line_pixels(1, *this)));
    const double x = std::round(x_of(*cursor_));
    painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
  }
  painter.setClipping(false);
}

}  // namespace feedscope::ui

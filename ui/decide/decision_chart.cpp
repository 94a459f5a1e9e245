#include "ui/decide/decision_chart.h"

#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/ticks.h"
#include "ui/language/shown_numbers.h"
#include "ui/language/texts.h"
#include "ui/shared/plot_grid.h"
#include "ui/shared/plot_text.h"
#include "ui/theme/theme.h"
#include "ui/theme/type_size.h"

namespace feedscope::ui {

namespace {

constexpr double dot_radius = 4.5;
constexpr double near_dot = 9;
constexpr double near_bound = 5;
constexpr int usual_height = 136;

}  // namespace

DecisionChart::DecisionChart(QWidget* parent) : QWidget(parent) {
  set_type_pixels(*this, 11);
  setMouseTracking(true);
  setAccessibleName(tr("Cycle time over contour error"));
  setToolTip(tr("A dot is a run; the ringed one is recommended. Click to choose a run."));
}

void DecisionChart::set(std::vector<DecisionDot> dots, std::optional<double> bound) {
  dots_ = std::move(dots);
  bound_ = bound;
  if (!dragging_) {  // the axis is fixed while the bound is dragged along it
    constexpr double head_room = 1.15;
    most_error_ = head_room * bound_.value_or(0);
    for (const DecisionDot& dot : dots_) {
      most_error_ = std::max(most_error_, head_room * dot.error);
    }
  }
  update();
}

QSize DecisionChart::sizeHint() const {
  return {type_pixels(280), type_pixels(usual_height)};
}

QSize DecisionChart::minimumSizeHint() const {
  return {type_pixels(150), type_pixels(usual_height)};
}

DecisionChart::Scale DecisionChart::scale() const {
  const QFontMetricsF metrics(font());
  Scale scale;
  scale.plot = QRectF(rect()).adjusted(type_pixels(52), metrics.height() + 6, -type_pixels(14),
                                       -(2 * metrics.height() + 8));
  scale.most_error = most_error_ > 0 ? most_error_ : 1e-3;
  if (dots_.empty()) {
    return scale;
  }
  const auto [fast, slow] = std::ranges::minmax(dots_, {}, &DecisionDot::time);
  constexpr double min_span = 0.02;  // of the time: smaller differences appear level
  const double span = std::max({slow.time - fast.time, min_span * slow.time, 1e-6});
  const double middle = (slow.time + fast.time) / 2;
  constexpr double room = 0.62;
  scale.least_time = std::max(0.0, middle - room * span);
  scale.most_time = middle + room * span;
  return scale;
}

QPointF DecisionChart::place_of(const DecisionDot& dot) const {
  const Scale at = scale();
  return {at.plot.left() + dot.error / at.most_error * at.plot.width(),
          at.plot.bottom() - (dot.time - at.least_time) / (at.most_time - at.least_time) * at.plot.height()};
}

std::optional<double> DecisionChart::bound_x() const {
  const Scale at = scale();
  return bound_ ? std::optional(at.plot.left() + std::min(1.0, *bound_ / at.most_error) * at.plot.width())
                : std::nullopt;
}

/// For each name the place next to its dot that covers the fewest other dots and names.
std::vector<QRectF> DecisionChart::labels() const {
  const QFontMetricsF metrics(font());
  const QRectF plot = scale().plot;
  const QRectF room(QPointF(plot.left(), 0), QPointF(width(), plot.bottom()));
  std::vector<QRectF> labels;
  for (const DecisionDot& dot : dots_) {
    const QPointF at = place_of(dot);
    const QSizeF size(metrics.horizontalAdvance(dot.name) + 2, metrics.height());
    const double side = 2 * dot_radius;
    std::vector<QPointF> corners;
    for (const int row : {-1, 0, -2, 1, -3, 2, -4, 3}) {  // the nearest places first
      const double top = row < 0 ? row * size.height() - 1 : row * size.height() + 1;
      for (const double left : {side, -side - size.width(), -size.width() / 2}) {
        corners.emplace_back(left, top);
      }
    }
    QRectF best;
    int least = std::numeric_limits<int>::max();
    for (const QPointF& corner : corners) {
      const QRectF label(at + corner, size);
      int faults = room.contains(label) ? 0 : 100;
      for (const QRectF& other : labels) {
        faults += other.intersects(label) ? 20 : 0;
      }
      for (const DecisionDot& other : dots_) {
        const QRectF mark(place_of(other) - QPointF(dot_radius, dot_radius), QSizeF(side, side));
        faults += mark.intersects(label) ? 3 : 0;
      }
      if (const auto x = bound_x(); x && label.left() < *x && label.right() > *x) {
        ++faults;
      }
      if (faults < least) {
        least = faults;
        best = label;
      }
    }
    labels.push_back(best);
  }
  return labels;
}

void DecisionChart::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  draw(painter);
}

void DecisionChart::draw(QPainter& painter) const {
  painter.setFont(font());
  painter.setRenderHint(QPainter::Antialiasing);
  const Scale at = scale();
  draw_axes(painter, at);
  draw_bound(painter, at);
  draw_dots(painter);
}

void DecisionChart::draw_axes(QPainter& painter, const Scale& scale) const {
  const ThemeColours& colours = theme_colours(palette());
  const QFontMetricsF metrics(font());
  PlotGrid grid(painter, scale.plot, {colours.grid, colours.frame, colours.text});
  constexpr double tick_room = 26;  // [px]
  const int rows = std::max(2, static_cast<int>(scale.plot.height() / type_pixels(tick_room)));
  const Ticks times = round_ticks(scale.least_time, scale.most_time, rows);
  for (std::size_t i = 0; i < times.values.size(); ++i) {
    const double share = (times.values[i] - scale.least_time) / (scale.most_time - scale.least_time);
    grid.level(scale.plot.bottom() - share * scale.plot.height(), time_tick_text(times, i));
  }
  const Ticks errors = round_ticks(0, in_shown_unit(scale.most_error, Dimension::error), 5);
  for (std::size_t i = 0; i < errors.values.size(); ++i) {
    const double share = from_shown_unit(errors.values[i], Dimension::error) / scale.most_error;
    grid.upright(scale.plot.left() + share * scale.plot.width(), tick_text(errors, i));
  }
  painter.setPen(colours.text);
  painter.drawText(
      QRectF(scale.plot.left(), height() - metrics.height() - 1, scale.plot.width(), metrics.height()),
      Qt::AlignCenter, with_unit_of(tr("Contour error"), Dimension::error));
  painter.drawText(QRectF(0, 0, width(), metrics.height()), Qt::AlignLeft,
                   time_scale_title(tr("Cycle time"), times));
}

void DecisionChart::draw_bound(QPainter& painter, const Scale& scale) const {
  const auto x = bound_x();
  if (!x) {
    return;
  }
  const ThemeColours& colours = theme_colours(palette());
  painter.setPen(QPen(colours.cursor, line_pixels(1.2), Qt::DashLine));
  painter.drawLine(QPointF(*x, scale.plot.top()), QPointF(*x, scale.plot.bottom()));
  const QString text = tr("bound %1").arg(amount_text(*bound_, Dimension::error));
  const QFontMetricsF metrics(font());
  const double wide = metrics.horizontalAdvance(text);
  const bool right = *x + 4 + wide < width();
  painter.setPen(colours.text);
  painter.drawText(QPointF(right ? *x + 4 : *x - 4 - wide, scale.plot.top() + metrics.ascent() - 2), text);
}

void DecisionChart::draw_dots(QPainter& painter) const {
  const ThemeColours& colours = theme_colours(palette());
  std::vector<const DecisionDot*> by_error;
  for (const DecisionDot& dot : dots_) {
    by_error.push_back(&dot);
  }
  std::ranges::stable_sort(by_error, {}, &DecisionDot::error);
  painter.setPen(QPen(colours.muted, line_pixels(1)));
  for (std::size_t i = 1; i < by_error.size(); ++i) {
    painter.drawLine(place_of(*by_error[i - 1]), place_of(*by_error[i]));
  }
  const std::vector<QRectF> names = labels();
  for (std::size_t i = 0; i < dots_.size(); ++i) {
    const DecisionDot& dot = dots_[i];
    const QPointF at = place_of(dot);
    painter.setPen(Qt::NoPen);
    painter.setBrush(dot.colour);
    painter.drawEllipse(at, dot_radius, dot_radius);
    if (dot.taken) {
      painter.setBrush(Qt::NoBrush);
      painter.setPen(QPen(colours.text, line_pixels(1.6)));
      painter.drawEllipse(at, 1.9 * dot_radius, 1.9 * dot_radius);
    }
    QFont type = font();
    type.setBold(dot.current);
    painter.setFont(type);
    painter.setPen(colours.text);
    painter.drawText(names[i], Qt::AlignCenter | Qt::TextDontClip, dot.name);
  }
  painter.setFont(font());
}

bool DecisionChart::over_bound(const QPointF& place) const {
  const auto x = bound_x();
  const QRectF plot = scale().plot;
  return x && std::abs(place.x() - *x) <= near_bound && place.y() >= plot.top() - near_bound &&
         place.y() <= plot.bottom() + near_bound;
}

void DecisionChart::mousePressEvent(QMouseEvent* event) {
  const DecisionDot* nearest = nullptr;
  double least = near_dot;
  for (const DecisionDot& dot : dots_) {
    const double distance = QLineF(place_of(dot), event->position()).length();
    if (distance <= least) {
      least = distance;
      nearest = &dot;
    }
  }
  if (nearest != nullptr) {
    emit run_clicked(nearest->row);
  } else {
    dragging_ = over_bound(event->position());
  }
}

void DecisionChart::mouseMoveEvent(QMouseEvent* event) {
  if (!dragging_) {
    setCursor(over_bound(event->position()) ? Qt::SplitHCursor : Qt::ArrowCursor);
    return;
  }
  const Scale at = scale();
  const double share = std::clamp((event->position().x() - at.plot.left()) / at.plot.width(), 0.0, 1.0);
  constexpr double step = 1e-4;  // [mm]
  emit bound_dragged(std::max(step, std::round(share * at.most_error / step) * step));
}

void DecisionChart::mouseReleaseEvent(QMouseEvent*) {
  dragging_ = false;
}

}  // namespace feedscope::ui

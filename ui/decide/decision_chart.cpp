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
constexpr double ring_radius = 1.9 * dot_radius;
constexpr double one_place = 0.6 * dot_radius;  // dots nearer to each other look like one
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

QString DecisionChart::bound_text() const {
  return tr("bound %1").arg(amount_text(*bound_, Dimension::error));
}

/// A dot with its ring.
QRectF DecisionChart::mark_of(const DecisionDot& dot) const {
  const double radius = dot.taken ? ring_radius : dot_radius;
  return {place_of(dot) - QPointF(radius, radius), QSizeF(2 * radius, 2 * radius)};
}

/// Right or left of its line, at its upper or lower end, where it covers the fewest dots.
QRectF DecisionChart::bound_label() const {
  const auto x = bound_x();
  if (!x) {
    return {};
  }
  const QFontMetricsF metrics(font());
  const QRectF plot = scale().plot;
  const QSizeF size(metrics.horizontalAdvance(bound_text()) + 2, metrics.height());
  constexpr double gap = 4;
  QRectF best;
  std::ptrdiff_t least = std::numeric_limits<std::ptrdiff_t>::max();
  for (const double top : {plot.top() - 2, plot.bottom() - size.height()}) {
    for (const double left : {*x + gap, *x - gap - size.width()}) {
      const QRectF label(QPointF(left, top), size);
      constexpr std::ptrdiff_t outside = 100;
      const std::ptrdiff_t faults = (label.left() < plot.left() || label.right() > width() ? outside : 0) +
                                    std::ranges::count_if(dots_, [&](const DecisionDot& dot) {
                                      return mark_of(dot).intersects(label);
                                    });
      if (faults < least) {
        least = faults;
        best = label;
      }
    }
  }
  return best;
}

/// One label for dots of which the eye sees one.
std::vector<DecisionLabel> DecisionChart::grouped_dots() const {
  std::vector<DecisionLabel> labels;
  for (std::size_t i = 0; i < dots_.size(); ++i) {
    const QPointF at = place_of(dots_[i]);
    const auto same = std::ranges::find_if(labels, [&](const DecisionLabel& label) {
      return QLineF(place_of(dots_[label.dots.front()]), at).length() < one_place;
    });
    if (same == labels.end()) {
      labels.push_back({{}, dots_[i].name, {i}});
    } else {
      same->text += QStringLiteral(", ") + dots_[i].name;
      same->dots.push_back(i);
    }
  }
  return labels;
}

/// For each label the place next to its dot that covers the fewest other dots and labels, and from which no
/// other dot is as near.
std::vector<DecisionLabel> DecisionChart::labels() const {
  QFont bold = font();
  bold.setBold(true);  // the widest
  const QFontMetricsF metrics(bold);
  const QRectF plot = scale().plot;
  const QRectF room(QPointF(plot.left(), 0), QPointF(width(), plot.bottom()));
  std::vector<DecisionLabel> labels = grouped_dots();
  for (std::size_t i = 0; i < labels.size(); ++i) {
    DecisionLabel& label = labels[i];
    const auto is_own = [&](std::size_t dot) { return std::ranges::count(label.dots, dot) > 0; };
    const QPointF at = place_of(dots_[label.dots.front()]);
    const bool ringed = std::ranges::any_of(label.dots, [&](std::size_t dot) { return dots_[dot].taken; });
    const double side = (ringed ? ring_radius : dot_radius) + 2;
    const QSizeF size(metrics.horizontalAdvance(label.text) + 2, metrics.height());
    const double slant = 0.6 * side;
    const double middle = -size.height() / 2;
    std::vector<QPointF> corners;
    for (const double far : {0.0, 1.0, 2.0, 3.0}) {  // the nearest places first
      const double more = far * size.height();
      const double above = -size.height() - more;
      for (const QPointF& corner :
           {QPointF(slant, above - slant + 4), QPointF(side, middle - more), QPointF(slant, slant - 4 + more),
            QPointF(-size.width() / 2, above - side + 3), QPointF(-size.width() / 2, side - 3 + more),
            QPointF(-slant - size.width(), above - slant + 4), QPointF(-side - size.width(), middle - more),
            QPointF(-slant - size.width(), slant - 4 + more)}) {
        corners.push_back(corner);
      }
    }
    int least = std::numeric_limits<int>::max();
    for (std::size_t c = 0; c < corners.size(); ++c) {
      const QRectF place(at + corners[c], size);
      const QPointF centre = place.center();
      int faults = (room.contains(place) ? 0 : 100) + (place.intersects(bound_label()) ? 20 : 0);
      for (std::size_t other = 0; other < i; ++other) {
        faults += labels[other].place.intersects(place) ? 20 : 0;
      }
      const double own = QLineF(centre, at).length();
      constexpr double clearly = 2;
      for (std::size_t other = 0; other < dots_.size(); ++other) {
        const bool is_near = QLineF(centre, place_of(dots_[other])).length() < own + clearly;
        faults += is_own(other) ? 0 : (is_near ? 6 : 0) + (mark_of(dots_[other]).intersects(place) ? 6 : 0);
      }
      if (const auto x = bound_x(); x && place.left() < *x && place.right() > *x) {
        ++faults;
      }
      if (faults < least) {
        constexpr std::size_t next_to_dot = 8;
        least = faults;
        label.place = place;
        label.displaced = c >= next_to_dot || faults >= 6;
      }
    }
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
  const Ticks times = clock_ticks(scale.least_time, scale.most_time,
                                  static_cast<int>(scale.plot.height() / type_pixels(tick_room)));
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
      Qt::AlignCenter,
      with_unit_of(
          std::ranges::any_of(dots_, &DecisionDot::actual) ? tr("Actual contour error") : tr("Contour error"),
          Dimension::error));
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
  painter.setPen(colours.text);
  painter.drawText(bound_label(), Qt::AlignCenter | Qt::TextDontClip, bound_text());
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
  const std::vector<DecisionLabel> names = labels();
  for (const DecisionLabel& name : names) {
    if (name.displaced) {
      painter.drawLine(place_of(dots_[name.dots.front()]), name.place.center());
    }
  }
  for (const DecisionDot& dot : dots_) {
    const QPointF at = place_of(dot);
    painter.setPen(Qt::NoPen);
    painter.setBrush(dot.colour);
    painter.drawEllipse(at, dot_radius, dot_radius);
    if (dot.taken) {
      painter.setBrush(Qt::NoBrush);
      painter.setPen(QPen(colours.text, line_pixels(1.6)));
      painter.drawEllipse(at, ring_radius, ring_radius);
    }
  }
  for (const DecisionLabel& name : names) {
    QFont type = font();
    type.setBold(std::ranges::any_of(name.dots, [&](std::size_t dot) { return dots_[dot].current; }));
    painter.setFont(type);
    if (name.displaced) {  // its line ends there
      QColor ground = palette().color(QPalette::Base);
      ground.setAlpha(220);
      painter.fillRect(name.place, ground);
    }
    painter.setPen(colours.text);
    painter.drawText(name.place, Qt::AlignCenter | Qt::TextDontClip, name.text);
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

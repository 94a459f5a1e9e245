#include "ui/program_text/overview_strip.h"

#include <QCoreApplication>
#include <QHelpEvent>
#include <QPaintEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <cmath>
#include <vector>

#include "ui/program_text/line_time_text.h"
#include "ui/program_text/program_view.h"
#include "ui/theme/program_colours.h"
#include "ui/theme/theme.h"

namespace feedscope::ui {

namespace {

constexpr int strip_width = 18;  // [pixels]
constexpr int strip_mark_width = 4;

}  // namespace

OverviewStrip::OverviewStrip(ProgramView* view) : QWidget(view), view_(*view) {
  setCursor(Qt::ArrowCursor);
}

QSize OverviewStrip::sizeHint() const {
  return {strip_width, 0};
}

/// Height of the program; lines of a short one keep their height.
std::int64_t OverviewStrip::used_height() const {
  return std::min<std::int64_t>(height(), std::int64_t{view_.text().line_count()} * view_.line_height());
}

double OverviewStrip::top_of(std::uint32_t line) const {
  return (line - 1.0) * static_cast<double>(used_height()) / std::max(1U, view_.text().line_count());
}

OverviewStrip::Lines OverviewStrip::lines_of(int y) const {
  const std::int64_t count = view_.text().line_count();
  const std::int64_t rows = used_height();
  if (count == 0 || y < 0 || y >= rows) {
    return {};
  }
  const std::int64_t first = y * count / rows + 1;
  const std::int64_t last = std::max(first, (y + 1) * count / rows);
  return {static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(last)};
}

void OverviewStrip::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const ThemeColours& colours = theme_colours(view_.palette());
  painter.fillRect(rect(), colours.gutter);
  if (view_.text().line_count() == 0) {
    return;
  }
  paint_times(painter);
  paint_marks(painter);
  if (view_.current_line() > 0) {
    painter.fillRect(QRectF(0, top_of(view_.current_line()) - 1, width(), 2), colours.cursor);
  }
  if (view_.first_visible_line() == 1 && view_.last_visible_line() == view_.text().line_count()) {
    return;
  }
  const double top = top_of(view_.first_visible_line());
  const double bottom = std::max(top_of(view_.last_visible_line() + 1), top + 3);
  QColor window = colours.frame;
  window.setAlpha(40);
  painter.fillRect(QRectF(0, top, width(), bottom - top), window);
  painter.setPen(colours.frame);
  painter.drawRect(QRectF(0.5, top + 0.5, width() - 1.0, bottom - top - 1));
}

void OverviewStrip::paint_times(QPainter& painter) const {
  if (view_.times() == nullptr) {
    return;
  }
  std::vector<double> times(static_cast<std::size_t>(std::max(0, height())));
  for (int y = 0; y < height(); ++y) {
    const Lines lines = lines_of(y);
    times[static_cast<std::size_t>(y)] = view_.times()->of(lines.first, lines.last).time;
  }
  const double largest = times.empty() ? 0 : *std::ranges::max_element(times);
  const QColor ground = theme_colours(view_.palette()).gutter;
  const int room = width() - strip_mark_width - 1;
  for (int y = 0; y < height(); ++y) {
    const double time = times[static_cast<std::size_t>(y)];
    if (time > 0) {
      const int bar = std::max(1, static_cast<int>(std::lround(room * time / largest)));
      painter.fillRect(QRect(strip_mark_width + 1, y, room, 1),
                       heat_colour(heat_of(time, largest) / 3, ground, view_.palette()));
      painter.fillRect(QRect(strip_mark_width + 1, y, bar, 1),
                       heat_colour(heat_of(time, largest), ground, view_.palette()));
    }
  }
}

void OverviewStrip::paint_marks(QPainter& painter) const {
  const TextSearch* search = view_.search();
  if (search != nullptr && search->found() != nullptr) {
    for (int y = 0; y < height(); ++y) {
      const Lines lines = lines_of(y);
      if (lines.first > 0 && search->found()->any(lines.first, lines.last)) {
        painter.fillRect(QRect(0, y, strip_mark_width, 1), program_colours(view_.palette()).found_mark);
      }
    }
  }
  for (const Severity severity : {Severity::info, Severity::warning, Severity::error}) {
    for (const Diagnostic* diagnostic : view_.marks().all()) {
      if (diagnostic->severity == severity) {
        painter.fillRect(QRectF(0, std::floor(top_of(diagnostic->line)), strip_mark_width, 3),
                         colour_of(severity, view_.palette()));
      }
    }
  }
}

QString OverviewStrip::tip_at(int y) const {
  const Lines lines = lines_of(y);
  return lines.first == 0 || view_.times() == nullptr
             ? QString()
             : line_time_text(*view_.times(), lines.first, lines.last);
}

bool OverviewStrip::event(QEvent* event) {
  if (event->type() == QEvent::ToolTip) {
    const auto* help = static_cast<QHelpEvent*>(event);
    QToolTip::showText(help->globalPos(), tip_at(help->pos().y()), this);
    return true;
  }
  return QWidget::event(event);
}

void OverviewStrip::press(const QPointF& point) {
  const std::uint32_t count = view_.text().line_count();
  if (count > 0) {
    const double share = std::clamp(point.y() / static_cast<double>(used_height()), 0.0, 1.0);
    emit line_pressed(std::clamp(static_cast<std::uint32_t>(share * count) + 1, 1U, count));
  }
}

void OverviewStrip::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) {
    press(event->position());
  }
}

void OverviewStrip::mouseMoveEvent(QMouseEvent* event) {
  if ((event->buttons() & Qt::LeftButton) != 0) {
    press(event->position());
  }
}

void OverviewStrip::wheelEvent(QWheelEvent* event) {
  QCoreApplication::sendEvent(view_.viewport(), event);
}

}  // namespace feedscope::ui

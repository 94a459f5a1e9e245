#include "ui/program_text/program_margin.h"

#include <QCoreApplication>
#include <QHelpEvent>
#include <QPaintEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>

#include "ui/language/in_language.h"
#include "ui/program_text/line_time_text.h"
#include "ui/program_text/program_view.h"
#include "ui/theme/program_colours.h"
#include "ui/theme/theme.h"

namespace feedscope::ui {

namespace {

constexpr int mark_width = 11;  // [pixels]
constexpr int heat_width = 7;
constexpr int gap = 4;

/// Draws shapes as well as colours: a disc for an error, a triangle for a warning, a ring for information.
void draw_mark(QPainter& painter, QPointF centre, Severity severity, const QColor& colour) {
  constexpr double radius = 3.5;
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(colour, 1.2));
  painter.setBrush(severity == Severity::info ? QBrush(Qt::NoBrush) : QBrush(colour));
  if (severity == Severity::warning) {
    painter.drawPolygon(QPolygonF{centre + QPointF(-radius, radius - 1), centre + QPointF(radius, radius - 1),
                                  centre + QPointF(0, -radius)});
  } else {
    const double size = severity == Severity::error ? radius : radius - 1;
    painter.drawEllipse(centre, size, size);
  }
  painter.restore();
}

QString not_counted_tip(Pause pause) {
  switch (pause) {
    case Pause::tool_change:
      return ProgramMargin::tr(
          "Not in the cycle time: tool change; give the tool change time of the machine");
    case Pause::spindle_start:
      return ProgramMargin::tr(
          "Not in the cycle time: spindle start; give the spindle start time of the machine");
    case Pause::stop:
      return ProgramMargin::tr("Not in the cycle time: program stop");
    case Pause::machine_move:
      return ProgramMargin::tr(
          "Neither drawn nor in the cycle time: move to or from a machine position; give the positions of "
          "the machine");
    case Pause::dwell:
    case Pause::indexing:
    case Pause::swing:
      break;
  }
  return {};
}

}  // namespace

ProgramMargin::ProgramMargin(ProgramView* view) : QWidget(view), view_(*view) {
  setCursor(Qt::ArrowCursor);
}

QSize ProgramMargin::sizeHint() const {
  constexpr std::uint32_t min_lines = 100;
  const auto digits = QString::number(std::max(min_lines, view_.text().line_count())).size();
  const int numbers = static_cast<int>(digits) * QFontMetrics(view_.font()).horizontalAdvance('9');
  return {mark_width + numbers + gap + heat_width, 0};
}

void ProgramMargin::paintEvent(QPaintEvent* event) {
  QPainter painter(this);
  painter.fillRect(event->rect(), theme_colours(view_.palette()).gutter);
  painter.setFont(view_.font());
  for (std::uint32_t line = view_.first_visible_line(); line > 0 && line <= view_.last_visible_line();
       ++line) {
    paint_line(painter, line);
  }
}

void ProgramMargin::paint_line(QPainter& painter, std::uint32_t line) const {
  const ThemeColours& colours = theme_colours(view_.palette());
  const QRect row(0, view_.top_of(line), width(), view_.line_height());
  const bool current = line == view_.current_line();
  if (current) {
    painter.fillRect(row, colours.current_line);
  }
  const auto diagnostics = view_.marks().of(line);
  if (!diagnostics.empty()) {
    const Severity worst = worst_of(diagnostics);
    draw_mark(painter, QPointF(mark_width / 2.0, row.center().y() + 0.5), worst,
              colour_of(worst, view_.palette()));
  }
  painter.setPen(current ? view_.palette().color(QPalette::Text) : colours.muted);
  painter.drawText(row.adjusted(0, 0, -gap - heat_width, 0), Qt::AlignRight | Qt::AlignVCenter,
                   QString::number(line));
  if (view_.times() != nullptr) {
    const double heat = heat_of(view_.times()->of(line).time, view_.times()->largest());
    const QRect strip(width() - heat_width, row.top(), heat_width, row.height());
    painter.fillRect(strip, heat_colour(heat, colours.gutter, view_.palette()));
    if (!view_.times()->not_counted(line).empty()) {
      painter.fillRect(strip, QBrush(colour_of(Severity::warning, view_.palette()), Qt::BDiagPattern));
    }
  }
}

QString ProgramMargin::tip_of(std::uint32_t line) const {
  QStringList tip;
  if (view_.times() != nullptr) {
    const QString cost = line_time_text(*view_.times(), line, line);
    tip.append(cost.isEmpty() ? tr("Line %1 takes no time").arg(QString::number(line)) : cost);
  }
  if (view_.times() != nullptr) {
    for (const Pause pause : view_.times()->not_counted(line)) {
      tip.append(not_counted_tip(pause));
    }
  }
  for (const Diagnostic* diagnostic : view_.marks().of(line)) {
    tip.append(in_language(diagnostic->message));
  }
  return tip.join('\n');
}

bool ProgramMargin::event(QEvent* event) {
  if (event->type() == QEvent::ToolTip) {
    const auto* help = static_cast<QHelpEvent*>(event);
    const std::uint32_t line = view_.line_at(help->pos().y());
    QToolTip::showText(help->globalPos(), line > 0 ? tip_of(line) : QString(), this);
    return true;
  }
  return QWidget::event(event);
}

void ProgramMargin::mousePressEvent(QMouseEvent* event) {
  const std::uint32_t line = view_.line_at(static_cast<int>(event->position().y()));
  if (event->button() == Qt::LeftButton && line > 0) {
    view_.setFocus(Qt::MouseFocusReason);
    view_.go_to({line, 0});
  }
}

void ProgramMargin::wheelEvent(QWheelEvent* event) {
  QCoreApplication::sendEvent(view_.viewport(), event);
}

}  // namespace feedscope::ui

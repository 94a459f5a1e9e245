// Keyboard and mouse of ProgramView.
#include <QApplication>
#include <QClipboard>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QScrollBar>
#include <QWheelEvent>
#include <algorithm>

#include "ui/views/program/program_view.h"

namespace feedscope::ui {

TextPlace ProgramView::vertically_moved(std::int64_t lines) const {
  const std::int64_t line =
      std::clamp<std::int64_t>(std::int64_t{caret_.line} + lines, 1, text_.line_count());
  const auto there = static_cast<std::uint32_t>(line);
  return {there, text_.cells(there).byte_at(wanted_cell_)};
}

TextPlace ProgramView::moved(CaretStep step) const {
  switch (step) {
    case CaretStep::character_before:
      return text_.before(caret_);
    case CaretStep::character_after:
      return text_.after(caret_);
    case CaretStep::word_before:
      return text_.word_before(caret_);
    case CaretStep::word_after:
      return text_.word_after(caret_);
    case CaretStep::line_up:
      return vertically_moved(-1);
    case CaretStep::line_down:
      return vertically_moved(1);
    case CaretStep::page_up:
      return vertically_moved(-lines_in_sight());
    case CaretStep::page_down:
      return vertically_moved(lines_in_sight());
    case CaretStep::line_start:
      return {caret_.line, 0};
    case CaretStep::line_end:
      return text_.clamped({caret_.line, ~0U});
    case CaretStep::program_start:
      return {};
    case CaretStep::program_end:
      return text_.end();
  }
  return caret_;
}

bool ProgramView::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {  // Ctrl+Home is the text's here, not the window's
    auto* key = static_cast<QKeyEvent*>(event);
    if (caret_movement_of(*key) || key->matches(QKeySequence::Copy) ||
        key->matches(QKeySequence::SelectAll)) {
      event->accept();
      return true;
    }
  }
  return QAbstractScrollArea::event(event);
}

void ProgramView::keyPressEvent(QKeyEvent* event) {
  if (text_.line_count() == 0) {
    QAbstractScrollArea::keyPressEvent(event);
  } else if (const auto movement = caret_movement_of(*event)) {
    if (!movement->selects && !selection().empty() && current_ > 0 && caret_.line != current_) {
      caret_ = {current_, 0};  // playback went on while a selection was kept
    }
    const std::uint32_t line = caret_.line;
    const std::uint32_t wanted = wanted_cell_;
    move_caret(moved(movement->step), movement->selects);
    if (movement->step >= CaretStep::line_up && movement->step <= CaretStep::page_down) {
      wanted_cell_ = wanted;
    }
    if (!movement->selects && caret_.line != line) {
      choose(caret_.line);
    }
  } else if (event->matches(QKeySequence::Copy)) {
    copy();
  } else if (event->matches(QKeySequence::SelectAll)) {
    select_all();
  } else {
    QAbstractScrollArea::keyPressEvent(event);
  }
}

void ProgramView::copy() const {
  if (!selection().empty()) {
    QApplication::clipboard()->setText(selected_text());
  }
}

void ProgramView::select_all() {
  anchor_ = {};
  caret_ = text_.end();
  refresh();
  emit caret_moved();
}

void ProgramView::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || text_.line_count() == 0) {
    return;
  }
  const bool extends = (event->modifiers() & Qt::ShiftModifier) != 0;
  move_caret(place_at(event->position().toPoint()), extends);
  if (!extends) {
    choose(caret_.line);
  }
}

void ProgramView::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton && text_.line_count() > 0) {
    const TextRange word = text_.word_at(place_at(event->position().toPoint()));
    anchor_ = word.begin;
    move_caret(word.end, true);
  }
}

void ProgramView::mouseMoveEvent(QMouseEvent* event) {
  if ((event->buttons() & Qt::LeftButton) == 0 || text_.line_count() == 0) {
    return;
  }
  drag_point_ = event->position().toPoint();
  drag_to(drag_point_);
  constexpr int scroll_interval = 50;  // [ms]
  if (viewport()->rect().contains(drag_point_)) {
    drag_timer_.stop();
  } else if (!drag_timer_.isActive()) {
    drag_timer_.start(scroll_interval, this);
  }
}

void ProgramView::drag_to(const QPoint& point) {
  move_caret(place_at(point), true);
}

void ProgramView::timerEvent(QTimerEvent* event) {
  if (event->timerId() == drag_timer_.timerId()) {
    drag_to(drag_point_);
  }
}

void ProgramView::mouseReleaseEvent(QMouseEvent* event) {
  drag_timer_.stop();
  QClipboard* clipboard = QApplication::clipboard();
  if (event->button() == Qt::LeftButton && clipboard->supportsSelection() && !selection().empty()) {
    clipboard->setText(selected_text(), QClipboard::Selection);
  }
}

void ProgramView::wheelEvent(QWheelEvent* event) {
  if ((event->modifiers() & Qt::ControlModifier) == 0) {
    QAbstractScrollArea::wheelEvent(event);
    return;
  }
  wheel_rest_ += event->angleDelta().y();
  const int steps = wheel_rest_ / QWheelEvent::DefaultDeltasPerStep;
  wheel_rest_ -= steps * QWheelEvent::DefaultDeltasPerStep;
  zoom(steps);
  event->accept();
}

void ProgramView::focusInEvent(QFocusEvent*) {
  viewport()->update();
}

void ProgramView::focusOutEvent(QFocusEvent*) {
  viewport()->update();
}

}  // namespace feedscope::ui

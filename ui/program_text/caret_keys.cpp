#include "ui/program_text/caret_keys.h"

#include <QKeyEvent>
#include <QKeySequence>
#include <array>

namespace feedscope::ui {

namespace {

struct StepKeys {
  CaretStep step;
  QKeySequence::StandardKey move;
  QKeySequence::StandardKey select;
};

constexpr std::array<StepKeys, 12> step_keys{{
    {CaretStep::character_before, QKeySequence::MoveToPreviousChar, QKeySequence::SelectPreviousChar},
    {CaretStep::character_after, QKeySequence::MoveToNextChar, QKeySequence::SelectNextChar},
    {CaretStep::word_before, QKeySequence::MoveToPreviousWord, QKeySequence::SelectPreviousWord},
    {CaretStep::word_after, QKeySequence::MoveToNextWord, QKeySequence::SelectNextWord},
    {CaretStep::line_up, QKeySequence::MoveToPreviousLine, QKeySequence::SelectPreviousLine},
    {CaretStep::line_down, QKeySequence::MoveToNextLine, QKeySequence::SelectNextLine},
    {CaretStep::page_up, QKeySequence::MoveToPreviousPage, QKeySequence::SelectPreviousPage},
    {CaretStep::page_down, QKeySequence::MoveToNextPage, QKeySequence::SelectNextPage},
    {CaretStep::line_start, QKeySequence::MoveToStartOfLine, QKeySequence::SelectStartOfLine},
    {CaretStep::line_end, QKeySequence::MoveToEndOfLine, QKeySequence::SelectEndOfLine},
    {CaretStep::program_start, QKeySequence::MoveToStartOfDocument, QKeySequence::SelectStartOfDocument},
    {CaretStep::program_end, QKeySequence::MoveToEndOfDocument, QKeySequence::SelectEndOfDocument},
}};

}  // namespace

std::optional<CaretMovement> caret_movement_of(const QKeyEvent& event) {
  for (const StepKeys& keys : step_keys) {
    if (event.matches(keys.move)) {
      return CaretMovement{keys.step, false};
    }
    if (event.matches(keys.select)) {
      return CaretMovement{keys.step, true};
    }
  }
  return std::nullopt;
}

}  // namespace feedscope::ui

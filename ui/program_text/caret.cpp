#include "ui/program_text/caret.h"

#include <algorithm>

namespace feedscope::ui {

TextRange Caret::selection() const {
  return {std::min(anchor_, place_), std::max(anchor_, place_)};
}

void Caret::put(const ProgramText& text, TextPlace place, bool selects) {
  place_ = text.clamped(place);
  if (!selects) {
    anchor_ = place_;
  }
  wanted_cell_ = text.cells(place_.line).cell_of(place_.byte);
}

void Caret::select(const ProgramText& text, TextRange range) {
  anchor_ = text.clamped(range.begin);
  put(text, range.end, true);
}

void Caret::move(const ProgramText& text, CaretMovement movement, std::uint32_t page) {
  const std::uint32_t wanted = wanted_cell_;
  put(text, moved(text, movement.step, page), movement.selects);
  if (movement.step >= CaretStep::line_up && movement.step <= CaretStep::page_down) {
    wanted_cell_ = wanted;
  }
}

TextPlace Caret::vertically_moved(const ProgramText& text, std::int64_t lines) const {
  const std::int64_t line = std::clamp<std::int64_t>(std::int64_t{place_.line} + lines, 1, text.line_count());
  const auto there = static_cast<std::uint32_t>(line);
  return {there, text.cells(there).byte_at(wanted_cell_)};
}

TextPlace Caret::moved(const ProgramText& text, CaretStep step, std::uint32_t page) const {
  switch (step) {
    case CaretStep::character_before:
      return text.before(place_);
    case CaretStep::character_after:
      return text.after(place_);
    case CaretStep::word_before:
      return text.word_before(place_);
    case CaretStep::word_after:
      return text.word_after(place_);
    case CaretStep::line_up:
      return vertically_moved(text, -1);
    case CaretStep::line_down:
      return vertically_moved(text, 1);
    case CaretStep::page_up:
      return vertically_moved(text, -std::int64_t{page});
    case CaretStep::page_down:
      return vertically_moved(text, page);
    case CaretStep::line_start:
      return {place_.line, 0};
    case CaretStep::line_end:
      return text.clamped({place_.line, ~0U});
    case CaretStep::program_start:
      return {};
    case CaretStep::program_end:
      return text.end();
  }
  return place_;
}

}  // namespace feedscope::ui

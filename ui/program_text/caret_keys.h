#pragma once

#include <cstdint>
#include <optional>

class QKeyEvent;

namespace feedscope::ui {

enum class CaretStep : std::uint8_t {
  character_before,
  character_after,
  word_before,
  word_after,
  line_up,
  line_down,
  page_up,
  page_down,
  line_start,
  line_end,
  program_start,
  program_end,
};

struct CaretMovement {
  CaretStep step = CaretStep::character_after;
  bool selects = false;
};

/// The movement for a key press, by the desktop's keys for text; none for other keys.
std::optional<CaretMovement> caret_movement_of(const QKeyEvent& event);

}  // namespace feedscope::ui

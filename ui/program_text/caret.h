#pragma once

#include <cstdint>

#include "ui/program_text/caret_keys.h"
#include "ui/program_text/program_text.h"

namespace feedscope::ui {

/// The position of the keyboard in a program's text, and the selection that ends there. Moving up and down,
/// it keeps its last chosen column.
class Caret {
 public:
  TextPlace place() const { return place_; }
  /// Empty without one.
  TextRange selection() const;

  /// Goes to the nearest existing place. `selects`: extends the selection to here; else clears it.
  void put(const ProgramText& text, TextPlace place, bool selects);
  /// Selects a range and moves to its end; both ends are clamped to the text.
  void select(const ProgramText& text, TextRange range);
  /// `page`: number of lines.
  void move(const ProgramText& text, CaretMovement movement, std::uint32_t page);

 private:
  TextPlace moved(const ProgramText& text, CaretStep step, std::uint32_t page) const;
  TextPlace vertically_moved(const ProgramText& text, std::int64_t lines) const;

  TextPlace place_;
  TextPlace anchor_;               ///< start of the selection
  std::uint32_t wanted_cell_ = 0;  ///< kept when moving up and down
};

}  // namespace feedscope::ui

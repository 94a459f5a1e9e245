#pragma once

#include <cstdint>

#include "ui/program_text/caret_keys.h"
#include "ui/program_text/program_text.h"

namespace feedscope::ui {

/// The place of the keyboard in a program's text and the selection that it ends. Going up and down it keeps
/// to the column that it was put into last.
class Caret {
 public:
  TextPlace place() const { return place_; }
  /// Empty without one.
  TextRange selection() const;

  /// Goes to the nearest place that there is. `selects`: the selection then ends here, else there is none.
  void put(const ProgramText& text, TextPlace place, bool selects);
  /// Selects from one place to another, at whose end it stands then; both are clamped to the text.
  void select(const ProgramText& text, TextRange range);
  /// `page`: lines of a page.
  void move(const ProgramText& text, CaretMovement movement, std::uint32_t page);

 private:
  TextPlace moved(const ProgramText& text, CaretStep step, std::uint32_t page) const;
  TextPlace vertically_moved(const ProgramText& text, std::int64_t lines) const;

  TextPlace place_;
  TextPlace anchor_;               ///< where the selection begins
  std::uint32_t wanted_cell_ = 0;  ///< that it keeps to going up and down
};

}  // namespace feedscope::ui

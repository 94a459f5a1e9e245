#pragma once

#include <QString>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/program/text/source_text.h"

namespace feedscope::ui {

/// Where the characters of one line stand in a grid of equally wide cells: one cell a character, two for the
/// wide ones of East Asia, none for marks on the character before; tabs reach to the next multiple of eight.
///
/// Bytes are counted from 0 in the line as SourceText gives it. A line of more than longest_decoded bytes is
/// shown byte by byte, so that none takes long.
class LineCells {
 public:
  static constexpr std::size_t longest_decoded = 1 << 16;

  /// `line` outlives this.
  LineCells(std::string_view line, Encoding encoding);

  std::uint32_t count() const { return count_; }
  /// Cell of the character that holds a byte; count() from the end of the line on.
  std::uint32_t cell_of(std::uint32_t byte) const;
  /// First byte of the character in a cell; the line's size from count() on.
  std::uint32_t byte_at(std::uint32_t cell) const;

  /// Characters that follow each other in a row of cells.
  struct Run {
    QString text;
    std::uint32_t cell = 0;
  };
  /// What to draw of the bytes [from, to); tabs and blanks around them draw nothing.
  std::vector<Run> runs(std::uint32_t from, std::uint32_t to) const;

 private:
  struct Character {
    std::uint32_t byte;
    std::uint32_t cell;
    char32_t code;
  };

  std::size_t character_of(std::uint32_t byte) const;

  std::string_view line_;
  std::vector<Character> characters_;  ///< none for a line in which byte and cell are the same
  std::uint32_t count_ = 0;
};

}  // namespace feedscope::ui

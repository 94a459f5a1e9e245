#pragma once

#include <QString>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/program/text/source_text.h"

namespace feedscope::ui {

/// Places of a line's characters in a grid of equally wide cells: one cell for each character, two for wide
/// ones of East Asia, none for combining marks; tabs extend to the next multiple of eight.
///
/// Bytes count from 0 in the line of SourceText. A line of more than longest_decoded bytes is shown byte by
/// byte, which bounds the time for any line.
class LineCells {
 public:
  static constexpr std::size_t longest_decoded = 1 << 16;

  /// `line` outlives this.
  LineCells(std::string_view line, Encoding encoding);

  std::uint32_t count() const { return count_; }
  /// Cell of the character at a byte; count() from the end of the line on.
  std::uint32_t cell_of(std::uint32_t byte) const;
  /// First byte of the character in a cell; the line's size from count() on.
  std::uint32_t byte_at(std::uint32_t cell) const;

  /// Adjacent characters in a row of cells.
  struct Run {
    QString text;
    std::uint32_t cell = 0;
  };
  /// Drawn characters of the bytes [from, to), without tabs and surrounding blanks.
  std::vector<Run> runs(std::uint32_t from, std::uint32_t to) const;

 private:
  struct Character {
    std::uint32_t byte;
    std::uint32_t cell;
    char32_t code;
  };

  std::size_t character_of(std::uint32_t byte) const;

  std::string_view line_;
  std::vector<Character> characters_;  ///< empty for a line with byte = cell
  std::uint32_t count_ = 0;
};

}  // namespace feedscope::ui

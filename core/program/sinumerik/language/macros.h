#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace feedscope::sinumerik {

/// DEFINE NAME AS words: names for the words of their definition. They are replaced before a line is read;
/// nested ones are not (Programming Manual NC, macro technique).
class Macros {
 public:
  /// A line with macros replaced.
  struct Line {
    /// Range of a macro's words in `text`, and of its name as written; 0-based.
    struct Piece {
      std::size_t begin = 0;
      std::size_t end = 0;
      std::size_t written_begin = 0;
      std::size_t written_end = 0;
    };
    std::string text;
    std::vector<Piece> pieces;

    /// Column as written for a column of `text`, both 1-based; 0 stays 0.
    std::uint32_t written_column(std::uint32_t column) const;
  };

  bool empty() const { return words_.empty(); }
  void define(std::string_view name, std::string_view words);
  /// None if the line has no macro name outside of quoted texts and comments, or if it defines one.
  std::optional<Line> replaced(std::string_view line) const;

 private:
  std::map<std::string, std::string> words_;  ///< by upper-case name
};

}  // namespace feedscope::sinumerik

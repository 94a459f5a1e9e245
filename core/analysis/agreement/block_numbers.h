#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "core/program/text/source_text.h"

namespace feedscope {

/// Lines of a program by the block number that they begin with: N120, :120, or 120 alone as Heidenhain writes
/// it. A number that several lines share belongs to none.
class BlockNumbers {
 public:
  explicit BlockNumbers(const SourceText& source);

  bool empty() const { return lines_.empty(); }
  std::uint32_t line_of(std::uint32_t number) const;  ///< 0 if no line has the number
  /// Replaces numbers by lines; 0 stays 0.
  std::vector<std::uint32_t> lines_of(const std::vector<std::uint32_t>& numbers) const;

 private:
  std::vector<std::pair<std::uint32_t, std::uint32_t>> lines_;  ///< number and line, sorted by number
};

}  // namespace feedscope

#pragma once

#include <compare>
#include <cstdint>

namespace feedscope::ui {

/// A place between two characters of a program.
struct TextPlace {
  std::uint32_t line = 1;  ///< 1-based
  std::uint32_t byte = 0;  ///< in the line, from 0 to its size

  auto operator<=>(const TextPlace&) const = default;
};

struct TextRange {
  TextPlace begin;
  TextPlace end;

  bool empty() const { return begin == end; }
  bool operator==(const TextRange&) const = default;
};

}  // namespace feedscope::ui

#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "core/program/heidenhain/language/motion_words.h"
#include "core/program/heidenhain/language/tools.h"

namespace feedscope::heidenhain {

/// Words of a DIN/ISO block without codes that have their own grammar.
struct IsoBlock {
  MotionWords motion;
  std::array<int, 16> codes{};
  int code_count = 0;
  std::uint32_t column = 0;
  std::uint32_t code_column = 0;                 ///< of the first G
  std::array<OptionalWord, 3> pole;              ///< I, J, K
  std::optional<double> radius;                  ///< R, as written
  std::optional<double> angle;                   ///< H, as written
  std::optional<std::string> label;              ///< L
  std::optional<double> repeats;                 ///< L5,3
  ToolCall tool;                                 ///< T, S, DR
  std::array<std::optional<double>, 10> values;  ///< P01 to P09

  bool has(int code) const;
};

}  // namespace feedscope::heidenhain

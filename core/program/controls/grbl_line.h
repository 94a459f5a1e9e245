#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/message.h"

namespace feedscope {

/// Error by which grbl rejects a line: number of its message "error:N", and the word or value concerned.
struct GrblError {
  int number = 0;
  Message about = {};
};

/// Meaning of an error of grbl 1.1, in our words.
Translatable grbl_error_text(int number);

/// One line as read by grbl: its commands and values.
struct GrblLine {
  struct Code {
    int number = 0;   ///< G17 17, G38.2 38
    int decimal = 0;  ///< G38.2 2
  };
  std::vector<Code> g;
  std::vector<int> m;
  std::array<std::optional<float>, 26> values{};  ///< of the other letters

  bool has(char letter) const { return value(letter).has_value(); }
  const std::optional<float>& value(char letter) const {
    return values[static_cast<std::size_t>(letter - 'A')];
  }
  bool empty() const;
};

/// Drops blanks, control characters, "/" and comments, makes letters upper case, then reads words. Returns
/// the first error.
std::optional<GrblError> read_grbl_line(std::string_view text, GrblLine& line);

}  // namespace feedscope

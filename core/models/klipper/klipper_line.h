#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace feedscope {

/// One line as Klipper reads it: its command, and everything behind it by its letters.
struct KlipperLine {
  std::string command;  ///< "G1", "M204", "X10", "SET_VELOCITY_LIMIT"; empty: the line asks for nothing
  std::map<std::string, std::string, std::less<>> values;

  bool has(std::string_view key) const { return values.find(key) != values.end(); }
  /// None where the value is missing or no number; an "=" before it does not matter.
  std::optional<double> number(std::string_view key) const;
};

KlipperLine read_klipper_line(std::string_view text);

}  // namespace feedscope

#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace feedscope {

/// One line as read by Klipper: its command, and everything after it by its letters.
struct KlipperLine {
  std::string command;  ///< "G1", "M204", "X10", "SET_VELOCITY_LIMIT"; empty: no command
  std::map<std::string, std::string, std::less<>> values;

  bool has(std::string_view key) const { return values.find(key) != values.end(); }
  /// None if the value is missing or not a number; ignores an "=" before it.
  std::optional<double> number(std::string_view key) const;
};

KlipperLine read_klipper_line(std::string_view text);

}  // namespace feedscope

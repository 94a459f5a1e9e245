#pragma once

#include <fmt/format.h>

#include <string>

namespace feedscope {

/// Quoted where a comma, a quote or a line end would break the row.
inline std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) {
    return text;
  }
  std::string quoted = "\"";
  for (const char c : text) {
    quoted += c;
    if (c == '"') {
      quoted += c;
    }
  }
  return quoted + '"';
}

/// Eleven digits, and no minus before zero.
inline std::string csv_number(double value) {
  return fmt::format("{:.11g}", value + 0.0);
}

}  // namespace feedscope

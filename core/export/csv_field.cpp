#include "core/export/csv_field.h"

#include <fmt/format.h>

#include <cmath>

namespace feedscope {

std::string csv_field(const std::string& text) {
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

std::string csv_number(double value) {
  return std::isnan(value) ? "" : fmt::format("{:.11g}", value + 0.0);
}

}  // namespace feedscope

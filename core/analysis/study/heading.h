#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace feedscope {

/// What a line says that heads an operation, without the dashes or stars around it; "" for one without a
/// letter in it (a rule); none for every other line. Block numbers in front do not count.
std::optional<std::string> operation_heading(std::string_view line);

/// What a line says of tools, comments omitted: the names that "T3", "T=\"MILL\"" or "TOOL CALL 3" give, the
/// last one counting, and whether M6 or TOOL CALL brings it in.
struct ToolWords {
  std::string tool;  ///< "" for none
  bool comes_in = false;
};
ToolWords tool_words(std::string_view line);

}  // namespace feedscope

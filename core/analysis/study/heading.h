#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace feedscope {

/// Text of a line that heads an operation, without surrounding dashes or stars; "" without a letter (a rule);
/// none for every other line. Block numbers at the start are ignored.
std::optional<std::string> operation_heading(std::string_view line);

/// Tool words of a line without comments: the last name in "T3", "T=\"MILL\"" or "TOOL CALL 3", and whether
/// M6 or TOOL CALL loads the tool.
struct ToolWords {
  std::string tool;  ///< "" if none
  bool comes_in = false;
};
ToolWords tool_words(std::string_view line);

}  // namespace feedscope

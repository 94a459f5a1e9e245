#include "core/program/text/message_codes.h"

#include <fmt/format.h>

namespace feedscope {

std::string message_code_lists() {
  std::string text;
  std::string_view group;
  for (const MessageCodeInfo& info : message_codes) {
    if (info.group != group) {
      text += fmt::format("{}### {}\n\n", text.empty() ? "" : "\n", info.group);
      group = info.group;
    }
    text += fmt::format("- `{}` ({}): {}\n", info.code, info.severity, info.example);
  }
  return text;
}

}  // namespace feedscope

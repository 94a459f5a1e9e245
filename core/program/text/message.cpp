#include "core/program/text/message.h"

#include <fmt/format.h>

namespace feedscope {

std::string in_quotes(std::string_view text) {
  constexpr std::size_t longest = 32;
  std::string shown = "\"";
  for (const char c : text.substr(0, longest)) {
    shown += c >= ' ' && c <= '~' ? c : '?';
  }
  return shown + (text.size() > longest ? "...\"" : "\"");
}

std::string g_name(int number) {
  return number % 10 == 0 ? fmt::format("G{}", number / 10) : fmt::format("G{}.{}", number / 10, number % 10);
}

Message missing_offset_hint(std::string name) {
  std::erase(name, ' ');
  return message(NC_("core",
                     "offsets without a value are assumed as zero, so parts of the path overlap; give them "
                     "as an import option, --offset {}=X,Y,Z"),
                 name);
}

}  // namespace feedscope

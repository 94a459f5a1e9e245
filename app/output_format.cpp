#include "app/output_format.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "core/base/error.h"

namespace feedscope {

std::string output_format(const std::string& out, const std::string& asked,
                          const std::vector<std::string>& known) {
  if (!asked.empty()) {
    return asked;
  }
  if (out == "-") {
    return known.front();
  }
  std::string ending = std::filesystem::path(out).extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return std::tolower(c); });
  ending = ending == ".htm" ? "html" : ending.substr(std::min<std::size_t>(1, ending.size()));
  if (std::ranges::find(known, ending) == known.end()) {
    throw InputError(fmt::format("--out '{}' does not state the format; end it in .{}, or add --format {}",
                                 out, fmt::join(known, ", ."), fmt::join(known, "|")));
  }
  return ending;
}

bool asks_for_pages(const std::string& out) {
  return std::filesystem::path(out).extension() == ".feedpages";
}

}  // namespace feedscope

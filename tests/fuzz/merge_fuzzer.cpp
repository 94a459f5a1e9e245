// Any bytes as files of compare --json, a line of three hyphens between them: what they merge to can be
// written, and the same program twice is refused.
#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/export/merge.h"
#include "tests/fuzz/must.h"

using namespace feedscope;

namespace {

std::vector<NamedText> files_of(const std::string& text) {
  constexpr std::string_view border = "\n---\n";
  std::vector<NamedText> files;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t to = std::min(text.find(border, from), text.size());
    files.push_back({std::to_string(files.size()) + ".json", text.substr(from, to - from)});
    from = to + border.size();
  }
  return files;
}

std::optional<MergedComparison> merged(const std::vector<NamedText>& files, std::optional<double> within) {
  try {
    return merge_comparisons(files, within);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::vector<NamedText> files = files_of(std::string(data, data + size));
  for (const std::optional<double> within : {std::optional<double>(), std::optional(0.02)}) {
    const std::optional<MergedComparison> all = merged(files, within);
    if (!all) {
      return 0;
    }
    fuzz::must(all->programs.size() == files.size(), "a file has no program");
    fuzz::must(nlohmann::json::accept(merged_json(*all)), "no JSON is written");
    fuzz::must(merged_csv(*all).ends_with('\n'), "no CSV is written");
  }
  files.push_back(files.front());
  fuzz::must(!merged(files, std::nullopt), "a file is merged with itself");
  return 0;
}

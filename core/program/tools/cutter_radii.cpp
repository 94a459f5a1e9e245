#include "core/program/tools/cutter_radii.h"

#include <algorithm>
#include <utility>

#include "core/program/text/scanner.h"

namespace feedscope {

void CutterRadii::set(std::string_view tool, double radius) {
  std::string name = key(tool);
  if (!name.empty() && name.front() != ',') {
    radii_[std::move(name)] = radius;
  }
}

std::optional<double> CutterRadii::find(std::string_view tool) const {
  const auto found = radii_.find(key(tool));
  return found == radii_.end() ? std::nullopt : std::optional(found->second);
}

std::string CutterRadii::key(std::string_view tool) {
  constexpr std::string_view first_edge = ",1";
  const auto is_around = [](char c) { return letters::is_blank(c) || c == '"'; };
  for (std::size_t before = tool.size() + 1; tool.size() < before;) {
    before = tool.size();
    if (tool.ends_with(first_edge)) {
      tool.remove_suffix(first_edge.size());
    }
    while (!tool.empty() && is_around(tool.front())) {
      tool.remove_prefix(1);
    }
    while (!tool.empty() && is_around(tool.back())) {
      tool.remove_suffix(1);
    }
  }
  const std::string_view number = tool.substr(0, tool.find(','));
  if (std::all_of(number.begin(), number.end(), letters::is_digit)) {
    while (tool.size() > 1 && tool[0] == '0' && letters::is_digit(tool[1])) {
      tool.remove_prefix(1);
    }
  }
  std::string key(tool);
  std::transform(key.begin(), key.end(), key.begin(), letters::to_upper);
  return key;
}

}  // namespace feedscope

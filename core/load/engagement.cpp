#include "core/load/engagement.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/base/units.h"

namespace feedscope {

Immersion immersion(const Engagement& operation) {
  const double span = std::acos(std::clamp(1 - 2 * operation.radial_depth / operation.diameter, -1.0, 1.0));
  return operation.milling == Milling::up ? Immersion{0, span} : Immersion{units::pi - span, units::pi};
}

std::optional<std::vector<ProgramLines>> ranges_of(std::string_view text) {
  std::string compact(text);
  std::erase_if(compact, [](char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; });
  std::vector<ProgramLines> ranges;
  const char* at = compact.data();
  const char* const end = at + compact.size();
  while (true) {
    ProgramLines range;
    const auto first = std::from_chars(at, end, range.first);
    if (first.ec != std::errc()) {
      return std::nullopt;
    }
    at = first.ptr;
    range.last = range.first;
    if (at != end && *at == '-') {
      const auto last = std::from_chars(at + 1, end, range.last);
      if (last.ec != std::errc()) {
        return std::nullopt;
      }
      at = last.ptr;
    }
    ranges.push_back(range);
    if (at == end) {
      return ranges;
    }
    if (*at != ',') {
      return std::nullopt;
    }
    ++at;
  }
}

std::string ranges_text(const std::vector<ProgramLines>& ranges) {
  std::string text;
  for (const ProgramLines& range : ranges) {
    text += fmt::format("{}{}-{}", text.empty() ? "" : ", ", range.first, range.last);
  }
  return text;
}

Message operation_problem(const Engagement& operation) {
  if (operation.radial_depth > operation.diameter) {
    return message(NC_("core",
                       "ae_mm {:.6g} is larger than diameter_mm {:.6g}; a tool is engaged over its diameter "
                       "at most: lower ae_mm, {:.6g} is a full slot"),
                   operation.radial_depth, operation.diameter, operation.diameter);
  }
  for (const ProgramLines& range : operation.lines) {
    if (range.first < 1 || range.last < range.first) {
      return message(NC_("core", "lines {}-{} is no range; write FIRST-LAST, counted from 1"), range.first,
                     range.last);
    }
  }
  if (operation.least_chip && operation.max_chip && *operation.least_chip >= *operation.max_chip) {
    return message(
        NC_("core", "min_chip_um {:.6g} is not below max_chip_um {:.6g}; every chip would be out of bounds"),
        units::to_um(*operation.least_chip), units::to_um(*operation.max_chip));
  }
  return {};
}

Message describe(const Engagement& operation) {
  constexpr std::size_t most_ranges = 3;
  const std::size_t named = std::min(most_ranges, operation.lines.size());
  if (named == 0) {
    return operation.tool.empty() ? Message(NC_("core", "all tools"))
                                  : message(NC_("core", "tool {}"), operation.tool);
  }
  Message lines =
      Message::as_written(ranges_text({operation.lines.begin(), operation.lines.begin() + named}));
  if (operation.lines.size() > named) {
    lines = message(NC_("core", "{} and {} more"), lines, operation.lines.size() - named);
  }
  return operation.tool.empty() ? message(NC_("core", "all tools, lines {}"), lines)
                                : message(NC_("core", "tool {}, lines {}"), operation.tool, lines);
}

}  // namespace feedscope

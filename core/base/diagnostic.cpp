#include "core/base/diagnostic.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <span>
#include <string_view>
#include <tuple>

namespace feedscope {

std::string_view to_string(Severity severity) {
  switch (severity) {
    case Severity::info:
      return NC_("core", "info").english;
    case Severity::warning:
      return NC_("core", "warning").english;
    case Severity::error:
      break;
  }
  return NC_("core", "error").english;
}

bool has_errors(const std::vector<Diagnostic>& diagnostics) {
  return std::any_of(diagnostics.begin(), diagnostics.end(),
                     [](const Diagnostic& d) { return d.severity == Severity::error; });
}

std::uint64_t count_of(const std::vector<Diagnostic>& diagnostics, Severity severity) {
  std::uint64_t count = 0;
  for (const Diagnostic& diagnostic : diagnostics) {
    count += diagnostic.severity == severity ? diagnostic.count : 0;
  }
  return count;
}

std::vector<RepeatedDiagnostic> without_repeats(const std::vector<Diagnostic>& diagnostics) {
  using Kind = std::tuple<std::string_view, std::string_view, Severity>;
  using Said = std::pair<std::string, std::string>;
  constexpr std::size_t several = std::numeric_limits<std::size_t>::max();
  std::vector<RepeatedDiagnostic> all;
  std::map<std::pair<Kind, Said>, std::size_t> known;
  std::map<std::pair<Kind, int>, std::size_t> only_of_kind;  // by detail
  for (const Diagnostic& d : diagnostics) {
    const Kind kind(d.file, d.code, d.severity);
    if (d.count > 1 || d.last_line > 0) {
      const auto only = only_of_kind.find({kind, d.detail});
      if (only != only_of_kind.end() && only->second != several) {
        RepeatedDiagnostic& same = all[only->second];
        same.unlisted += d.count;
        same.last_line = std::max({same.last_line, d.last_line, d.line});
        continue;
      }
      all.push_back({&d});
      continue;
    }
    const auto [found, is_new] =
        known.try_emplace({kind, Said(d.message.english(), d.hint.english())}, all.size());
    if (is_new) {
      const auto [only, is_first] = only_of_kind.try_emplace({kind, d.detail}, all.size());
      only->second = is_first ? all.size() : several;
      all.push_back({&d});
      continue;
    }
    RepeatedDiagnostic& same = all[found->second];
    const std::uint32_t before = same.further_lines.empty() ? same.first->line : same.further_lines.back();
    if (d.line != before) {
      same.further_lines.push_back(d.line);
    }
  }
  return all;
}

Message repeats_text(const RepeatedDiagnostic& diagnostic) {
  constexpr std::size_t most_lines = 10;
  const std::size_t shown = std::min(diagnostic.further_lines.size(), most_lines);
  std::vector<Message> numbers;
  for (const std::uint32_t line : std::span(diagnostic.further_lines).first(shown)) {
    numbers.push_back(Message::number(std::to_string(line)));
  }
  const Message also = shown == 0   ? Message()
                       : shown == 1 ? message(NC_("core", "also in line {}"), numbers.front())
                                    : message(NC_("core", "also in lines {}"), listed(numbers));
  const std::uint64_t rest = diagnostic.unlisted + (diagnostic.further_lines.size() - shown);
  if (rest == 0) {
    return also;
  }
  const std::uint32_t last = std::max(diagnostic.last_line, shown == 0 ? 0 : diagnostic.further_lines.back());
  const Message more = message(NC_("core", "{} more up to line {}"), rest, last);
  return also.empty() ? more : message(NC_("core", "{}; {}"), also, more);
}

std::string format(const Diagnostic& d, std::string_view file) {
  std::string place(d.file.empty() ? file : d.file);
  if (d.line > 0) {
    place += fmt::format(":{}", d.line);
    if (d.column > 0) {
      place += fmt::format(":{}", d.column);
    }
  }
  const std::string hint = d.hint.empty() ? "" : fmt::format(" ({})", d.hint.english());
  return fmt::format("{}: {}: {} [{}]{}", place, to_string(d.severity), d.message.english(), d.code, hint);
}

}  // namespace feedscope

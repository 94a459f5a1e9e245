#include "ui/program_text/diagnostic_marks.h"

#include <QStringList>
#include <algorithm>
#include <tuple>

#include "core/program/text/scanner.h"
#include "ui/language/in_language.h"

namespace feedscope::ui {

DiagnosticMarks::DiagnosticMarks(const Program& program) {
  for (const Diagnostic& diagnostic : program.diagnostics) {
    if (diagnostic.line > 0 && diagnostic.file.empty()) {
      marks_.push_back(&diagnostic);
    }
  }
  std::ranges::stable_sort(marks_, {}, [](const Diagnostic* d) { return std::tuple(d->line, d->column); });
}

std::span<const Diagnostic* const> DiagnosticMarks::of(std::uint32_t first, std::uint32_t last) const {
  const auto line = [](const Diagnostic* d) { return d->line; };
  const auto begin = std::ranges::lower_bound(marks_, first, {}, line);
  const auto end = std::ranges::upper_bound(begin, marks_.end(), last, {}, line);
  return {begin, end};
}

QString DiagnosticMarks::tip(std::uint32_t line) const {
  QStringList tip;
  for (const Diagnostic* diagnostic : of(line)) {
    tip.append(in_language(diagnostic->message));
    if (!diagnostic->hint.empty()) {
      tip.append(in_language(diagnostic->hint));
    }
  }
  return tip.join('\n');
}

ByteRange marked_bytes(std::string_view line, std::uint32_t column, std::span<const Token> tokens) {
  const auto size = static_cast<std::uint32_t>(line.size());
  if (column == 0) {
    const std::size_t first = line.find_first_not_of(" \t");
    return {first == std::string_view::npos ? 0 : static_cast<std::uint32_t>(first), size};
  }
  const std::uint32_t from = std::min(column - 1, size);
  std::uint32_t to = from;
  std::uint32_t limit = size;
  for (const Token& token : tokens) {
    if (token.from > from) {
      limit = token.from;
      break;
    }
    to = std::clamp(token.from + token.length, to, size);
  }
  while (to < limit && !letters::is_blank(line[to])) {
    ++to;
  }
  return {from, to};
}

Severity worst_of(std::span<const Diagnostic* const> diagnostics) {
  Severity worst = Severity::info;
  for (const Diagnostic* diagnostic : diagnostics) {
    worst = std::max(worst, diagnostic->severity);
  }
  return worst;
}

}  // namespace feedscope::ui

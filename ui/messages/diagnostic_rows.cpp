#include "ui/messages/diagnostic_rows.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace feedscope::ui {

std::vector<DiagnosticRow> diagnostic_rows(const std::vector<Diagnostic>& diagnostics) {
  std::map<const Diagnostic*, const RepeatedDiagnostic*> first;
  const std::vector<RepeatedDiagnostic> said = without_repeats(diagnostics);
  for (const RepeatedDiagnostic& one : said) {
    first[one.first] = &one;
  }
  // Whether a closing line of without_repeats() is of a kind that is listed once; such lines are omitted.
  const auto kept_once = [&](const Diagnostic& closing) {
    return std::ranges::any_of(said, [&](const RepeatedDiagnostic& one) {
      return one.unlisted > 0 && one.further_lines.empty() && one.first->code == closing.code &&
             one.first->detail == closing.detail && one.first->severity == closing.severity &&
             one.first->file == closing.file;
    });
  };
  std::vector<DiagnosticRow> rows;
  for (std::uint32_t i = 0; i < diagnostics.size(); ++i) {
    const Diagnostic& diagnostic = diagnostics[i];
    const bool closing = diagnostic.count > 1 || diagnostic.last_line > 0;
    const auto found = first.find(&diagnostic);
    if (closing && found == first.end() && kept_once(diagnostic)) {
      continue;
    }
    DiagnosticRow row{i};
    if (found != first.end() && found->second->further_lines.empty()) {
      row.more = found->second->unlisted;
      row.last_line = found->second->last_line;
    }
    rows.push_back(row);
  }
  std::ranges::stable_sort(rows, {}, [&](const DiagnosticRow& row) {
    const Diagnostic& diagnostic = diagnostics[row.index];
    return std::tie(diagnostic.file, diagnostic.line, diagnostic.column);
  });
  return rows;
}

}  // namespace feedscope::ui

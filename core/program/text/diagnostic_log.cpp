#include "core/program/text/diagnostic_log.h"

#include <algorithm>

namespace feedscope {

bool DiagnosticLog::admit(Severity severity, MessageCode code, int detail, Place place) {
  Kind& kind = kinds_[{code.text(), detail}];
  kind.severity = std::max(kind.severity, severity);
  const std::pair at{place.line, place.column};
  if (std::find(kind.places.begin(), kind.places.begin() + kind.kept, at) !=
      kind.places.begin() + kind.kept) {
    return false;
  }
  const std::uint32_t limit = severity == Severity::info ? kept_of_an_info : kept_of_a_kind;
  if (kind.kept < limit) {
    kind.places[kind.kept++] = at;
    return true;
  }
  if (++kind.left_out == 1) {
    kind.first_left_out = place.line;
  }
  kind.last_left_out = std::max(kind.last_left_out, place.line);
  return false;
}

std::vector<Diagnostic> DiagnosticLog::take() {
  for (const auto& [key, kind] : kinds_) {
    if (kind.left_out > 0) {
      diagnostics_.push_back(
          {kind.severity,
           kind.first_left_out,
           0,
           std::string(key.first),
           message(NC_("core", "{} more of this kind up to line {}"), kind.left_out, kind.last_left_out),
           {},
           {},
           kind.left_out,
           kind.last_left_out,
           key.second});
    }
  }
  kinds_.clear();
  std::stable_sort(diagnostics_.begin(), diagnostics_.end(), [](const Diagnostic& a, const Diagnostic& b) {
    return std::pair(a.line, a.column) < std::pair(b.line, b.column);
  });
  return std::exchange(diagnostics_, {});
}

}  // namespace feedscope

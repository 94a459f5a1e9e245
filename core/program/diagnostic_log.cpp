#include "core/program/diagnostic_log.h"

#include <fmt/format.h>

#include <algorithm>

namespace feedscope {

bool DiagnosticLog::admit(Severity severity, std::string_view code, int detail, Place place) {
  Kind& kind = kinds_[{code, detail}];
  kind.severity = std::max(kind.severity, severity);
  if (++kind.count <= kept_of_a_kind) {
    return true;
  }
  if (kind.count == kept_of_a_kind + 1) {
    kind.first_left_out = place.line;
  }
  kind.last_left_out = place.line;
  return false;
}

std::vector<Diagnostic> DiagnosticLog::take() {
  for (const auto& [key, kind] : kinds_) {
    if (kind.count > kept_of_a_kind) {
      diagnostics_.push_back({kind.severity, kind.first_left_out, 0, std::string(key.first),
                              fmt::format("{} more like the ones before, up to line {}",
                                          kind.count - kept_of_a_kind, kind.last_left_out),
                              ""});
    }
  }
  kinds_.clear();
  std::stable_sort(diagnostics_.begin(), diagnostics_.end(),
                   [](const Diagnostic& a, const Diagnostic& b) { return a.line < b.line; });
  return std::exchange(diagnostics_, {});
}

}  // namespace feedscope

#include "core/base/diagnostic.h"

#include <fmt/format.h>

#include <algorithm>

namespace feedscope {

std::string_view to_string(Severity severity) {
  switch (severity) {
    case Severity::info:
      return "info";
    case Severity::warning:
      return "warning";
    case Severity::error:
      return "error";
  }
  return "error";
}

bool has_errors(const std::vector<Diagnostic>& diagnostics) {
  return std::any_of(diagnostics.begin(), diagnostics.end(),
                     [](const Diagnostic& d) { return d.severity == Severity::error; });
}

std::string format(const Diagnostic& d, std::string_view file) {
  std::string place(d.file.empty() ? file : d.file);
  if (d.line > 0) {
    place += fmt::format(":{}", d.line);
    if (d.column > 0) {
      place += fmt::format(":{}", d.column);
    }
  }
  const std::string hint = d.hint.empty() ? "" : fmt::format(" ({})", d.hint);
  return fmt::format("{}: {}: {} [{}]{}", place, to_string(d.severity), d.message, d.code, hint);
}

}  // namespace feedscope

#pragma once

#include <cstdint>
#include <vector>

#include "core/base/diagnostic.h"

namespace feedscope::ui {

/// A row in the list of messages.
struct DiagnosticRow {
  std::uint32_t index = 0;      ///< in the diagnostics
  std::uint64_t more = 0;       ///< number of further places that it represents
  std::uint32_t last_line = 0;  ///< last of these; 0: none
};

/// Diagnostics of the program by place, then those of other files. A closing line that counts the rest of a
/// kind becomes `more` of the only message of this kind.
std::vector<DiagnosticRow> diagnostic_rows(const std::vector<Diagnostic>& diagnostics);

}  // namespace feedscope::ui

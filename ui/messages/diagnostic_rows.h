#pragma once

#include <cstdint>
#include <vector>

#include "core/base/diagnostic.h"

namespace feedscope::ui {

/// One row of the list of messages.
struct DiagnosticRow {
  std::uint32_t index = 0;      ///< among the diagnostics
  std::uint64_t more = 0;       ///< places that it stands for beside its own
  std::uint32_t last_line = 0;  ///< of these; 0: there are none
};

/// Of the program by place, then those of other files. A closing line that counts the rest of a kind becomes
/// `more` of the one message that was kept of this kind.
std::vector<DiagnosticRow> diagnostic_rows(const std::vector<Diagnostic>& diagnostics);

}  // namespace feedscope::ui

#pragma once

#include <string>

#include "core/analysis/agreement/agreement.h"

namespace feedscope {

/// A trace as JSON: keys in README.md next to this file.
std::string trace_json(const Trace& trace);
/// A trace compared with a run of its program, likewise.
std::string trace_json(const Trace& trace, const TraceOnProgram& found, const Agreement& agreement,
                       const Run& run);

}  // namespace feedscope

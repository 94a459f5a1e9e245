#pragma once

#include <string>

#include "core/analysis/agreement/agreement.h"

namespace feedscope {

/// A trace that was read, as JSON: keys of README.md beside this file.
std::string trace_json(const Trace& trace);
/// The same beside a run of its program.
std::string trace_json(const Trace& trace, const TraceOnProgram& found, const Agreement& agreement,
                       const Run& run);

}  // namespace feedscope

#pragma once

#include <string>

#include "app/run_options.h"
#include "core/analysis/time/time_report.h"

namespace feedscope {

/// Where the time of a run goes, and which changes would help, for people. `program` and `asked` (the options
/// of the run; null for a run of a session) are used to print the commands that make the changes.
std::string explanation_text(const Run& run, const TimeReport& report, const ProgramOptions& program,
                             const RunOptions* asked);

}  // namespace feedscope

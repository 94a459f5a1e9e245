#pragma once

#include <string>

#include "app/run_options.h"
#include "core/analysis/time_use/time_report.h"

namespace feedscope {

/// Where the time of a run goes and what would help, for people. For the commands that make the changes:
/// `program` and how it is read, and `asked`, what asked for the run; null for a run of a session.
std::string explanation_text(const Run& run, const TimeReport& report, const ProgramOptions& program,
                             const RunOptions* asked);

}  // namespace feedscope

#pragma once

#include <string>

#include "core/analysis/time_use/time_report.h"

namespace feedscope {

/// Where the time of a run goes and what would help, for people.
std::string explanation_text(const Run& run, const TimeReport& report);

}  // namespace feedscope

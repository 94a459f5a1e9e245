#pragma once

#include <string>

#include "core/analysis/difference/program_difference.h"

namespace feedscope {

/// Two programs on one setup for people: cycle times, the changes of the path, and the places of the
/// difference.
std::string program_difference_text(const Run& old, const Run& now, const ProgramDifference& difference);

}  // namespace feedscope

#pragma once

#include <vector>

#include "core/analysis/time/line_times.h"
#include "core/identification/identification_program.h"

namespace feedscope {

/// Time of each part of a test program in a run of it.
std::vector<LineTime> part_times(const IdentificationProgram& program, const Trajectory& run);

}  // namespace feedscope

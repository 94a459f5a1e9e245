#pragma once

#include <vector>

#include "core/analysis/line_times.h"
#include "core/identification/identification_program.h"

namespace feedscope {

/// What each part of a test program takes in a run of it.
std::vector<LineTime> part_times(const IdentificationProgram& program, const Trajectory& run);

}  // namespace feedscope

#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/analysis/study/compare.h"

namespace feedscope {

/// Figures of several runs for people, in lines of at most 120 characters unless names are long: times,
/// largest values in percent of the limits, time by limiting cause; each machine above its runs.
/// `assignments`: those of --set, named in the heading.
std::string comparison_text(const LoadedProgram& program, std::span<const ComparedRun> runs,
                            const std::vector<std::string>& assignments);

}  // namespace feedscope

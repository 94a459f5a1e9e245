#pragma once

#include <string>
#include <vector>

#include "core/analysis/run/run.h"

namespace feedscope {

/// Parts of the program's path control that a run does not follow, one sentence each, in a fixed order; empty
/// if it follows all of them. Tolerances that the setup replaces on purpose are not listed.
std::vector<Message> ignored_path_control(const Toolpath& toolpath, const Setup& setup);

/// As above for a program as it was read; a run also turns its curves into arcs.
std::vector<Message> ignored_path_control(const LoadedProgram& program, const Setup& setup);

}  // namespace feedscope

#pragma once

#include <string>
#include <vector>

#include "core/analysis/run.h"

namespace feedscope {

/// What of the program's path control a run does not follow, one sentence each, in a fixed order; empty where
/// it follows all that the program asks for. Tolerances that the setup replaces on purpose are not named.
std::vector<Message> ignored_path_control(const Toolpath& toolpath, const Setup& setup);

/// The same of a program as it was read, and what a run makes of its curves: they are arcs by then.
std::vector<Message> ignored_path_control(const LoadedProgram& program, const Setup& setup);

}  // namespace feedscope

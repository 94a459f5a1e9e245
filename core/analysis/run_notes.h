#pragma once

#include <string>
#include <vector>

#include "core/analysis/run.h"

namespace feedscope {

/// What is to be known of a run before its figures are trusted, one sentence each: a control that does not
/// read the program's dialect, then unfollowed().
std::vector<std::string> run_notes(const LoadedProgram& program, const Setup& setup);

}  // namespace feedscope

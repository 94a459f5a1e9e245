#pragma once

#include <string>
#include <vector>

#include "core/analysis/run.h"

namespace feedscope {

/// The work offsets that the machine file gives and the program uses, but was not read with, as it is when
/// several machines run it: "G54, G55"; empty: none.
std::string unused_work_offsets(const Program& program, const Machine& machine);

/// What is to be known of a run before its figures are trusted, one sentence each: a control that does not
/// read the program's dialect, a machine that gives work offsets which the program was not read with, then
/// ignored_path_control().
std::vector<std::string> run_notes(const LoadedProgram& program, const Setup& setup);

}  // namespace feedscope

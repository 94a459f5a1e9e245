#pragma once

#include <string>
#include <vector>

#include "core/analysis/run/run.h"

namespace feedscope {

/// Lines of `program` that the control of `setup` refuses, as notes: of a run Run::lines_not_run.
std::vector<Diagnostic> refused_lines(const LoadedProgram& program, const Setup& setup);

/// Whether the program has feed motions and the control refuses so many lines that none of them runs,
/// whatever the time of rapids and dwells.
bool is_refused(const Run& run);

/// Whether the program leads the machine out of reach (an error in MachinePath::faults): a control
/// refuses such a block.
bool is_out_of_reach(const Run& run);

/// Numbers of the first of these lines: "5, 9, 20 to 22 and 7 more".
Message line_list(const std::vector<Diagnostic>& lines);

/// Number and list of the lines that the control refuses; empty if none.
Message refused_note(const std::vector<Diagnostic>& lines);

}  // namespace feedscope

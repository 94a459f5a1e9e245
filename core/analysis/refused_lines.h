#pragma once

#include <string>
#include <vector>

#include "core/analysis/run.h"

namespace feedscope {

/// The lines of `program` that the control of `setup` refuses, as notes. `program`: as it was loaded, or the
/// input of a run with this setup.
std::vector<Diagnostic> refused_lines(const LoadedProgram& program, const Setup& setup);

/// The same for any control, whichever one has read `program`.
std::vector<Diagnostic> refused_as_written(const LoadedProgram& program, const Setup& setup);

/// Whether the program has feed motions, and the control refuses so many lines that none of them is run,
/// whatever time rapids and dwells take.
bool is_refused(const Run& run);

/// Whether the program sends the machine where it cannot go (an error in Toolpath::machine_faults): a control
/// refuses such a block.
bool is_out_of_reach(const Run& run);

/// "5, 9, 20 to 22 and 7 more": numbers of the first of these lines.
Message line_list(const std::vector<Diagnostic>& lines);

/// How many lines the control refuses, and which; empty for none.
Message refused_note(const std::vector<Diagnostic>& lines);

}  // namespace feedscope

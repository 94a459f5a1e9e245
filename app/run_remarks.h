#pragma once

#include "app/run_options.h"
#include "core/analysis/run.h"

namespace feedscope {

/// Tells on standard error what is to be known of one run: whether `asked` replaces the program's tolerances,
/// what of `reading` is not used, note_runs(), and the messages on the program, on lines that the control
/// refuses and on what the machine cannot do.
void tell_of_run(const Run& run, const RunOptions& asked, const ReadOptions& reading);
/// Prints on standard error the messages on the program of a run, on lines that the control refuses and on
/// what the machine cannot do.
void print_messages(const Run& run);
/// exit_code::program_errors of a run whose program has errors, or whose machine does not reach all
/// positions.
int exit_code_of(const Run& run);

}  // namespace feedscope

#pragma once

#include "app/run_options.h"
#include "core/analysis/run/run.h"

namespace feedscope {

/// Prints the notes on one run to standard error: whether `asked` replaces the program's tolerances, the
/// unused part of `reading`, note_runs(), and print_messages().
void tell_of_run(const Run& run, const RunOptions& asked, const ReadOptions& reading);
/// Prints to standard error the messages on the program of a run, on refused lines and on positions or
/// motions that the machine cannot do.
void print_messages(const Run& run);
/// exit_code::program_errors for a run with errors in its program or positions out of the machine's reach.
int exit_code_of(const Run& run);

}  // namespace feedscope

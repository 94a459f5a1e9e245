#include "app/run_remarks.h"

#include "app/exit_codes.h"
#include "app/print.h"
#include "core/analysis/notes/refused_lines.h"

namespace feedscope {

void tell_of_run(const Run& run, const RunOptions& asked, const ReadOptions& reading) {
  if (!asked.tolerance.empty()) {
    note_unused_tolerances({asked.tolerance}, {run.setup});
    note_replaced_tolerance(*run.input.toolpath, {run.setup});
  }
  note_unused_reading(*run.input.program, reading);
  note_runs(run.input, {run.setup});
  print_messages(run);
}

void print_messages(const Run& run) {
  print_diagnostics(*run.input.program);
  print_diagnostics(run.input.lines_not_run, *run.input.program);
  print_diagnostics(run.input.toolpath->machine_faults, *run.input.program);
}

int exit_code_of(const Run& run) {
  return has_errors(run.input.program->diagnostics) || is_out_of_reach(run) ? exit_code::program_errors
                                                                            : exit_code::done;
}

}  // namespace feedscope

#include "app/run_remarks.h"

#include "app/print.h"

namespace feedscope {

void tell_of_run(const Run& run, const RunOptions& asked, const ReadOptions& reading) {
  if (!asked.tolerance.empty()) {
    note_replaced_tolerance(*run.input.toolpath, {run.setup});
  }
  note_unused_reading(*run.input.program, reading);
  note_runs(run.input, {run.setup});
  print_diagnostics(*run.input.program);
  print_diagnostics(run.input.lines_not_run, *run.input.program);
  print_diagnostics(run.input.toolpath->machine_faults, *run.input.program);
}

}  // namespace feedscope

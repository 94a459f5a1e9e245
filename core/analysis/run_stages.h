#pragma once

#include "core/analysis/run.h"

namespace feedscope {

/// The first stage of simulate_run(): the motion; the summary stays empty. Throws what ControlModel::simulate
/// throws.
Run simulate_motion(const LoadedProgram& input, Setup setup, Progress* progress = nullptr);
/// The second one. Others may read the run's motion meanwhile.
void add_summary(Run& run, Progress* progress = nullptr);
/// The same motion with its tools engaged in another way. Throws InputError as LoadModel, and Cancelled.
Run with_load(Run run, LoadSetup load, Progress* progress = nullptr);

}  // namespace feedscope

#pragma once

#include "core/analysis/run/run.h"

namespace feedscope {

/// First stage of simulate_run(): the motion, with an empty summary. Throws as ControlModel::simulate does.
Run simulate_motion(const LoadedProgram& input, Setup setup, Progress* progress = nullptr);
/// Second stage. Other threads may read the run's motion meanwhile.
void add_summary(Run& run, Progress* progress = nullptr);
/// Same motion with another engagement of the tools. Throws InputError as LoadModel does, and Cancelled.
Run with_load(Run run, LoadSetup load, Progress* progress = nullptr);

}  // namespace feedscope

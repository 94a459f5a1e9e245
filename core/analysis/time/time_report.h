#pragma once

#include "core/analysis/time/program_changes.h"
#include "core/analysis/time/slow_groups.h"
#include "core/analysis/time/time_use.h"

namespace feedscope {

/// Time of a run by cause and the changes that reduce it, as shown by `explain`, the window and the report.
struct TimeReport {
  TimeUse use;
  SlowGroups slow;
  ChangeTrials changes;
};

/// The run must have its summary. `split`: as for time_use(). Throws Cancelled.
TimeReport time_report(const Run& run, OperationSplit split = OperationSplit::none,
                       Progress* progress = nullptr);

}  // namespace feedscope

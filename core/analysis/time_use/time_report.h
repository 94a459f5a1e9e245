#pragma once

#include "core/analysis/time_use/program_changes.h"
#include "core/analysis/time_use/slow_groups.h"
#include "core/analysis/time_use/time_use.h"

namespace feedscope {

/// Where the time of a run goes, and what would help: everything that `explain`, the window and the report
/// show of it.
struct TimeReport {
  TimeUse use;
  SlowGroups slow;
  ChangeTrials changes;
};

/// Of a run with its summary. `split` as of time_use(). Throws Cancelled.
TimeReport time_report(const Run& run, OperationSplit split = OperationSplit::none,
                       Progress* progress = nullptr);

}  // namespace feedscope

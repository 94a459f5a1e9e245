#include "core/analysis/time_use/time_report.h"

namespace feedscope {

TimeReport time_report(const Run& run, OperationSplit split, Progress* progress) {
  TimeReport report;
  report.use = time_use(run, split, progress);
  report.slow = find_slow_groups(*run.trajectory, progress);
  report.changes = try_changes(run, changes_worth_trying(run, report.use), progress);
  return report;
}

}  // namespace feedscope

#include "core/analysis/time_use/time_report.h"

#include "core/analysis/refused_lines.h"

namespace feedscope {

TimeReport time_report(const Run& run, OperationSplit split, Progress* progress) {
  TimeReport report;
  report.use = time_use(run, split, progress);
  report.slow = find_slow_groups(*run.trajectory, progress);
  if (is_refused(run)) {
    return report;
  }
  report.changes = try_changes(run, changes_worth_trying(run, report.use), progress);
  return report;
}

}  // namespace feedscope

#include "core/analysis/time/time_report.h"

#include "core/analysis/notes/refused_lines.h"

namespace feedscope {

TimeReport time_report(const Run& run, OperationSplit split, Progress* progress) {
  Progress unwatched;
  Progress& whole = progress != nullptr ? *progress : unwatched;
  TimeReport report;
  {
    constexpr double quick = 0.02;  // compared with simulating the changes
    Progress part(whole, quick);
    report.use = time_use(run, split, &part);
    part.report(0);
    report.slow = find_slow_groups(*run.trajectory, &part);
    part.report(1);
  }
  if (!is_refused(run)) {
    Progress part(whole, 1 - whole.fraction());
    report.changes = try_changes(run, changes_worth_trying(run, report.use), &part);
  }
  whole.report(1);
  return report;
}

}  // namespace feedscope

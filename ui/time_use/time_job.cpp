#include "ui/time_use/time_job.h"

#include <utility>

namespace feedscope::ui {

TimeJob::TimeJob(QObject* parent) : QObject(parent) {
  connect(&job_, &JobBase::progressed, this, &TimeJob::progressed);
}

void TimeJob::start(std::shared_ptr<const ShownRun> shown, bool with_changes) {
  job_.start(
      [this, shown = std::move(shown), with_changes](JobControl& control) {
        Progress unwatched(control.progress, 1e-9);  // what comes first takes no time worth a bar
        TimeReport report;
        report.use = time_use(shown->run, OperationSplit::none, &unwatched);
        report.slow = find_slow_groups(*shown->run.trajectory, &unwatched);
        auto first = std::make_shared<const TimeReport>(report);
        control.tell([this, first] { emit used(first); });
        if (!with_changes || !(report.use.cycle_time > 0)) {
          return first;
        }
        report.changes =
            try_changes(shown->run, changes_worth_trying(shown->run, report.use), &control.progress);
        return std::make_shared<const TimeReport>(std::move(report));
      },
      [this](const JobOutcome<std::shared_ptr<const TimeReport>>& outcome) {
        if (outcome.result) {
          emit done(*outcome.result);
        }
        emit ended(outcome.failure);
      });
}

}  // namespace feedscope::ui

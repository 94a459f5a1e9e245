#include "ui/workbench/time_job.h"

#include <utility>

namespace feedscope::ui {

TimeJob::TimeJob(QObject* parent) : QObject(parent) {
  connect(&job_, &JobBase::progressed, this, &TimeJob::progressed);
}

void TimeJob::look(std::shared_ptr<const ShownRun> shown) {
  job_.start(
      [shown = std::move(shown)](JobControl& control) {
        auto report = std::make_shared<TimeReport>();
        report->use = time_use(shown->run, OperationSplit::none, &control.progress);
        report->slow = find_slow_groups(*shown->run.trajectory, &control.progress);
        return std::shared_ptr<const TimeReport>(std::move(report));
      },
      [this](const auto& outcome) { deliver(outcome); });
}

void TimeJob::try_changes(std::shared_ptr<const ShownRun> shown, std::shared_ptr<const TimeReport> report) {
  job_.start(
      [shown = std::move(shown), report = std::move(report)](JobControl& control) {
        auto whole = std::make_shared<TimeReport>(*report);
        whole->changes = feedscope::try_changes(shown->run, changes_worth_trying(shown->run, report->use),
                                                &control.progress);
        return std::shared_ptr<const TimeReport>(std::move(whole));
      },
      [this](const auto& outcome) { deliver(outcome); });
}

void TimeJob::deliver(const JobOutcome<std::shared_ptr<const TimeReport>>& outcome) {
  if (outcome.result) {
    emit done(*outcome.result);
  }
  emit ended(outcome.failure);
}

}  // namespace feedscope::ui

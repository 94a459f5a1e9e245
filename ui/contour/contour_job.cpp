#include "ui/contour/contour_job.h"

#include <algorithm>
#include <utility>

namespace feedscope::ui {

void ContourJob::want(std::vector<std::shared_ptr<const ShownRun>> runs) {
  wanted_ = std::move(runs);
  std::erase_if(reports_, [](const auto& entry) { return entry.first.expired(); });
  if (!busy()) {
    start_next();
  } else if (std::ranges::find(wanted_, under_way_) == wanted_.end()) {
    job_.cancel();
  }
}

std::shared_ptr<const ContourReport> ContourJob::report(const std::shared_ptr<const ShownRun>& run) const {
  const auto found = reports_.find(run);
  return found == reports_.end() ? nullptr : found->second;
}

void ContourJob::start_next() {
  const auto next = std::ranges::find_if(
      wanted_, [this](const auto& run) { return run != nullptr && !reports_.contains(run); });
  if (next == wanted_.end()) {
    return;
  }
  under_way_ = *next;
  job_.start(
      [run = under_way_](JobControl& control) -> Result {
        return std::make_shared<const ContourReport>(contour_report(run->run, max_places, &control.progress));
      },
      [this](const JobOutcome<Result>& outcome) { take(outcome); });
}

void ContourJob::take(const JobOutcome<Result>& outcome) {
  const auto run = std::exchange(under_way_, nullptr);
  if (!outcome.cancelled()) {
    reports_.insert_or_assign(run, outcome.result.value_or(nullptr));
  }
  start_next();
  if (!outcome.cancelled()) {
    emit changed();
  }
}

}  // namespace feedscope::ui

#include "ui/models/contour_job.h"

#include <QtConcurrentRun>
#include <algorithm>
#include <new>
#include <utility>

namespace feedscope::ui {

ContourJob::ContourJob(QObject* parent) : QObject(parent) {
  connect(&watcher_, &QFutureWatcher<Result>::finished, this, &ContourJob::deliver);
}

ContourJob::~ContourJob() {
  want({});
  watcher_.waitForFinished();
}

void ContourJob::want(std::vector<std::shared_ptr<const ShownRun>> runs) {
  wanted_ = std::move(runs);
  std::erase_if(reports_, [](const auto& entry) { return entry.first.expired(); });
  if (!busy()) {
    launch();
  } else if (std::ranges::find(wanted_, under_way_) == wanted_.end()) {
    progress_->cancel();
  }
}

std::shared_ptr<const ContourReport> ContourJob::report(const std::shared_ptr<const ShownRun>& run) const {
  const auto found = reports_.find(run);
  return found == reports_.end() ? nullptr : found->second;
}

void ContourJob::launch() {
  const auto next = std::ranges::find_if(
      wanted_, [this](const auto& run) { return run != nullptr && !reports_.contains(run); });
  if (next == wanted_.end()) {
    return;
  }
  under_way_ = *next;
  progress_ = std::make_shared<Progress>();
  watcher_.setFuture(QtConcurrent::run([run = under_way_, progress = progress_]() -> Result {
    try {
      return std::make_shared<const ContourReport>(contour_report(run->run, most_places, progress.get()));
    } catch (const Cancelled&) {
    } catch (const std::bad_alloc&) {
    }
    return nullptr;
  }));
}

void ContourJob::deliver() {
  const bool cancelled = progress_->cancelled();
  const auto run = std::exchange(under_way_, nullptr);
  progress_.reset();
  const Result report = watcher_.result();
  if (!cancelled) {
    reports_.insert_or_assign(run, report);
  }
  launch();
  if (!cancelled) {
    emit changed();
  }
}

}  // namespace feedscope::ui

#include "ui/why/remedy_job.h"

#include <utility>

namespace feedscope::ui {

namespace {

RemedyTrial try_one(const RemedyRequest& request, const Remedy& remedy, Progress& progress) {
  RemedyTrial trial;
  trial.failure = failure_of([&] {
    const Trajectory changed = try_remedy(request.run.input, request.run.setup, remedy, &progress);
    trial.cycle_time = changed.duration();
    trial.passage_time = passage_time(changed, request.here);
  });
  return trial;
}

}  // namespace

void RemedyJob::start(RemedyRequest request) {
  job_.start(
      [this, request = std::move(request)](JobControl& control) {
        for (std::size_t i = 0; i < request.remedies.size(); ++i) {
          const RemedyTrial trial = try_one(request, request.remedies[i], control.progress);
          if (control.progress.cancelled()) {
            break;
          }
          control.tell([this, i, trial] { emit tried(i, trial); });
        }
        return AllTried{};
      },
      [this](const JobOutcome<AllTried>&) { emit finished(); });
}

}  // namespace feedscope::ui

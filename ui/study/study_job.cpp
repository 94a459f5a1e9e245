#include "ui/study/study_job.h"

#include <utility>
#include <vector>

namespace feedscope::ui {

StudyJob::StudyJob(QObject* parent) : QObject(parent) {
  connect(&job_, &JobBase::progressed, this, &StudyJob::progressed);
}

void StudyJob::start(const StudyJobRequest& request) {
  std::vector<Setup> setups(request.sweep.values.size(), request.setup);
  for (std::size_t i = 0; i < setups.size(); ++i) {
    apply_swept(request.sweep.key, request.sweep.values[i], setups[i]);
  }
  job_.start(
      [request, setups = std::move(setups)](JobControl& control) -> Result {
        auto study = std::make_shared<Study>();
        study->sweeps = {request.sweep};
        study->within = request.within;
        for (ComparedRun& run : compare_runs(request.program, setups, &control.progress)) {
          const double value = request.sweep.values[study->runs.size()];
          study->runs.push_back({std::move(run), {value}, {}});
        }
        return study;
      },
      [this](const JobOutcome<Result>& outcome) { deliver(outcome); });
}

void StudyJob::deliver(const JobOutcome<Result>& outcome) {
  if (outcome.result) {
    emit finished(*outcome.result);
  } else if (outcome.cancelled()) {
    emit cancelled();
  } else {
    emit failed(outcome.failure);
  }
}

}  // namespace feedscope::ui

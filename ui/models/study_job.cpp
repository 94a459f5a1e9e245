#include "ui/models/study_job.h"

#include <QtConcurrentRun>
#include <chrono>
#include <new>
#include <utility>

namespace feedscope::ui {

namespace {

constexpr std::chrono::milliseconds between_reports(100);

}  // namespace

StudyJob::StudyJob(QObject* parent) : QObject(parent) {
  poll_.setInterval(between_reports);
  connect(&poll_, &QTimer::timeout, this, [this] { emit progressed(progress_->fraction()); });
  connect(&watcher_, &QFutureWatcher<Outcome>::finished, this, &StudyJob::deliver);
}

StudyJob::~StudyJob() {
  cancel();
  watcher_.waitForFinished();
}

void StudyJob::start(const StudyJobRequest& request) {
  std::vector<Setup> setups(request.sweep.values.size(), request.setup);
  for (std::size_t i = 0; i < setups.size(); ++i) {
    apply_swept(request.sweep.key, request.sweep.values[i], setups[i]);
  }
  progress_ = std::make_shared<Progress>();
  poll_.start();
  watcher_.setFuture(QtConcurrent::run([request, setups, progress = progress_]() -> Outcome {
    try {
      auto study = std::make_shared<Study>();
      study->sweeps = {request.sweep};
      study->within = request.within;
      for (ComparedRun& run : compare_runs(request.program, setups, progress.get())) {
        const double value = request.sweep.values[study->runs.size()];
        study->runs.push_back({std::move(run), {value}, {}});
      }
      return {study, {}};
    } catch (const Cancelled&) {
      return {};
    } catch (const std::bad_alloc&) {
      return {nullptr, tr("The program needs more memory than there is.")};
    } catch (const std::exception& error) {
      return {nullptr, QString::fromUtf8(error.what())};
    }
  }));
}

void StudyJob::cancel() {
  if (progress_ != nullptr) {
    progress_->cancel();
  }
}

void StudyJob::deliver() {
  poll_.stop();
  const bool is_cancelled = std::exchange(progress_, nullptr)->cancelled();
  const Outcome outcome = watcher_.result();
  if (is_cancelled) {
    emit cancelled();
  } else if (outcome.study != nullptr) {
    emit finished(outcome.study);
  } else if (outcome.failure.isEmpty()) {
    emit cancelled();
  } else {
    emit failed(outcome.failure);
  }
}

}  // namespace feedscope::ui

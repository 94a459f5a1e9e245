#include "ui/models/remedy_job.h"

#include <QtConcurrentRun>
#include <new>
#include <utility>

namespace feedscope::ui {

RemedyJob::RemedyJob(QObject* parent) : QObject(parent) {
  connect(&watcher_, &QFutureWatcher<void>::finished, this, [this] {
    running_ = false;
    if (next_) {
      launch();
    } else {
      emit finished();
    }
  });
}

RemedyJob::~RemedyJob() {
  cancel();
  watcher_.waitForFinished();
}

void RemedyJob::start(RemedyRequest request) {
  cancel();
  next_ = std::move(request);
  if (!running_) {
    launch();
  }
}

void RemedyJob::cancel() {
  next_.reset();
  if (progress_ != nullptr) {
    progress_->cancel();
  }
}

void RemedyJob::launch() {
  running_ = true;
  progress_ = std::make_shared<Progress>();
  watcher_.setFuture(QtConcurrent::run([this, request = *std::exchange(next_, std::nullopt),
                                        progress = progress_] { work(request, progress); }));
}

void RemedyJob::work(const RemedyRequest& request, const std::shared_ptr<Progress>& progress) {
  for (std::size_t i = 0; i < request.remedies.size(); ++i) {
    RemedyTrial trial;
    try {
      const Trajectory changed =
          try_remedy(request.run.input, request.run.setup, request.remedies[i], progress.get());
      trial = {changed.duration(), passage_time(changed, request.here), {}};
    } catch (const Cancelled&) {
      return;
    } catch (const std::bad_alloc&) {
      trial.failure = tr("The program needs more memory than there is.");
    } catch (const std::exception& error) {
      trial.failure = QString::fromUtf8(error.what());
    }
    QMetaObject::invokeMethod(this, [this, i, trial, progress] {
      if (!progress->cancelled()) {
        emit tried(i, trial);
      }
    });
  }
}

}  // namespace feedscope::ui

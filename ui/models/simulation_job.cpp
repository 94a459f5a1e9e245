#include "ui/models/simulation_job.h"

#include <QtConcurrentRun>
#include <chrono>
#include <utility>

namespace feedscope::ui {

namespace {

constexpr std::size_t slow_places_kept = 10'000;

}  // namespace

std::shared_ptr<const ShownRun> make_shown(Run run, Progress* progress) {
  auto shown = std::make_shared<ShownRun>();
  shown->run = std::move(run);
  shown->envelope = std::make_shared<const Envelope>(shown->run.trajectory, progress);
  shown->samples = std::make_shared<const SampledPath>(sample_executed(*shown->run.trajectory));
  shown->line_times = std::make_shared<const LineTimes>(*shown->run.trajectory, progress);
  shown->slow_places = std::make_shared<const SlowPlaces>(
      find_slow_places(*shown->run.trajectory, slow_places_kept, progress));
  return shown;
}

SimulationJob::SimulationJob(QObject* parent) : QObject(parent) {
  connect(&watcher_, &QFutureWatcher<Outcome>::finished, this, &SimulationJob::deliver);
  poll_.setInterval(std::chrono::milliseconds(50));
  connect(&poll_, &QTimer::timeout, this, [this] { emit progressed(progress_->fraction()); });
}

SimulationJob::~SimulationJob() {
  cancel();
  watcher_.waitForFinished();
}

void SimulationJob::start(JobRequest request) {
  if (running_) {
    progress_->cancel();
    next_ = std::move(request);
  } else {
    launch(std::move(request));
    emit busy_changed(true);
  }
}

void SimulationJob::cancel() {
  next_.reset();
  if (progress_ != nullptr) {
    progress_->cancel();
  }
}

void SimulationJob::launch(JobRequest request) {
  running_ = true;
  progress_ = std::make_shared<Progress>();
  poll_.start();
  watcher_.setFuture(QtConcurrent::run(
      [this, request = std::move(request), progress = progress_] { return work(request, progress); }));
}

SimulationJob::Outcome SimulationJob::work(const JobRequest& request,
                                           const std::shared_ptr<Progress>& progress) {
  try {
    LoadedProgram input;
    if (const auto* file = std::get_if<std::filesystem::path>(&request.input)) {
      input = load_program(*file, progress.get());
      QMetaObject::invokeMethod(this, [this, input, progress] {
        if (!progress->cancelled()) {
          emit program_read(input);
        }
      });
    } else {
      input = std::get<LoadedProgram>(request.input);
    }
    return make_shown(simulate_run(input, request.setup, progress.get()), progress.get());
  } catch (const Cancelled&) {
    return {};
  } catch (const std::bad_alloc&) {
    return tr("The program needs more memory than there is.");
  } catch (const std::exception& error) {
    return QString::fromUtf8(error.what());
  }
}

void SimulationJob::deliver() {
  poll_.stop();
  if (next_.has_value()) {
    launch(*std::exchange(next_, std::nullopt));
    return;
  }
  running_ = false;
  const bool wanted = !progress_->cancelled();
  const Outcome outcome = watcher_.result();
  emit busy_changed(false);
  if (!wanted) {
    return;
  }
  if (const auto* run = std::get_if<std::shared_ptr<const ShownRun>>(&outcome)) {
    emit finished(*run);
  } else if (const auto* message = std::get_if<QString>(&outcome)) {
    emit failed(*message);
  }
}

}  // namespace feedscope::ui

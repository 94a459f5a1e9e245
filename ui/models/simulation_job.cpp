#include "ui/models/simulation_job.h"

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <QtConcurrentRun>
#include <chrono>
#include <utility>

#include "ui/models/simulate_shown.h"

namespace feedscope::ui {

namespace {

/// What the program before, or a computation, has left, which its allocator would keep.
void give_back_memory() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

}  // namespace

void SimulationJob::Stages::cancel() {
  reading.cancel();
  simulation.cancel();
}

SimulationJob::SimulationJob(QObject* parent) : QObject(parent) {
  connect(&watcher_, &QFutureWatcher<Outcome>::finished, this, &SimulationJob::deliver);
  poll_.setInterval(std::chrono::milliseconds(50));
  connect(&poll_, &QTimer::timeout, this, [this] {
    const bool simulating = stages_->simulating;
    emit progressed(simulating ? JobStage::simulating : JobStage::reading,
                    (simulating ? stages_->simulation : stages_->reading).fraction());
  });
}

SimulationJob::~SimulationJob() {
  cancel();
  watcher_.waitForFinished();
}

void SimulationJob::start(JobRequest request) {
  if (running_) {
    stages_->cancel();
    next_ = std::move(request);
  } else {
    launch(std::move(request));
    emit busy_changed(true);
  }
}

void SimulationJob::cancel() {
  next_.reset();
  if (stages_ != nullptr) {
    stages_->cancel();
  }
}

void SimulationJob::launch(JobRequest request) {
  running_ = true;
  stages_ = std::make_shared<Stages>();
  poll_.start();
  watcher_.setFuture(QtConcurrent::run(
      [this, request = std::move(request), stages = stages_] { return work(request, stages); }));
}

SimulationJob::Outcome SimulationJob::work(const JobRequest& request, const std::shared_ptr<Stages>& stages) {
  try {
    LoadedProgram input;
    if (const auto* file = std::get_if<std::filesystem::path>(&request.input)) {
      give_back_memory();
      input = load_program(*file, &stages->reading, reading_on(request.reading, request.setup.machine));
      QMetaObject::invokeMethod(this, [this, program = make_shown(input), stages] {
        if (!stages->reading.cancelled()) {
          emit program_read(program);
        }
      });
    } else {
      input = std::get<LoadedProgram>(request.input);
    }
    stages->simulating = true;
    Outcome shown = simulate_shown(input, request.setup, &stages->simulation);
    give_back_memory();
    return shown;
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
  const bool wanted = !stages_->reading.cancelled();
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

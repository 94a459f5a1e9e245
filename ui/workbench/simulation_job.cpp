#include "ui/workbench/simulation_job.h"

#include <utility>

#include "core/base/this_process.h"
#include "ui/workbench/simulate_shown.h"

namespace feedscope::ui {

SimulationJob::SimulationJob(QObject* parent) : QObject(parent) {
  connect(&job_, &JobBase::busy_changed, this, &SimulationJob::busy_changed);
  connect(&job_, &JobBase::progressed, this, [this](double fraction) { emit progressed(*stage_, fraction); });
}

void SimulationJob::start(JobRequest request) {
  stage_ = std::make_shared<std::atomic<JobStage>>(JobStage::reading);
  job_.start([this, request = std::move(request),
              stage = stage_](JobControl& control) { return work(request, control, *stage); },
             [this](const JobOutcome<Result>& outcome) {
               if (outcome.result) {
                 emit finished(*outcome.result);
               } else if (!outcome.cancelled()) {
                 emit failed(outcome.failure);
               }
             });
}

/// On another thread: only calls passed to tell() use `this`.
SimulationJob::Result SimulationJob::work(const JobRequest& request, JobControl& control,
                                          std::atomic<JobStage>& stage) {
  LoadedProgram input;
  if (const auto* file = std::get_if<std::filesystem::path>(&request.input)) {
    give_back_memory();
    input = load_program(*file, &control.progress, reading_on(request.reading, request.setup.machine));
    control.tell([this, program = make_shown(input)] { emit program_read(program); });
  } else {
    input = std::get<LoadedProgram>(request.input);
  }
  control.progress.report(0);
  stage = JobStage::simulating;
  const auto tell = [&](const Result& drawn) { control.tell([this, drawn] { emit drawable(drawn); }); };
  Result shown = simulate_shown(input, request.setup, &control.progress, request.before.get(), {}, tell);
  give_back_memory();
  return shown;
}

}  // namespace feedscope::ui

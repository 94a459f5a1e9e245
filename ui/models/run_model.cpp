#include "ui/models/run_model.h"

#include <utility>

#include "core/base/error.h"

namespace feedscope::ui {

RunModel::RunModel(MachineLibrary machines, Setup setup, QObject* parent)
    : QObject(parent), machines_(std::move(machines)), setup_(std::move(setup)), playback_(cursor_) {
  connect(&setup_, &SetupEdit::values_changed, this, &RunModel::simulate);
  connect(&setup_, &SetupEdit::keys_changed, this, &RunModel::simulate);
  connect(&job_, &SimulationJob::busy_changed, this, &RunModel::busy_changed);
  connect(&job_, &SimulationJob::progressed, this, &RunModel::progressed);
  connect(&job_, &SimulationJob::failed, this, &RunModel::failed);
  connect(&job_, &SimulationJob::finished, this, &RunModel::show_run);
  connect(&job_, &SimulationJob::program_read, this, [this](const LoadedProgram& input) {
    input_ = input;
    emit program_changed();
  });
}

void RunModel::show(const Run& run) {
  job_.cancel();
  file_ = run.input.program->source->name();
  input_ = {};
  setup_.set_file(run.setup);
  input_ = run.input;
  emit program_changed();
  show_run(make_shown(run));
}

void RunModel::open(const std::filesystem::path& file) {
  file_ = file;
  input_ = {};
  show_run(nullptr);
  emit program_changed();
  job_.start({file, setup_.setup()});
}

void RunModel::reload() {
  if (!file_.empty()) {
    open(std::filesystem::path(file_));
  }
}

void RunModel::choose_machine(const QString& id_or_file) {
  try {
    Setup setup;
    setup.machine = machines_.load(id_or_file.toStdString());
    setup.model = &find_model(setup.machine.model);
    setup.settings = complete_settings(*setup.model, setup.machine);
    setup_.set_file(std::move(setup));
  } catch (const InputError& error) {
    emit failed(QString::fromUtf8(error.what()));
  }
}

void RunModel::choose_model(const QString& id) {
  setup_.set_model(find_model(id.toStdString()));
}

std::vector<MachineChoice> RunModel::machine_choices() const {
  std::vector<MachineChoice> choices;
  for (const std::string& id : machines_.ids()) {
    MachineChoice choice{QString::fromStdString(id), QString::fromStdString(id)};
    try {
      choice.name = QString::fromStdString(machines_.load(id).name);
    } catch (const InputError&) {
      // choosing it says what is wrong with the file
    }
    choices.push_back(choice);
  }
  return choices;
}

void RunModel::simulate() {
  if (input_.program != nullptr) {
    job_.start({input_, setup_.setup()});
  } else if (job_.busy()) {
    job_.start({file_, setup_.setup()});
  }
}

void RunModel::show_run(std::shared_ptr<const ShownRun> shown) {
  shown_ = std::move(shown);
  const std::shared_ptr<const Trajectory> trajectory = shown_ == nullptr ? nullptr : shown_->run.trajectory;
  cursor_.set_trajectory(trajectory);
  playback_.set_duration(trajectory == nullptr ? 0 : trajectory->duration());
  emit run_changed();
}

}  // namespace feedscope::ui

#include "ui/workbench/workbench.h"

#include <QFileInfo>
#include <QLocale>
#include <QSaveFile>
#include <chrono>
#include <utility>

#include "core/analysis/run/control_dialect.h"
#include "core/base/error.h"
#include "core/machine/contour_tolerance.h"
#include "ui/language/in_language.h"
#include "ui/shared/paths.h"
#include "ui/workbench/own_machines.h"

namespace feedscope::ui {

Workbench::Workbench(MachineLibrary machines, Setup setup, QObject* parent)
    : QObject(parent),
      machines_(std::move(machines)),
      runs_(std::move(setup)),
      setup_(runs_),
      playback_(cursor_),
      annotations_(runs_.history()) {
  connect(&runs_, &RunList::setup_changed, this, [this](std::size_t row) {
    if (row == runs_.current()) {
      show_current();
    }
    schedule();
  });
  connect(&runs_, &RunList::list_changed, this, &Workbench::schedule);
  connect(&runs_, &RunList::load_changed, this, [this] {
    show_current();
    schedule();
  });
  connect(&runs_, &RunList::current_changed, this, [this] {
    show_current();
    schedule();
  });
  connect(&traces_, &TraceList::failed, this, &Workbench::failed);
  connect(this, &Workbench::run_changed, &time_findings_,
          [this] { time_findings_.set_run(shown(), setup_.state()); });
  connect(this, &Workbench::busy_changed, &time_findings_, &TimeFindings::give_way);
  connect(&job_, &SimulationJob::busy_changed, this, &Workbench::busy_changed);
  connect(&job_, &SimulationJob::progressed, this, &Workbench::report);
  connect(&job_, &SimulationJob::failed, this, &Workbench::take_failure);
  connect(&job_, &SimulationJob::drawable, this, &Workbench::take_drawn);
  connect(&job_, &SimulationJob::finished, this, &Workbench::take_result);
  connect(&job_, &SimulationJob::program_read, this, &Workbench::take_program);

  changed_.setSingleShot(true);
  changed_.setInterval(std::chrono::milliseconds(400));
  connect(&changed_, &QTimer::timeout, this, [this] {
    const std::optional<FileState> now = file_state();
    if (reload_on_change_ && now && now != read_state_) {
      emit noticed(tr("%1 has changed and is reloaded.").arg(to_qstring(file_.filename())));
      reload();
    }
  });
  connect(&watcher_, &QFileSystemWatcher::fileChanged, &changed_, qOverload<>(&QTimer::start));
}

void Workbench::show(const Run& run) {
  job_.cancel();
  working_on_ = 0;
  machine_chosen_ = true;
  file_ = run.input.program->source->name();
  reading_ = {};
  program_ = {};
  traces_.clear();
  annotations_.replace({});
  runs_.replace({{0, {}, runs_.current_item().colour, true, SetupState(run.setup)}}, 0, run.setup.load);
  program_ = program_of(run);
  runs_.set_feed_controls(run.input.feed_controls);
  emit program_changed();
  runs_.set_result(runs_.current_item().id, make_shown(run));
  show_current();
}

void Workbench::open(const std::filesystem::path& file) {
  if (file != file_) {
    if (!file_.empty()) {
      begin_runs_again();
    }
    traces_.clear();
    annotations_.replace({});
    reading_ = {};
  }
  file_ = file;
  show_nothing();
  emit program_changed();
  read_file();
}

void Workbench::close() {
  job_.cancel();
  program_ = {};
  file_.clear();
  traces_.clear();
  annotations_.replace({});
  reading_ = {};
  begin_runs_again();
  show_nothing();
  emit program_changed();
}

void Workbench::show_nothing() {
  program_ = {};
  place_.reset();
  runs_.clear_results();
  show_current();
}

void Workbench::open(const std::filesystem::path& file, std::vector<RunItem> runs, std::size_t current,
                     const ReadOptions& reading, const LoadSetup& load) {
  job_.cancel();
  traces_.clear();
  file_ = file;
  reading_ = reading;
  machine_chosen_ = true;
  program_ = {};
  annotations_.replace({});
  runs_.replace(std::move(runs), current, load);
  open(file);
}

/// Keeps one run of those set up for the previous program, on its current machine; it follows the tolerances
/// of the new program.
void Workbench::begin_runs_again() {
  SetupState setup = runs_.current_item().setup;
  for (const char* key : {contour_tolerance_key, program_tolerance_key}) {
    setup.reset(key);
  }
  runs_.replace({{0, {}, run_colour(0), true, std::move(setup)}}, 0);
}

/// None if there is no such file.
std::optional<Workbench::FileState> Workbench::file_state() const {
  std::error_code none;
  const FileState state{std::filesystem::last_write_time(file_, none),
                        none ? 0 : std::filesystem::file_size(file_, none)};
  return none ? std::nullopt : std::optional(state);
}

void Workbench::read_file() {
  read_state_ = file_state();
  working_on_ = runs_.current_item().id;
  working_setup_ = setup_.setup();
  job_.start({file_, working_setup_, reading_});
}

void Workbench::reload() {
  if (!file_.empty()) {
    stay_at_ = cursor_.valid() ? cursor_.state().line : 0;
    open(std::filesystem::path(file_));
  }
}

void Workbench::set_reading(const ReadOptions& options) {
  if (!(options == reading_)) {
    reading_ = options;
    reload();
  }
}

void Workbench::set_reload_on_change(bool on) {
  reload_on_change_ = on;
}

void Workbench::cancel() {
  if (!busy()) {
    return;
  }
  job_.cancel();
  if (place_) {
    place_->playing = false;
  }
  const bool begun = drawn() != shown();
  for (const RunItem& run : std::vector(runs_.items())) {
    runs_.give_up(run.id);
  }
  if (begun) {
    show_current();
  }
}

void Workbench::simulate_again(std::size_t row) {
  runs_.resume(row);
  if (program_.input.program == nullptr) {
    reload();
  } else {
    schedule();
  }
}

Setup Workbench::plain_setup(Machine machine) {
  Setup setup;
  setup.machine = std::move(machine);
  setup.model = &find_model(setup.machine.model);
  setup.settings = complete_settings(*setup.model, setup.machine);
  return setup;
}

void Workbench::choose_machine(const QString& id_or_file) {
  try {
    Machine machine = machines_.load(id_or_file.toStdString());
    if (QFileInfo(id_or_file).isFile()) {
      OwnMachines::add(id_or_file);
    }
    use_machine(std::move(machine));
  } catch (const InputError& error) {
    emit failed(failure_text(error));
  }
}

void Workbench::use_machine(Machine machine) {
  setup_.set_file(plain_setup(std::move(machine)));
  machine_chosen_ = true;
}

void Workbench::choose_model(const QString& id) {
  setup_.set_model(find_model(id.toStdString()));
}

QString Workbench::name_to_save(const std::filesystem::path& file) const {
  const QString name = QString::fromStdString(setup_.file().machine.name);
  return setup_.state().edits().empty() ? name : name + tr(" (%1)").arg(to_qstring(file.stem()));
}

void Workbench::save_machine(const std::filesystem::path& file, const QString& name) {
  Machine machine = setup_.state().machine();
  machine.id = file.stem().string();
  machine.name = (name.trimmed().isEmpty() ? name_to_save(file) : name.trimmed()).toStdString();
  const std::string text = write_machine(machine);
  QSaveFile out(to_qstring(file));
  const bool written =
      out.open(QIODevice::WriteOnly) &&
      out.write(text.data(), static_cast<qint64>(text.size())) == static_cast<qint64>(text.size()) &&
      out.commit();
  if (!written) {
    emit failed(
        tr("%1 cannot be written: %2. Choose another folder.").arg(to_qstring(file), out.errorString()));
    return;
  }
  choose_machine(to_qstring(file));
  emit noticed(tr("Saved as %1.").arg(to_qstring(file)));
}

bool Workbench::set_tolerance(double tolerance) {
  try {
    setup_.set_tolerance(tolerance);
    return true;
  } catch (const InputError&) {
    return false;
  }
}

void Workbench::show_place(double time, double from, double to) {
  if (shown() != nullptr) {
    cursor_.set_time(time);
    view_range_.show_times(from - (to - from), to + (to - from));
    emit place_shown(from, to);
  }
}

std::vector<MachineChoice> Workbench::machine_choices() const {
  std::vector<MachineChoice> choices;
  for (const std::string& id : machines_.ids()) {
    MachineChoice choice{QString::fromStdString(id), QString::fromStdString(id)};
    try {
      choice.name = QString::fromStdString(machines_.load(id).name);
    } catch (const InputError&) {
      // choosing it reports errors in the file
    }
    choices.push_back(choice);
  }
  for (const QString& file : OwnMachines::list()) {
    try {
      const Machine machine = machines_.load(file.toStdString());
      choices.push_back({QString::fromStdString(machine.id), QString::fromStdString(machine.name), file,
                         QFileInfo(file).owner()});
    } catch (const InputError&) {
      continue;  // it has changed since; opening it reports errors
    }
  }
  return choices;
}

void Workbench::schedule() {
  if (program_.input.program == nullptr) {
    if (job_.busy() && !file_.empty()) {  // still reading
      read_file();
    }
    return;
  }
  std::size_t row = runs_.current();
  for (std::size_t next = 0; !wanted(row) && next < runs_.items().size(); ++next) {
    row = next;
  }
  if (wanted(row) && !under_way(row)) {
    working_on_ = runs_.items()[row].id;
    working_setup_ = runs_.setup(runs_.items()[row]);
    job_.start({program_.input, working_setup_, {}, runs_.last_result(row)});
  }
}

bool Workbench::wanted(std::size_t row) const {
  return runs_.status(row) == RunStatus::waiting;
}

bool Workbench::under_way(std::size_t row) const {
  const RunItem& item = runs_.items()[row];
  return job_.busy() && working_on_ == item.id && working_setup_ == runs_.setup(item);
}

void Workbench::take_program(const ShownProgram& program) {
  program_ = program;
  runs_.set_feed_controls(program.input.feed_controls);
  use_default_machine();
  watch();
  emit program_changed();
}

/// Chooses the machine of the program's dialect, unless the user has chosen a machine or edited a setup.
void Workbench::use_default_machine() {
  const std::string id = default_machine_of(program_.input.program->dialect);
  const RunItem& only = runs_.current_item();
  if (machine_chosen_ || runs_.items().size() > 1 || !only.setup.edits().empty() ||
      only.setup.file().machine.id == id) {
    return;
  }
  try {
    RunItem run = only;
    run.setup = SetupState(plain_setup(machines_.load(id)));
    runs_.replace({std::move(run)}, 0);
    emit noticed(tr("%1 is used: its control reads %2 programs.")
                     .arg(QString::fromStdString(runs_.current_item().setup.file().machine.name),
                          QString::fromUtf8(info_of(program_.input.program->dialect).title.data())));
  } catch (const InputError& error) {
    emit failed(failure_text(error));
  }
}

void Workbench::take_drawn(const std::shared_ptr<const ShownRun>& drawn) {
  if (drawn->run.input.program != program_.input.program) {
    return;
  }
  runs_.set_drawn(working_on_, drawn);
  if (runs_.current_item().id == working_on_) {
    show_drawn();
  }
}

void Workbench::take_result(const std::shared_ptr<const ShownRun>& result) {
  if (result->run.input.program != program_.input.program) {
    return;
  }
  runs_.set_result(working_on_, result);
  if (runs_.current_item().id == working_on_) {
    show_current();
  }
  schedule();
}

void Workbench::take_failure(const QString& message) {
  const bool begun = drawn() != shown();
  runs_.give_up(working_on_, message);
  if (begun) {
    show_current();
  }
  emit failed(message);
  schedule();
}

void Workbench::show_current() {
  show_drawn();
  traces_.set_run(shown());
  emit run_changed();
}

void Workbench::show_drawn() {
  const auto result = drawn();
  const std::shared_ptr<const Trajectory> trajectory = result == nullptr ? nullptr : result->run.trajectory;
  if (trajectory == nullptr) {
    keep_place();
  }
  cursor_.set_trajectory(trajectory, result == nullptr ? nullptr : result->line_times);
  playback_.set_duration(trajectory == nullptr ? 0 : trajectory->duration());
  if (trajectory != nullptr && stay_at_ > 0) {
    cursor_.set_line(std::exchange(stay_at_, 0));
  }
  if (trajectory != nullptr) {
    return_to_place();
  }
  emit drawn_changed();
}

/// Stores the cursor's place until the next run is simulated.
void Workbench::keep_place() {
  if (program_.input.program != nullptr && cursor_.valid() && cursor_.state().time > 0) {
    place_ = Place{cursor_.state().path_length, playback_.playing()};
  }
}

void Workbench::return_to_place() {
  if (const auto place = std::exchange(place_, std::nullopt)) {
    cursor_.set_path_length(place->path_length);
    if (place->playing) {
      playback_.play();
    }
  }
}

/// Editors often replace a file instead of rewriting it; a path that was deleted must be watched again.
void Workbench::watch() {
  const QString file = to_qstring(file_);
  if (!watcher_.files().isEmpty() && !watcher_.files().contains(file)) {
    watcher_.removePaths(watcher_.files());
  }
  if (QFileInfo(file).isFile()) {
    watcher_.addPath(file);
  }
}

void Workbench::report(JobStage stage, double fraction) {
  const QLocale locale;
  if (stage == JobStage::reading) {
    emit progressed(tr("Reading %1 %").arg(locale.toString(100 * fraction, 'f', 0)), fraction);
    return;
  }
  const auto blocks = program_.input.toolpath == nullptr ? 0 : program_.input.toolpath->segments.size();
  const auto done = static_cast<qulonglong>(fraction * static_cast<double>(blocks));
  const std::size_t row = runs_.row_of(working_on_);
  const QString run = row < runs_.items().size() && runs_.items().size() > 1
                          ? tr(" (run %1 of %2)").arg(row + 1).arg(runs_.items().size())
                          : QString();
  emit progressed(tr("Simulating %1 of %2 blocks%3")
                      .arg(locale.toString(done), locale.toString(static_cast<qulonglong>(blocks)), run),
                  fraction);
}

}  // namespace feedscope::ui

#pragma once

#include <QFileSystemWatcher>
#include <QObject>
#include <QString>
#include <QTimer>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "ui/shared/cursor.h"
#include "ui/shared/view_range.h"
#include "ui/workbench/annotation_list.h"
#include "ui/workbench/playback.h"
#include "ui/workbench/run_list.h"
#include "ui/workbench/setup_edit.h"
#include "ui/workbench/simulation_job.h"
#include "ui/workbench/time_findings.h"
#include "ui/workbench/trace_list.h"

namespace feedscope::ui {

/// A machine as people choose it.
struct MachineChoice {
  QString id;
  QString name;
  QString file = {};   ///< of one's own; empty for a shipped machine
  QString owner = {};  ///< of that file; empty where the system does not say

  /// What Workbench::choose_machine() takes.
  const QString& key() const { return file.isEmpty() ? id : file; }
};

/// What the window works on: one program, its runs, and the place that all views point at. Whatever is not up
/// to date is simulated again, the current run first.
class Workbench : public QObject {
  Q_OBJECT

 public:
  Workbench(MachineLibrary machines, Setup setup, QObject* parent = nullptr);

  /// Shows a run that is done, with its program and setup, as the only one.
  void show(const Run& run);
  /// Reads a program and simulates every run of it. Another one than before is read as usual and begins with
  /// one run: machine, model and values of the current one, without a name and a tolerance set for the
  /// program before. Until someone has chosen a machine it runs on that of its dialect: default_machine_of().
  void open(const std::filesystem::path& file);
  /// The same with other runs, at least one; their history goes.
  void open(const std::filesystem::path& file, std::vector<RunItem> runs, std::size_t current,
            const ReadOptions& reading = {}, const LoadSetup& load = {});
  /// Shows no program; one run stays, as for another program.
  void close();
  /// Reads the program again; the cursor stays at its line.
  void reload();
  void set_reload_on_change(bool on);
  /// How the program is read; another way reads it again.
  const ReadOptions& reading() const { return reading_; }
  void set_reading(const ReadOptions& options);
  /// The runs that are not simulated yet are given up.
  void cancel();
  /// A run that was given up, once more.
  void simulate_again(std::size_t row);
  /// Id or file; its own model is chosen with it. An unusable file is reported by failed().
  void choose_machine(const QString& id_or_file);
  /// A machine that stands in no file; its own model is chosen with it.
  void use_machine(Machine machine);
  /// The machine of the current run is wanted: no program that is opened chooses another one by its dialect.
  void hold_machine() { machine_chosen_ = true; }
  void choose_model(const QString& id);
  /// Writes the machine of the current run with all edits to a machine file, whose name becomes its id, and
  /// goes on with that file. `name`: for people; "" for name_to_save(). What cannot be written is reported by
  /// failed(), and nothing is left behind.
  void save_machine(const std::filesystem::path& file, const QString& name = {});
  /// What the machine of the current run is called in a file of its own: with edits not like the one before.
  QString name_to_save(const std::filesystem::path& file) const;
  /// Contour tolerance of the current run [mm], instead of the program's own too. False if its model reads
  /// none, or the value is out of bounds.
  bool set_tolerance(double tolerance);

  /// Whether the machine is that of the program's language, which nobody has chosen.
  bool machine_by_language() const { return program() != nullptr && !machine_chosen_; }
  /// The shipped machines, where one whose file is faulty goes by its id; then one's own, as far as they can
  /// be read.
  std::vector<MachineChoice> machine_choices() const;
  RunList& runs() { return runs_; }
  /// What a control recorded of the program; another program has none.
  TraceList& traces() { return traces_; }
  SetupEdit& setup() { return setup_; }
  Cursor& cursor() { return cursor_; }
  Playback& playback() { return playback_; }
  /// The stretch of the current run that the charts show.
  ViewRange& view_range() { return view_range_; }
  /// Where the time of the current run goes and what would help.
  TimeFindings& time_findings() { return time_findings_; }
  /// Points at a place that lasts from one time to another [s], and shows it with as much before and behind.
  void show_place(double time, double from, double to);
  /// Their changes stand in the history of the runs.
  AnnotationList& annotations() { return annotations_; }
  const std::filesystem::path& file() const { return file_; }
  /// Null until a program has been read.
  std::shared_ptr<const Program> program() const { return program_.input.program; }
  const ShownProgram& shown_program() const { return program_; }
  /// Of the current run, simulated with the setup that it has now; null until that is done.
  std::shared_ptr<const ShownRun> shown() const { return runs_.result(runs_.current()); }
  /// What pictures draw: shown(), or before its summary is known what charts and 3D need of it.
  std::shared_ptr<const ShownRun> drawn() const { return runs_.drawn(runs_.current()); }
  bool busy() const { return job_.busy(); }

 signals:
  /// Another program, or none; its runs follow.
  void program_changed();
  /// Another current run, another result of it, or none any more.
  void run_changed();
  /// Another drawn(), or none any more; before run_changed().
  void drawn_changed();
  void busy_changed(bool busy);
  /// show_place() [s].
  void place_shown(double from, double to);
  /// What is being done, for the user, and how much of it [0, 1].
  void progressed(const QString& activity, double fraction);
  void failed(const QString& message);
  /// Something worth a line in the status bar.
  void noticed(const QString& message);

 private:
  /// What tells that a file has been written.
  struct FileState {
    std::filesystem::file_time_type written;
    std::uintmax_t size = 0;
    bool operator==(const FileState&) const = default;
  };

  void show_nothing();
  void begin_runs_again();
  void read_file();
  std::optional<FileState> file_state() const;
  static Setup plain_setup(Machine machine);
  void use_default_machine();
  void schedule();
  bool wanted(std::size_t row) const;
  bool under_way(std::size_t row) const;
  void take_program(const ShownProgram& program);
  void take_drawn(const std::shared_ptr<const ShownRun>& drawn);
  void take_result(const std::shared_ptr<const ShownRun>& result);
  void take_failure(const QString& message);
  void show_current();
  void show_drawn();
  void keep_place();
  void return_to_place();
  void watch();
  void report(JobStage stage, double fraction);

  MachineLibrary machines_;
  RunList runs_;
  TraceList traces_;
  SetupEdit setup_;
  Cursor cursor_;
  Playback playback_;
  ViewRange view_range_;
  AnnotationList annotations_;
  TimeFindings time_findings_;
  SimulationJob job_;
  QFileSystemWatcher watcher_;
  QTimer changed_;                       ///< a file that is being written changes more than once
  std::optional<FileState> read_state_;  ///< when the file was last read: a change before that is known
  bool reload_on_change_ = true;
  std::filesystem::path file_;
  ReadOptions reading_;
  bool machine_chosen_ = false;  ///< else the program's dialect chooses it
  ShownProgram program_;
  int working_on_ = 0;         ///< id of the run under way
  Setup working_setup_;        ///< as it was when that began
  std::uint32_t stay_at_ = 0;  ///< line of the cursor before the program was read again
  /// Where the cursor was in the last run that was shown; none: at the start, or of another program.
  struct Place {
    double path_length;  ///< [mm]
    bool playing;
  };
  std::optional<Place> place_;
};

}  // namespace feedscope::ui

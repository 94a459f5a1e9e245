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

/// A machine in a list of choices.
struct MachineChoice {
  QString id;
  QString name;
  QString file = {};   ///< of a user's machine; empty for a shipped one
  QString owner = {};  ///< of that file; empty if the system does not report it

  /// Argument for Workbench::choose_machine().
  const QString& key() const { return file.isEmpty() ? id : file; }
};

/// The work of the window: one program, its runs, and the common place of all views. Outdated runs are
/// simulated again, the current one first.
class Workbench : public QObject {
  Q_OBJECT

 public:
  Workbench(MachineLibrary machines, Setup setup, QObject* parent = nullptr);

  /// Shows a finished run, with its program and setup, as the only one.
  void show(const Run& run);
  /// Reads a program and simulates all its runs. A new program is read with default options and has one run:
  /// machine, model and values of the current one, without a name and a tolerance set for the previous
  /// program. Until the user chooses a machine, it runs on that of its dialect: default_machine_of().
  void open(const std::filesystem::path& file);
  /// Opens a program with other runs, at least one; clears their history.
  void open(const std::filesystem::path& file, std::vector<RunItem> runs, std::size_t current,
            const ReadOptions& reading = {}, const LoadSetup& load = {});
  /// Opens the program of a lesson in the same way. Programs opened later with open(file) begin with the
  /// setup that was current before the lesson, or on the machine that the user chooses during it.
  void open_for_lesson(const std::filesystem::path& file, std::vector<RunItem> runs, std::size_t current,
                       const LoadSetup& load);
  /// Closes the program and shows the setup of a lesson, for whose program open_for_lesson() follows.
  void close_for_lesson(RunItem run, const LoadSetup& load);
  /// Reads the program again; the cursor keeps its line.
  void reload();
  void set_reload_on_change(bool on);
  /// The reading options of the program; setting others reads it again.
  const ReadOptions& reading() const { return reading_; }
  void set_reading(const ReadOptions& options);
  /// Gives up the runs that are not simulated yet.
  void cancel();
  /// Simulates a run again that was given up.
  void simulate_again(std::size_t row);
  /// Id or file; also chooses its own model. An unusable file is reported by failed().
  void choose_machine(const QString& id_or_file);
  /// Uses a machine without a file, with its own model.
  void use_machine(Machine machine);
  /// Keeps the current run's machine: programs opened later do not change it by their dialect.
  void hold_machine() { machine_chosen_ = true; }
  void choose_model(const QString& id);
  /// Writes the machine of the current run with all edits to a machine file, whose name becomes its id, and
  /// continues with that file. `name`: for people; "" for name_to_save(). A write error is reported by
  /// failed(), and no partial file is left.
  void save_machine(const std::filesystem::path& file, const QString& name = {});
  /// Name of the current run's machine in its own file: if it has edits, different from the previous one.
  QString name_to_save(const std::filesystem::path& file) const;
  /// Sets the contour tolerance of the current run [mm], which also replaces the program's. Returns false if
  /// its model reads none, or the value is out of bounds.
  bool set_tolerance(double tolerance);

  /// Whether the machine follows the program's language, because the user has not chosen one.
  bool machine_by_language() const { return program() != nullptr && !machine_chosen_; }
  /// The shipped machines, by id if their file is faulty; then the readable ones of the user.
  std::vector<MachineChoice> machine_choices() const;
  RunList& runs() { return runs_; }
  /// Recorded traces of the program; another program has none.
  TraceList& traces() { return traces_; }
  SetupEdit& setup() { return setup_; }
  Cursor& cursor() { return cursor_; }
  Playback& playback() { return playback_; }
  /// Range of the current run in the charts.
  ViewRange& view_range() { return view_range_; }
  /// Breakdown of the current run's time, and helpful changes.
  TimeFindings& time_findings() { return time_findings_; }
  /// Moves the cursor to a place that lasts from one time to another [s], and shows it with as much time
  /// before and after.
  void show_place(double time, double from, double to);
  /// Their changes are in the history of the runs.
  AnnotationList& annotations() { return annotations_; }
  /// Whether the program and its runs are a lesson's.
  bool of_lesson() const { return own_.has_value(); }
  const std::filesystem::path& file() const { return file_; }
  /// Null until a program has been read.
  std::shared_ptr<const Program> program() const { return program_.input.program; }
  const ShownProgram& shown_program() const { return program_; }
  /// Result of the current run with its current setup; null until that is simulated.
  std::shared_ptr<const ShownRun> shown() const { return runs_.result(runs_.current()); }
  /// Drawable part of the current run: shown(), or the data for charts and 3D before its summary is known.
  std::shared_ptr<const ShownRun> drawn() const { return runs_.drawn(runs_.current()); }
  bool busy() const { return job_.busy(); }

 signals:
  /// The program has changed, or was closed; its runs follow.
  void program_changed();
  /// The current run or its result has changed, or no longer exists.
  void run_changed();
  /// drawn() has changed or no longer exists; before run_changed().
  void drawn_changed();
  void busy_changed(bool busy);
  /// Emitted by show_place() [s].
  void place_shown(double from, double to);
  /// Current activity, for the user, and the fraction done [0, 1].
  void progressed(const QString& activity, double fraction);
  void failed(const QString& message);
  /// A message for the status bar.
  void noticed(const QString& message);

 private:
  /// State of a file, to detect writes.
  struct FileState {
    std::filesystem::file_time_type written;
    std::uintmax_t size = 0;
    bool operator==(const FileState&) const = default;
  };

  /// Setup that programs begin with which are opened after a lesson.
  struct OwnSetup {
    SetupState setup;
    bool machine_chosen = false;
  };

  void show_nothing();
  void begin_runs_again();
  void keep_own_setup();
  void open_with(const std::filesystem::path& file, std::vector<RunItem> runs, std::size_t current,
                 const ReadOptions& reading, const LoadSetup& load);
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
  QTimer changed_;                       ///< a file being written changes more than once
  std::optional<FileState> read_state_;  ///< at the last reading of the file: earlier changes are known
  bool reload_on_change_ = true;
  std::filesystem::path file_;
  ReadOptions reading_;
  bool machine_chosen_ = false;  ///< else the program's dialect chooses it
  std::optional<OwnSetup> own_;  ///< while the runs are a lesson's
  ShownProgram program_;
  int working_on_ = 0;         ///< id of the run being simulated
  Setup working_setup_;        ///< its setup at the start
  std::uint32_t stay_at_ = 0;  ///< line of the cursor before the program was read again
  /// Place of the cursor in the last shown run; none: at the start, or of another program.
  struct Place {
    double path_length;  ///< [mm]
    bool playing;
  };
  std::optional<Place> place_;
};

}  // namespace feedscope::ui

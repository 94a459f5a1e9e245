#pragma once

#include <QObject>
#include <QString>
#include <filesystem>
#include <memory>
#include <vector>

#include "ui/models/cursor.h"
#include "ui/models/playback.h"
#include "ui/models/setup_edit.h"
#include "ui/models/simulation_job.h"

namespace feedscope::ui {

/// A machine as people choose it.
struct MachineChoice {
  QString id;
  QString name;
};

/// The run that the window shows: a program on a setup. Every change of either simulates it anew.
class RunModel : public QObject {
  Q_OBJECT

 public:
  RunModel(MachineLibrary machines, Setup setup, QObject* parent = nullptr);

  /// Shows a run that is done, with its program and setup.
  void show(const Run& run);
  /// Reads a program and simulates it.
  void open(const std::filesystem::path& file);
  /// Reads the program again.
  void reload();
  void cancel() { job_.cancel(); }
  /// Id or file; its own model is chosen with it. An unusable file is reported by failed().
  void choose_machine(const QString& id_or_file);
  void choose_model(const QString& id);

  /// The shipped machines; one whose file is faulty goes by its id.
  std::vector<MachineChoice> machine_choices() const;
  SetupEdit& setup() { return setup_; }
  Cursor& cursor() { return cursor_; }
  Playback& playback() { return playback_; }
  const std::filesystem::path& file() const { return file_; }
  /// Null until a program has been read.
  std::shared_ptr<const Program> program() const { return input_.program; }
  /// Null until the first simulation is done.
  std::shared_ptr<const ShownRun> shown() const { return shown_; }
  bool busy() const { return job_.busy(); }

 signals:
  /// Another program, or none; its run follows.
  void program_changed();
  void run_changed();
  void busy_changed(bool busy);
  void progressed(double fraction);
  void failed(const QString& message);

 private:
  void simulate();
  void show_run(std::shared_ptr<const ShownRun> shown);

  MachineLibrary machines_;
  SetupEdit setup_;
  Cursor cursor_;
  Playback playback_;
  SimulationJob job_;
  std::filesystem::path file_;
  LoadedProgram input_;
  std::shared_ptr<const ShownRun> shown_;
};

}  // namespace feedscope::ui

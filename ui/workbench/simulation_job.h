#pragma once

#include <QObject>
#include <atomic>
#include <filesystem>
#include <memory>
#include <variant>

#include "ui/shared/job.h"
#include "ui/workbench/shown_run.h"

namespace feedscope::ui {

/// Simulation request: a file to read, or a program already read.
struct JobRequest {
  std::variant<std::filesystem::path, LoadedProgram> input;
  Setup setup;
  ReadOptions reading = {};  ///< of a file
  std::shared_ptr<const ShownRun> before =
      {};  ///< of the same program; its motion is reused if it is equal to the new one
};

enum class JobStage { reading, simulating };

/// Reads and simulates on another thread. One request at a time; a new one cancels the running one, whose
/// result is never delivered. All signals in the thread of this object.
class SimulationJob : public QObject {
  Q_OBJECT

 public:
  explicit SimulationJob(QObject* parent = nullptr);

  void start(JobRequest request);
  void cancel() { job_.cancel(); }
  bool busy() const { return job_.busy(); }

 signals:
  void busy_changed(bool busy);
  /// `fraction` of the stage is done, 0 to 1; emitted a few times a second while busy.
  void progressed(feedscope::ui::JobStage stage, double fraction);
  /// A file has been read; its simulation follows.
  void program_read(const feedscope::ui::ShownProgram& program);
  /// The drawable part of the run being simulated; the rest follows.
  void drawable(const std::shared_ptr<const feedscope::ui::ShownRun>& drawn);
  void finished(std::shared_ptr<const feedscope::ui::ShownRun> run);
  /// `message` for the user: unreadable file, missing limit, out of memory.
  void failed(const QString& message);

 private:
  using Result = std::shared_ptr<const ShownRun>;

  Result work(const JobRequest& request, JobControl& control, std::atomic<JobStage>& stage);

  std::shared_ptr<std::atomic<JobStage>> stage_;  ///< of the running request
  Job<Result> job_;
};

}  // namespace feedscope::ui

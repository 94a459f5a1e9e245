#pragma once

#include <QFutureWatcher>
#include <QObject>
#include <QTimer>
#include <atomic>
#include <filesystem>
#include <memory>
#include <optional>
#include <variant>

#include "ui/models/shown_run.h"

namespace feedscope::ui {

/// What to simulate: a file to read, or a program read before.
struct JobRequest {
  std::variant<std::filesystem::path, LoadedProgram> input;
  Setup setup;
  ReadOptions reading = {};  ///< of a file
};

enum class JobStage { reading, simulating };

/// Reads and simulates on another thread. One request at a time; a newer one cancels the one under way, whose
/// result is never delivered. All signals in the thread of this object. Destruction while busy cancels.
class SimulationJob : public QObject {
  Q_OBJECT

 public:
  explicit SimulationJob(QObject* parent = nullptr);
  ~SimulationJob() override;

  void start(JobRequest request);
  void cancel();
  bool busy() const { return running_; }

 signals:
  void busy_changed(bool busy);
  /// `fraction` of the stage is done, 0 to 1; a few times a second while busy.
  void progressed(feedscope::ui::JobStage stage, double fraction);
  /// A file has been read; its simulation follows.
  void program_read(const feedscope::ui::ShownProgram& program);
  void finished(std::shared_ptr<const feedscope::ui::ShownRun> run);
  /// `message` for the user: unreadable file, missing limit, out of memory.
  void failed(const QString& message);

 private:
  using Outcome = std::variant<std::monostate, std::shared_ptr<const ShownRun>, QString>;

  void launch(JobRequest request);
  struct Stages {
    Progress reading;
    Progress simulation;
    std::atomic<bool> simulating{false};

    void cancel();
  };
  Outcome work(const JobRequest& request, const std::shared_ptr<Stages>& stages);
  void deliver();

  QFutureWatcher<Outcome> watcher_;
  QTimer poll_;
  std::shared_ptr<Stages> stages_;
  std::optional<JobRequest> next_;
  bool running_ = false;  ///< until the outcome is delivered
};

}  // namespace feedscope::ui

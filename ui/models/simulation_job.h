#pragma once

#include <QFutureWatcher>
#include <QObject>
#include <QTimer>
#include <filesystem>
#include <memory>
#include <optional>
#include <variant>

#include "core/analysis/line_times.h"
#include "core/analysis/run.h"
#include "core/analysis/slow_places.h"
#include "core/base/progress.h"
#include "ui/charts/envelope.h"
#include "ui/scene/sampled_path.h"

namespace feedscope::ui {

/// A run with what its pictures need, made off the GUI thread.
struct ShownRun {
  Run run;
  std::shared_ptr<const Envelope> envelope;     ///< for the charts
  std::shared_ptr<const SampledPath> samples;   ///< for the 3D view
  std::shared_ptr<const LineTimes> line_times;  ///< for the program's text
  std::shared_ptr<const SlowPlaces> slow_places;
};

/// Throws Cancelled if `progress` is cancelled.
std::shared_ptr<const ShownRun> make_shown(Run run, Progress* progress = nullptr);

/// What to simulate: a file to read, or a program read before.
struct JobRequest {
  std::variant<std::filesystem::path, LoadedProgram> input;
  Setup setup;
};

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
  /// 0 to 1, a few times a second while busy.
  void progressed(double fraction);
  /// A file has been read; its simulation follows.
  void program_read(const feedscope::LoadedProgram& input);
  void finished(std::shared_ptr<const feedscope::ui::ShownRun> run);
  /// `message` for the user: unreadable file, missing limit, out of memory.
  void failed(const QString& message);

 private:
  using Outcome = std::variant<std::monostate, std::shared_ptr<const ShownRun>, QString>;

  void launch(JobRequest request);
  Outcome work(const JobRequest& request, const std::shared_ptr<Progress>& progress);
  void deliver();

  QFutureWatcher<Outcome> watcher_;
  QTimer poll_;
  std::shared_ptr<Progress> progress_;
  std::optional<JobRequest> next_;
  bool running_ = false;  ///< until the outcome is delivered
};

}  // namespace feedscope::ui

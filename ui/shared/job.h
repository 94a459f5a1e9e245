#pragma once

#include <QFutureWatcher>
#include <QObject>
#include <QString>
#include <QTimer>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>

#include "core/base/progress.h"

namespace feedscope::ui {

/// Access of work on another thread to its job.
class JobControl : public std::enable_shared_from_this<JobControl> {
 public:
  Progress progress;

  explicit JobControl(QObject& receiver) : receiver_(&receiver) {}
  /// Calls `what` in the thread that started the job, unless the job is cancelled by then. Calls keep their
  /// order and come before the result.
  void tell(std::function<void()> what);

  /// The job is being destroyed: nothing is called any more.
  void leave();

 private:
  std::mutex mutex_;
  QObject* receiver_;  ///< in the thread that started the job; null: destroyed
};

/// Outcome of work on another thread; cancelled if there is neither a result nor a failure.
template <class Result>
struct JobOutcome {
  std::optional<Result> result;
  QString failure;  ///< for the user; empty: none

  bool cancelled() const { return !result.has_value() && failure.isEmpty(); }
};

/// Does `work` and returns the user's message for its exception; empty without one, or for Cancelled.
QString failure_of(const std::function<void()>& work);

/// Common part of all Job<Result>. All signals in the thread of this object.
class JobBase : public QObject {
  Q_OBJECT

 public:
  explicit JobBase(QObject* parent = nullptr);
  /// Cancels without waiting: work owns all data that it reads.
  ~JobBase() override;

  /// From start() until the outcome is delivered.
  bool busy() const { return control_ != nullptr; }
  /// Fraction of the work done, 0 to 1; 1 while idle.
  double fraction() const { return control_ == nullptr ? 1 : control_->progress.fraction(); }
  /// Makes the running work end as soon as it notices; it is delivered as cancelled.
  void cancel();

 signals:
  void busy_changed(bool busy);
  /// `fraction` is done, 0 to 1; emitted some times a second while busy.
  void progressed(double fraction);

 protected:
  /// Delivers the outcome of the work; to be called in the thread of this object, `cancelled` or not.
  using Deliver = std::function<void(bool cancelled)>;
  /// Runs on another thread.
  using Task = std::function<Deliver(JobControl&)>;

  void start_task(Task task);

 private:
  void launch(Task task);
  void finish();

  QFutureWatcher<Deliver> watcher_;
  QTimer poll_;
  std::shared_ptr<JobControl> control_;  ///< of the running work
  Task next_;                            ///< waits until the running work has noticed its cancellation
};

/// Work on another thread, one at a time: new work cancels the running one, whose outcome is then never
/// delivered. Work must own all data that it reads; its exceptions, and lack of memory, become a message for
/// the user.
template <class Result>
class Job : public JobBase {
 public:
  using Outcome = JobOutcome<Result>;
  using JobBase::JobBase;

  /// `work(control)` runs on another thread and returns a Result; `deliver(outcome)` follows in this one.
  template <class Work>
  void start(Work work, std::function<void(Outcome)> deliver) {
    start_task([work = std::move(work), deliver = std::move(deliver)](JobControl& control) -> Deliver {
      auto outcome = std::make_shared<Outcome>();
      outcome->failure = failure_of([&] { outcome->result.emplace(work(control)); });
      return [outcome, deliver](bool cancelled) {
        Outcome became = std::exchange(*outcome, Outcome());  // which the future keeps until the next one
        deliver(cancelled ? Outcome() : std::move(became));
      };
    });
  }
};

}  // namespace feedscope::ui

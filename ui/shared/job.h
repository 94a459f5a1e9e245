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

/// What work on another thread is given.
class JobControl : public std::enable_shared_from_this<JobControl> {
 public:
  Progress progress;

  explicit JobControl(QObject& receiver) : receiver_(&receiver) {}
  /// Calls `what` in the thread that started the job, unless the job is cancelled by then. What is told is
  /// called in its order, before the result is delivered.
  void tell(std::function<void()> what);

  /// The job goes: nothing is called any more.
  void leave();

 private:
  std::mutex mutex_;
  QObject* receiver_;  ///< in the thread that started the job; null: gone
};

/// What became of work on another thread. Neither result nor failure: it was cancelled.
template <class Result>
struct JobOutcome {
  std::optional<Result> result;
  QString failure;  ///< for the user; empty: none

  bool cancelled() const { return !result.has_value() && failure.isEmpty(); }
};

/// Does `work`; the message for the user of what it throws, empty if that is nothing, or Cancelled.
QString failure_of(const std::function<void()>& work);

/// What every Job<Result> has. All signals in the thread of this object.
class JobBase : public QObject {
  Q_OBJECT

 public:
  explicit JobBase(QObject* parent = nullptr);
  /// Cancels, and does not wait: work owns all that it reads.
  ~JobBase() override;

  /// From start() until its outcome is delivered.
  bool busy() const { return control_ != nullptr; }
  /// Part of the work that is done, 0 to 1; 1 while idle.
  double fraction() const { return control_ == nullptr ? 1 : control_->progress.fraction(); }
  /// The work under way ends as soon as it notices, and is delivered as cancelled.
  void cancel();

 signals:
  void busy_changed(bool busy);
  /// `fraction` is done, 0 to 1; some times a second while busy.
  void progressed(double fraction);

 protected:
  /// Delivers what became of the work: to be called in the thread of this object, `cancelled` or not.
  using Deliver = std::function<void(bool cancelled)>;
  /// Runs on another thread.
  using Task = std::function<Deliver(JobControl&)>;

  void start_task(Task task);

 private:
  void launch(Task task);
  void finish();

  QFutureWatcher<Deliver> watcher_;
  QTimer poll_;
  std::shared_ptr<JobControl> control_;  ///< of the work under way
  Task next_;                            ///< waits until the work under way has noticed that it is cancelled
};

/// Work on another thread, one at a time: newer work cancels the one under way, whose outcome is then never
/// delivered. Work must own all that it reads; what it throws, and too little memory, becomes a message for
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
        Outcome became = std::exchange(*outcome, Outcome());  // which the future holds until the next one
        deliver(cancelled ? Outcome() : std::move(became));
      };
    });
  }
};

}  // namespace feedscope::ui

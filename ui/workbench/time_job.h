#pragma once

#include <QObject>
#include <memory>

#include "core/analysis/time/time_report.h"
#include "ui/shared/job.h"
#include "ui/workbench/shown_run.h"

namespace feedscope::ui {

/// Breaks down the time of a run, and tries changes, on another thread. New work cancels the running one. All
/// signals in the thread of this object.
class TimeJob : public QObject {
  Q_OBJECT

 public:
  explicit TimeJob(QObject* parent = nullptr);

  /// Computes the breakdown of the time.
  void look(std::shared_ptr<const ShownRun> shown);
  /// Simulates changes of `shown`, whose `report` is from look().
  void try_changes(std::shared_ptr<const ShownRun> shown, std::shared_ptr<const TimeReport> report);
  void cancel() { job_.cancel(); }
  bool busy() const { return job_.busy(); }

 signals:
  /// Emitted without tried changes, or with them.
  void done(const std::shared_ptr<const feedscope::TimeReport>& report);
  void progressed(double fraction);
  /// Nothing more follows: done, cancelled, or failed with `message`.
  void ended(const QString& message);

 private:
  void deliver(const JobOutcome<std::shared_ptr<const TimeReport>>& outcome);

  Job<std::shared_ptr<const TimeReport>> job_;
};

}  // namespace feedscope::ui

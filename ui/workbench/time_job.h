#pragma once

#include <QObject>
#include <memory>

#include "core/analysis/time_use/time_report.h"
#include "ui/shared/job.h"
#include "ui/workbench/shown_run.h"

namespace feedscope::ui {

/// Works out on another thread where the time of a run goes, and tries what would help. What is begun drops
/// what is under way. All signals in the thread of this object.
class TimeJob : public QObject {
  Q_OBJECT

 public:
  explicit TimeJob(QObject* parent = nullptr);

  /// Where the time goes.
  void look(std::shared_ptr<const ShownRun> shown);
  /// Simulates what would help `shown`, whose `report` look() has made.
  void try_changes(std::shared_ptr<const ShownRun> shown, std::shared_ptr<const TimeReport> report);
  void cancel() { job_.cancel(); }
  bool busy() const { return job_.busy(); }

 signals:
  /// Without what would help, or with it.
  void done(const std::shared_ptr<const feedscope::TimeReport>& report);
  void progressed(double fraction);
  /// Nothing more comes: done, cancelled, or `message` says why not.
  void ended(const QString& message);

 private:
  void deliver(const JobOutcome<std::shared_ptr<const TimeReport>>& outcome);

  Job<std::shared_ptr<const TimeReport>> job_;
};

}  // namespace feedscope::ui

#pragma once

#include <QObject>
#include <memory>

#include "core/analysis/time_use/time_report.h"
#include "ui/shared/job.h"
#include "ui/workbench/shown_run.h"

namespace feedscope::ui {

/// Works out on another thread where the time of a run goes, then tries what would help. A new run drops the
/// one under way. All signals in the thread of this object.
class TimeJob : public QObject {
  Q_OBJECT

 public:
  explicit TimeJob(QObject* parent = nullptr);

  /// `with_changes`: also what would help.
  void start(std::shared_ptr<const ShownRun> shown, bool with_changes);
  void cancel() { job_.cancel(); }
  bool busy() const { return job_.busy(); }

 signals:
  /// Where the time goes; what would help is not tried yet.
  void used(const std::shared_ptr<const feedscope::TimeReport>& report);
  /// All of it: what would help is tried, unless it was not asked for.
  void done(const std::shared_ptr<const feedscope::TimeReport>& report);
  void progressed(double fraction);
  /// Nothing more comes: done, cancelled, or `message` says why not.
  void ended(const QString& message);

 private:
  Job<std::shared_ptr<const TimeReport>> job_;
};

}  // namespace feedscope::ui

#pragma once

#include <QObject>
#include <map>
#include <memory>
#include <vector>

#include "core/analysis/contour/contour_report.h"
#include "ui/shared/job.h"
#include "ui/workbench/shown_run.h"

namespace feedscope::ui {

/// Computes contour reports of runs on another thread, one after the other. Keeps them as long as their runs
/// live, the latest until the next. All signals in the thread of this object.
class ContourJob : public QObject {
  Q_OBJECT

 public:
  static constexpr std::size_t max_places = 100;

  using QObject::QObject;

  /// Requests the reports of these runs, the most urgent first; cancels other work.
  void want(std::vector<std::shared_ptr<const ShownRun>> runs);
  /// Null until it is computed.
  std::shared_ptr<const ContourReport> report(const std::shared_ptr<const ShownRun>& run) const;
  bool busy() const { return job_.busy(); }

 signals:
  /// Another report is ready, or the last of the requested ones has failed.
  void changed();

 private:
  using Result = std::shared_ptr<const ContourReport>;

  void start_next();
  void take(const JobOutcome<Result>& outcome);

  Job<Result> job_;
  std::vector<std::shared_ptr<const ShownRun>> wanted_;
  std::shared_ptr<const ShownRun> under_way_;
  /// Null for a run whose report needs more memory than available.
  std::map<std::weak_ptr<const ShownRun>, Result, std::owner_less<>> reports_;
};

}  // namespace feedscope::ui

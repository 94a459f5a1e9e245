#pragma once

#include <QFutureWatcher>
#include <QObject>
#include <map>
#include <memory>
#include <vector>

#include "core/analysis/contour/contour_report.h"
#include "ui/models/shown_run.h"

namespace feedscope::ui {

/// Makes the contour reports of runs on another thread, one after the other, and keeps them as long as their
/// runs live, the one made last until the next. All signals in the thread of this object. Destruction while
/// busy cancels.
class ContourJob : public QObject {
  Q_OBJECT

 public:
  static constexpr std::size_t most_places = 100;

  explicit ContourJob(QObject* parent = nullptr);
  ~ContourJob() override;

  /// Runs whose reports are wanted now, the most urgent one first; what else is under way is given up.
  void want(std::vector<std::shared_ptr<const ShownRun>> runs);
  /// Null while it has not been made.
  std::shared_ptr<const ContourReport> report(const std::shared_ptr<const ShownRun>& run) const;
  bool busy() const { return progress_ != nullptr; }

 signals:
  /// Another report is there, or the last one of those wanted has failed.
  void changed();

 private:
  using Result = std::shared_ptr<const ContourReport>;

  void launch();
  void deliver();

  QFutureWatcher<Result> watcher_;
  std::vector<std::shared_ptr<const ShownRun>> wanted_;
  std::shared_ptr<const ShownRun> under_way_;
  std::shared_ptr<Progress> progress_;  ///< while busy
  /// Null for a run that needs more memory than there is.
  std::map<std::weak_ptr<const ShownRun>, Result, std::owner_less<>> reports_;
};

}  // namespace feedscope::ui

#pragma once

#include <QFutureWatcher>
#include <QObject>
#include <QString>
#include <memory>
#include <optional>
#include <vector>

#include "core/analysis/explanation/remedies.h"

namespace feedscope::ui {

/// What is to be tried on a run, and the blocks whose time is asked for besides the cycle time.
struct RemedyRequest {
  Run run;
  std::vector<Remedy> remedies;
  SegmentRange here;
};

/// What one of them gives.
struct RemedyTrial {
  double cycle_time = 0;    ///< [s]
  double passage_time = 0;  ///< of RemedyRequest::here [s]
  QString failure;          ///< why there is no result; "" if there is one
};

/// Simulates a run with one change after another on another thread. A new request drops the one under way.
/// All signals in the thread of this object. Destruction while busy cancels.
class RemedyJob : public QObject {
  Q_OBJECT

 public:
  explicit RemedyJob(QObject* parent = nullptr);
  ~RemedyJob() override;

  void start(RemedyRequest request);
  void cancel();
  bool busy() const { return running_; }

 signals:
  /// The trial of remedy `index` of the last request.
  void tried(std::size_t index, const feedscope::ui::RemedyTrial& trial);
  /// All have been tried, or the rest was cancelled.
  void finished();

 private:
  void launch();
  void work(const RemedyRequest& request, const std::shared_ptr<Progress>& progress);

  QFutureWatcher<void> watcher_;
  std::shared_ptr<Progress> progress_;
  std::optional<RemedyRequest> next_;
  bool running_ = false;
};

}  // namespace feedscope::ui

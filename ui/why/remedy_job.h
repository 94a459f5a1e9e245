#pragma once

#include <QObject>
#include <QString>
#include <vector>

#include "core/analysis/explanation/remedies.h"
#include "ui/shared/job.h"

namespace feedscope::ui {

/// Changes to try on a run, and the blocks whose time is computed in addition to the cycle time.
struct RemedyRequest {
  Run run;
  std::vector<Remedy> remedies;
  SegmentRange here;
};

/// Result of one trial.
struct RemedyTrial {
  double cycle_time = 0;    ///< [s]
  double passage_time = 0;  ///< of RemedyRequest::here [s]
  QString failure;          ///< reason without a result; "" otherwise
};

/// Simulates a run with one change after another on another thread. A new request cancels the running one.
/// All signals in the thread of this object.
class RemedyJob : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  void start(RemedyRequest request);
  void cancel() { job_.cancel(); }
  bool busy() const { return job_.busy(); }

 signals:
  /// The trial of remedy `index` of the last request.
  void tried(std::size_t index, const feedscope::ui::RemedyTrial& trial);
  /// All have been tried, or the rest was cancelled.
  void finished();

 private:
  struct AllTried {};

  Job<AllTried> job_;
};

}  // namespace feedscope::ui

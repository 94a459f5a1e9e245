#pragma once

#include <QObject>
#include <QString>
#include <vector>

#include "core/analysis/explanation/remedies.h"
#include "ui/shared/job.h"

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

#pragma once

#include <QObject>
#include <memory>
#include <optional>

#include "core/analysis/study/study.h"
#include "ui/shared/job.h"

namespace feedscope::ui {

/// A setup, and the values of one of its settings.
struct StudyJobRequest {
  LoadedProgram program;
  Setup setup;
  Sweep sweep;
  std::optional<double> within;  ///< bound of the contour error [mm]
};

/// Simulates a study on other threads, as many runs at a time as there are processors. All signals in the
/// thread of this object.
class StudyJob : public QObject {
  Q_OBJECT

 public:
  explicit StudyJob(QObject* parent = nullptr);

  /// Throws InputError with key, value and bound if the setup cannot have a value.
  void start(const StudyJobRequest& request);
  void cancel() { job_.cancel(); }
  bool busy() const { return job_.busy(); }

 signals:
  /// `fraction` is done, 0 to 1; emitted a few times a second.
  void progressed(double fraction);
  void finished(std::shared_ptr<const feedscope::Study> study);
  void cancelled();
  /// `message` for the user.
  void failed(const QString& message);

 private:
  using Result = std::shared_ptr<const Study>;

  void deliver(const JobOutcome<Result>& outcome);

  Job<Result> job_;
};

}  // namespace feedscope::ui

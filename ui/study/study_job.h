#pragma once

#include <QFutureWatcher>
#include <QObject>
#include <QTimer>
#include <memory>
#include <optional>

#include "core/analysis/study/study.h"

namespace feedscope::ui {

/// A setup whose setting takes one value after the other.
struct StudyJobRequest {
  LoadedProgram program;
  Setup setup;
  Sweep sweep;
  std::optional<double> within;  ///< bound of the contour error [mm]
};

/// Simulates a study on other threads, as many runs at a time as there are processors. All signals in the
/// thread of this object. Destruction while busy cancels.
class StudyJob : public QObject {
  Q_OBJECT

 public:
  explicit StudyJob(QObject* parent = nullptr);
  ~StudyJob() override;

  /// Throws InputError naming key, value and bound if the setup cannot take a value. Nothing may be under
  /// way.
  void start(const StudyJobRequest& request);
  void cancel();
  bool busy() const { return progress_ != nullptr; }

 signals:
  /// `fraction` is done, 0 to 1; a few times a second.
  void progressed(double fraction);
  void finished(std::shared_ptr<const feedscope::Study> study);
  void cancelled();
  /// `message` for the user.
  void failed(const QString& message);

 private:
  struct Outcome {
    std::shared_ptr<const Study> study;  ///< null: cancelled or failed
    QString failure;
  };
  void deliver();

  QFutureWatcher<Outcome> watcher_;
  QTimer poll_;
  std::shared_ptr<Progress> progress_;  ///< while busy
};

}  // namespace feedscope::ui

#pragma once

#include <QObject>
#include <QString>
#include <memory>
#include <string>
#include <vector>

#include "ui/identification/identification_outcome.h"
#include "ui/shared/job.h"

namespace feedscope::ui {

/// Fits models to recordings on other threads. All signals in the thread of this object.
class IdentificationJob : public QObject {
  Q_OBJECT

 public:
  explicit IdentificationJob(QObject* parent = nullptr);

  void start(IdentificationRequest request);
  void cancel() { job_.cancel(); }
  bool busy() const { return job_.busy(); }

 signals:
  /// `fraction` is done, 0 to 1; `stage`: the current activity, for the user. Emitted a few times a second.
  void progressed(double fraction, const QString& stage);
  void finished(std::shared_ptr<const feedscope::ui::IdentificationOutcome> outcome);
  void cancelled();
  /// `message` for the user.
  void failed(const QString& message);

 private:
  using Result = std::shared_ptr<const IdentificationOutcome>;

  void deliver(const JobOutcome<Result>& outcome);
  QString stage_text(double fraction) const;

  Job<Result> job_;
  std::vector<std::string> titles_;  ///< of the models under way
};

}  // namespace feedscope::ui

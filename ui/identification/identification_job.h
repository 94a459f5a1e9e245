#pragma once

#include <QObject>
#include <QString>
#include <memory>
#include <string>
#include <vector>

#include "core/identification/recordings.h"
#include "ui/shared/job.h"

namespace feedscope::ui {

/// A table of section times that was opened.
struct SectionTable {
  QString name;  ///< of its file
  std::vector<SectionTime> times;
};

/// A model with the machine that is begun with, and what of them is to be found.
struct IdentificationStart {
  Setup setup;
  std::vector<std::string> keys;

  bool operator==(const IdentificationStart&) const = default;
};

/// What is to be explained, by which models.
struct IdentificationRequest {
  LoadedProgram program;
  std::vector<std::shared_ptr<const Trace>> traces;
  std::vector<std::shared_ptr<const SectionTable>> tables;
  std::vector<IdentificationStart> starts;

  /// Another reading of a file is another recording.
  bool operator==(const IdentificationRequest& other) const {
    return program.program == other.program.program && traces == other.traces && tables == other.tables &&
           starts == other.starts;
  }
};

/// A model that could not be fitted.
struct UnfittedModel {
  std::string title;  ///< of the model
  std::string reason;
};

struct IdentificationOutcome {
  IdentificationRequest request;
  std::vector<Identification> models;   ///< the one that explains best first; at least one
  std::vector<UnfittedModel> unfitted;  ///< of request.starts
};

/// Fits models to recordings on other threads. All signals in the thread of this object.
class IdentificationJob : public QObject {
  Q_OBJECT

 public:
  explicit IdentificationJob(QObject* parent = nullptr);

  void start(IdentificationRequest request);
  void cancel() { job_.cancel(); }
  bool busy() const { return job_.busy(); }

 signals:
  /// `fraction` is done, 0 to 1; `stage`: what is being done, for the user. A few times a second.
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

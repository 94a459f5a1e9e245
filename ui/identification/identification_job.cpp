#include "ui/identification/identification_job.h"

#include <algorithm>
#include <deque>
#include <string_view>
#include <utility>

#include "core/base/error.h"
#include "ui/language/core_texts.h"

namespace feedscope::ui {
namespace {

constexpr double share_of_matching = 0.05;

Recordings recordings_of(const IdentificationRequest& request) {
  Recordings recordings;
  for (const auto& trace : request.traces) {
    recordings.add(trace, request.program);
  }
  for (const auto& table : request.tables) {
    recordings.add(table->times, table->name.toStdString(), request.program);
  }
  return recordings;
}

/// Fits one model. `matched`: number of recordings to match to the program; `share`: of the work.
Identification fit(Recordings& recordings, std::size_t matched, const IdentificationStart& start,
                   const std::string& date, Progress& whole, double share) {
  IdentifyOptions options;
  options.date = date;
  std::deque<Progress> parts;  // its elements are not moved in memory
  const auto stage = [&](std::string_view title) {
    if (!parts.empty()) {
      parts.back().report(1);
    }
    return &parts.emplace_back(
        whole, share * (title == "fitting" ? 1 - share_of_matching
                                           : share_of_matching / static_cast<double>(matched)));
  };
  return recordings.fit(start.setup, fit_parameters_of(start.setup, start.keys), options, stage);
}

}  // namespace

IdentificationJob::IdentificationJob(QObject* parent) : QObject(parent) {
  connect(&job_, &JobBase::progressed, this,
          [this](double fraction) { emit progressed(fraction, stage_text(fraction)); });
}

void IdentificationJob::start(IdentificationRequest request) {
  titles_.clear();
  for (const IdentificationStart& one : request.starts) {
    titles_.push_back(one.setup.model->info().title);
  }
  job_.start(
      [request = std::move(request)](JobControl& control) -> Result {
        auto outcome = std::make_shared<IdentificationOutcome>();
        outcome->date = date_of_today();
        outcome->program = program_mark(request.program);
        outcome->recordings = used_recordings(request);
        Recordings recordings = recordings_of(request);
        const std::size_t matched = std::max<std::size_t>(1, request.traces.size());
        const double share = 1 / static_cast<double>(request.starts.size());
        for (const IdentificationStart& one : request.starts) {
          try {
            outcome->models.push_back(fit(recordings, matched, one, outcome->date, control.progress, share));
          } catch (const InputError& error) {
            outcome->unfitted.push_back(
                {one.setup.model->info().title, error.message(), one.setup.model->info().id});
          }
        }
        if (outcome->models.empty()) {
          throw InputError(outcome->unfitted.front().reason);
        }
        sort_by_explanation(outcome->models);
        return outcome;
      },
      [this](const JobOutcome<Result>& outcome) { deliver(outcome); });
}

void IdentificationJob::deliver(const JobOutcome<Result>& outcome) {
  if (outcome.result) {
    emit finished(*outcome.result);
  } else if (outcome.cancelled()) {
    emit cancelled();
  } else {
    emit failed(outcome.failure);
  }
}

QString IdentificationJob::stage_text(double fraction) const {
  const double models = static_cast<double>(titles_.size()) * std::clamp(fraction, 0.0, 1.0);
  const std::size_t model = std::min(static_cast<std::size_t>(models), titles_.size() - 1);
  const double within = (models - static_cast<double>(model) - share_of_matching) / (1 - share_of_matching);
  const QString what = within < 0 ? tr("Laying the recordings beside the program")
                                  : tr("Searching: %1").arg(core_text(identification_stage(within)));
  return titles_.size() == 1 ? what
                             : tr("%1, model %2 of %3. %4")
                                   .arg(core_text(titles_[model]))
                                   .arg(model + 1)
                                   .arg(titles_.size())
                                   .arg(what);
}

}  // namespace feedscope::ui

#include "ui/workbench/time_findings.h"

#include <utility>

#include "core/analysis/notes/refused_lines.h"

namespace feedscope::ui {

namespace {

constexpr double longest_unasked = 5;  // of one run; beyond it, changes wait for a request [s]
constexpr int pause_ms =
    2500;  // pause before trying a run's changes after those of another: values often change again at once
constexpr std::size_t most_known = 16;

}  // namespace

TimeFindings::TimeFindings(QObject* parent) : QObject(parent) {
  pause_.setSingleShot(true);
  pause_.setInterval(pause_ms);
  connect(&pause_, &QTimer::timeout, this, &TimeFindings::try_wanted);
  connect(&job_, &TimeJob::done, this, &TimeFindings::take);
  connect(&job_, &TimeJob::progressed, this, &TimeFindings::progressed);
  connect(&job_, &TimeJob::ended, this, [this](const QString& failure) {
    if (!pause_.isActive()) {
      try_wanted();
    }
    emit state_changed(failure);
  });
}

void TimeFindings::set_run(std::shared_ptr<const ShownRun> shown, const SetupState& setup) {
  if (shown == shown_) {
    return;
  }
  const bool follows = setup_.has_value();  // without a run in between: the edit had no result yet
  cancel();
  shown_ = std::move(shown);
  if (shown_ != nullptr) {
    setup_ = setup;
  }
  report_ = recall();
  tried_ = report_ != nullptr && !report_->changes.tried.empty();
  wanted_ = has_time() && !tried_ && shown_->run.simulate_time < longest_unasked;
  if (wanted_ && follows) {
    pause_.start();
  }
  stale_ = has_time() && !tried_;
  emit changed();
  catch_up();
  emit state_changed({});
}

bool TimeFindings::has_time() const {
  return shown_ != nullptr && !is_refused(shown_->run) && shown_->run.summary.cycle_time > 0;
}

void TimeFindings::cancel() {
  wanted_ = asked_ = false;
  pause_.stop();
  job_.cancel();
}

void TimeFindings::set_watched(const QObject* viewer, bool seen) {
  if (seen) {
    viewers_.insert(viewer);
    catch_up();
  } else {
    viewers_.erase(viewer);
  }
}

void TimeFindings::catch_up() {
  if (!stale_ || viewers_.empty()) {
    return;
  }
  if (report_ == nullptr) {
    look();
  } else if (!pause_.isActive()) {
    try_wanted();
  }
}

void TimeFindings::try_changes() {
  if (!has_time()) {
    return;
  }
  pause_.stop();
  wanted_ = asked_ = true;
  if (report_ == nullptr) {
    look();
  } else {
    try_wanted();
  }
}

void TimeFindings::look() {
  stale_ = false;
  job_.look(shown_);
  emit state_changed({});
}

void TimeFindings::try_wanted() {
  if (!wanted_ || job_.busy() || (gives_way_ && !asked_) || report_ == nullptr ||
      !(report_->use.cycle_time > 0)) {
    return;
  }
  wanted_ = false;
  job_.try_changes(shown_, report_);
  emit state_changed({});
}

void TimeFindings::give_way(bool to_others) {
  gives_way_ = to_others;
  if (asked_ || shown_ == nullptr || tried_) {
    return;
  }
  if (to_others && trying()) {
    wanted_ = true;
    job_.cancel();
  } else if (!to_others && wanted_ && report_ != nullptr && !job_.busy()) {
    pause_.start();
  }
}

void TimeFindings::take(const std::shared_ptr<const TimeReport>& report) {
  report_ = report;
  tried_ = tried_ || !report->changes.tried.empty();
  asked_ = asked_ && !tried_;
  remember();
  emit changed();
}

void TimeFindings::remember() {
  std::erase_if(known_, [&](const Known& known) {
    const auto run = known.run.lock();
    return run == nullptr || run == shown_->run.trajectory;
  });
  if (known_.size() == most_known) {
    known_.erase(known_.begin());
  }
  known_.push_back({shown_->run.trajectory, report_});
}

std::shared_ptr<const TimeReport> TimeFindings::recall() const {
  for (const Known& known : known_) {
    if (shown_ != nullptr && known.run.lock() == shown_->run.trajectory) {
      return known.report;
    }
  }
  return nullptr;
}

SetupState TimeFindings::changed_by(const Remedy& remedy) const {
  SetupState setup = *setup_;
  if (!remedy.machine.empty()) {
    const Setup changed = with_remedy(setup.setup(), remedy);
    return SetupState::between(make_setup({remedy.machine, changed.model->info().id, std::nullopt}), changed);
  }
  for (const auto& [key, value] : remedy.changes) {
    setup.set(key, value);
  }
  return setup;
}

}  // namespace feedscope::ui

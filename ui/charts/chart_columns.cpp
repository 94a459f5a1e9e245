#include "ui/charts/chart_columns.h"

#include <utility>

#include "ui/charts/mean_line.h"

namespace feedscope::ui {

void ChartColumns::set_run(std::shared_ptr<const Trajectory> trajectory,
                           std::shared_ptr<const Envelope> envelope) {
  trajectory_ = std::move(trajectory);
  envelope_ = std::move(envelope);
  cache_.clear();
}

void ChartColumns::update(const ViewRange& range, int count) {
  if (envelope_ == nullptr) {
    cache_.clear();
    return;
  }
  if (std::exchange(rapids_, range.rapids_shown()) != rapids_) {
    cache_.clear();
  }
  cache_.update(
      *envelope_, trajectory_->duration(), {range.lower(), range.upper()}, count,
      [&range](double position) { return range.time_at(position); }, rapids_);
}

std::vector<ColumnStretch> ChartColumns::shown_stretches() const {
  return rapids_ ? RapidTimes().outside(times()) : envelope_->rapids().outside(times());
}

std::vector<float> ChartColumns::means() const {
  return times().empty() ? std::vector<float>() : mean_feeds(*trajectory_, shown_stretches(), bands().size());
}

std::vector<std::optional<CauseKind>> ChartColumns::dominating() const {
  if (times().empty()) {
    return {};
  }
  return rapids_ ? envelope_->causes().dominating(times())
                 : envelope_->causes().dominating(shown_stretches(), bands().size());
}

std::vector<double> ChartColumns::causes() const {
  if (times().empty()) {
    return {};
  }
  return rapids_ ? envelope_->causes().between(times().front(), times().back())
                 : envelope_->causes().within(shown_stretches());
}

bool ChartColumns::crowded() const {
  constexpr std::size_t pieces_a_column = 10;
  if (times().size() < 2 || trajectory_->pieces().empty()) {
    return false;
  }
  const std::size_t pieces = trajectory_->piece_at(times().back()) - trajectory_->piece_at(times().front());
  return pieces >= pieces_a_column * bands().size();
}

}  // namespace feedscope::ui

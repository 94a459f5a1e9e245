#include "core/program/path/spindle_tracker.h"

#include <limits>

namespace feedscope {

SpindleTracker::SpindleTracker(std::vector<SpindleState>& states, DiagnosticLog& log)
    : states_(states), log_(log) {
  states_.emplace_back();
  indices_.emplace(SpindleState(), std::uint16_t{0});
}

std::uint16_t SpindleTracker::index(double speed, const DiagnosticLog::Place& place) {
  using enum SpindleState::Turning;
  constexpr std::size_t most = std::numeric_limits<std::uint16_t>::max();
  const SpindleState now{tool_, speed, stands_ ? stands : surface_speed_ ? surface_speed : as_said};
  if (states_[last_] == now) {
    return last_;
  }
  if (const auto found = indices_.find(now); found != indices_.end()) {
    last_ = found->second;
  } else if (states_.size() <= most) {
    last_ = static_cast<std::uint16_t>(states_.size());
    states_.push_back(now);
    indices_.emplace(now, last_);
  } else {
    last_ = 0;
    log_.add(Severity::warning, "spindle-speeds", 0, place, [] {
      return DiagnosticLog::Text{
          NC_("core", "the program has more than 65535 different spindle speeds"),
          NC_("core", "motions with further ones have no spindle speed and no cutting load")};
    });
  }
  return last_;
}

}  // namespace feedscope

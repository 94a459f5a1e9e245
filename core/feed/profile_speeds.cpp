#include "core/feed/profile_speeds.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace feedscope {

ProfileSpeeds::Rise::Rise(double slow, double fast, const RampLimits& limits)
    : slow_(slow), fast_(fast), jerk_(limits.jerk) {
  const auto [A, J] = limits;
  const double step = std::max(fast - slow, 0.0);
  const bool is_gentle = step <= A * A / J;
  const double growth = is_gentle ? std::sqrt(step / J) : A / J;
  held_ = advance({0, slow, 0}, J, growth);
  const Motion1d released = is_gentle ? held_ : advance(held_, 0, step / A - growth);
  held_speed_ = released.v;
  length_ = advance(released, -J, growth).s;
}

double ProfileSpeeds::Rise::length_to(double speed) const {
  if (speed <= slow_) {
    return 0;
  }
  if (speed <= held_.v) {
    const double time = std::sqrt(2 * (speed - slow_) / jerk_);
    return time * (slow_ + jerk_ * time * time / 6);
  }
  if (speed <= held_speed_) {
    return advance(held_, 0, (speed - held_.v) / held_.a).s;
  }
  const double time = std::sqrt(2 * std::max(fast_ - speed, 0.0) / jerk_);  // until the fast end
  return length_ - time * (fast_ - jerk_ * time * time / 6);
}

ProfileSpeeds::ProfileSpeeds(double v0, double v1, double length, double ceiling, const RampLimits& limits)
    : top_(std::max(v0, profile_peak(v0, v1, length, ceiling, limits))),
      up_(v0, top_, limits),
      down_(v1, top_, limits),
      length_(length) {}

Bracket ProfileSpeeds::above(double speed) const {
  if (speed >= top_) {
    constexpr double nowhere = std::numeric_limits<double>::infinity();
    return {nowhere, -nowhere};
  }
  return {up_.length_to(speed), length_ - down_.length_to(speed)};
}

}  // namespace feedscope

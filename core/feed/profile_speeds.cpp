#include "core/feed/profile_speeds.h"

#include <cmath>
#include <limits>

namespace feedscope {

ProfileSpeeds::Rise::Rise(double slow, double fast, const Phase& first, const Phase& second)
    : slow_(slow), fast_(fast), jerk_(std::abs(first.jerk)), held_time_(second.duration) {
  held_ = advance({0, slow, 0}, jerk_, first.duration);
  const Motion1d released = advance(held_, 0, held_time_);
  held_speed_ = released.v;
  length_ = advance(released, -jerk_, first.duration).s;
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

ProfileSpeeds::ProfileSpeeds(const SpeedProfile& profile) {
  const auto& phases = profile.phases;
  const auto change = [](const Phase& first, const Phase& second) {
    return first.jerk * first.duration * (first.duration + second.duration);
  };
  if (profile.peak < profile.v0) {  // slows down at once, and holds what it comes to
    top_ = profile.v0;
    down_ = Rise(top_ + change(phases[0], phases[1]), top_, phases[0], phases[1]);
    end_of_fall_ = down_.length();
    return;
  }
  top_ = profile.peak;
  up_ = Rise(profile.v0, top_, phases[0], phases[1]);
  down_ = Rise(top_ + change(phases[4], phases[5]), top_, phases[4], phases[5]);
  end_of_fall_ = up_.length() + top_ * phases[SpeedProfile::held].duration + down_.length();
}

Bracket ProfileSpeeds::above(double speed) const {
  if (speed >= top_) {
    constexpr double nowhere = std::numeric_limits<double>::infinity();
    return {nowhere, -nowhere};
  }
  return {up_.length_to(speed), end_of_fall_ - down_.length_to(speed)};
}

}  // namespace feedscope

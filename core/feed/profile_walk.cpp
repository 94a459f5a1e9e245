#include "core/feed/profile_walk.h"

#include <algorithm>
#include <cmath>

#include "core/base/roots.h"

namespace feedscope {

ProfileWalk::ProfileWalk(const SpeedProfile& profile)
    : profile_(profile), start_{0, profile.v0, profile.a0}, at_(start_), largest_(profile.v0) {
  skip_empty();
}

void ProfileWalk::skip_empty() {
  while (phase_ < profile_.phases.size() && !(profile_.phases[phase_].duration > tau_)) {
    start_ = at_;
    tau_ = 0;
    ++phase_;
    at_.a = start_.a = phase_ == SpeedProfile::held ? 0 : at_.a;
  }
}

void ProfileWalk::move_by(double time) {
  const Phase& phase = profile_.phases[phase_];
  const bool to_end = time >= phase.duration - tau_;
  tau_ = to_end ? phase.duration : tau_ + time;
  const double before = at_.a;
  at_ = advance(start_, phase.jerk, tau_);
  largest_ = std::max(largest_, at_.v);
  if (before > 0 && at_.a < 0) {  // the speed peaks inside the phase
    largest_ = std::max(largest_, at_.v + at_.a * at_.a / (2 * std::abs(phase.jerk)));
  }
  skip_empty();
}

double ProfileWalk::time_to(double s) const {
  const double left = phase_left();
  const double j = jerk();
  if (advance(at_, j, left).s <= s) {
    return left;
  }
  const double guess = at_.v > 0 ? std::min((s - at_.s) / at_.v, left / 2) : left / 2;
  return rising_root({0, left}, guess, {.value = 1e-13, .width = 1e-15 * (1 + left)}, [&](double time) {
    const Motion1d there = advance(at_, j, time);
    return ValueAndSlope{there.s - s, there.v};
  });
}

const Motion1d& ProfileWalk::move_to(double s) {
  largest_ = at_.v;
  while (phase_ < profile_.phases.size()) {
    const double left = phase_left();
    const double time = time_to(s);
    move_by(time);
    if (time < left) {
      break;
    }
  }
  return at_;
}

}  // namespace feedscope

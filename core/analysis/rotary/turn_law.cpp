#include "core/analysis/rotary/turn_law.h"

#include <algorithm>
#include <cmath>

#include "core/toolpath/turn_course.h"

namespace feedscope {

TurnLaw::TurnLaw(const RotaryTurn& turn, std::span<const RotaryAxis> axes, const RotaryAxis& axis)
    : from_(turn.from[rotary_place(axis.name)]), to_(turn.to[rotary_place(axis.name)]) {
  if (from_ == to_) {
    return;
  }
  if (turn.law.way > 0) {
    way_ = turn.law.way;
    share_ = (to_ - from_) / way_;
    velocity_ = turn.law.velocity;
    acceleration_ = turn.law.acceleration;
    jerk_ = turn.law.jerk;
    return;
  }
  if (!(turn.feed > 0)) {
    share_ = std::copysign(1, to_ - from_);
    way_ = std::abs(to_ - from_);
    velocity_ = axis.velocity;
    acceleration_ = axis.acceleration;
    jerk_ = axis.jerk;
    return;
  }
  const auto turned = [&](const RotaryAxis& other) {
    return turn.to[rotary_place(other.name)] - turn.from[rotary_place(other.name)];
  };
  for (const RotaryAxis& other : axes) {
    way_ = std::hypot(way_, turned(other));
  }
  share_ = (to_ - from_) / way_;
  velocity_ = turn.feed;
  acceleration_ = jerk_ = HUGE_VAL;
  for (const RotaryAxis& other : axes) {
    if (const double share = std::abs(turned(other)) / way_; share > 0) {
      velocity_ = std::min(velocity_, other.velocity / share);
      acceleration_ = std::min(acceleration_, other.acceleration / share);
      jerk_ = std::min(jerk_, other.jerk / share);
    }
  }
}

Series TurnLaw::at(double time) const {
  if (share_ == 0) {
    return to_;
  }
  const RestToRestPlace at = rest_to_rest_at(time, way_, velocity_, acceleration_, jerk_);
  return Series(from_) + share_ * Series(at.way, at.velocity, at.acceleration, at.jerk);
}

RestToRestPlace TurnLaw::largest() const {
  if (share_ == 0) {
    return {};
  }
  const RestToRestPlace most = rest_to_rest_peaks(way_, velocity_, acceleration_, jerk_);
  const double share = std::abs(share_);
  return {share * most.way, share * most.velocity, share * most.acceleration, share * most.jerk};
}

}  // namespace feedscope

#include "core/toolpath/joint_stop.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/roots.h"

namespace feedscope {
namespace {

struct Start {
  double time = 0;   // [s]
  double speed = 0;  // at its end [mm/s]
};

/// Motion that starts at a given speed without acceleration, speeds up to `top` and keeps that speed.
class SpeedingUp {
 public:
  SpeedingUp(double speed, double top, double acceleration, double jerk)
      : speed_(std::min(speed, top)), top_(top), acceleration_(acceleration), jerk_(jerk) {
    grows_ = std::isinf(jerk) ? 0 : acceleration / jerk;
    const double grown = std::isinf(jerk) ? 0 : acceleration * grows_ / 2;
    topped_ = speed_ + grown >= top ? std::sqrt(2 * (top - speed_) / jerk)
                                    : grows_ + (top - speed_ - grown) / acceleration;
  }

  Start over(double way) const {
    const double until_top = way_after(topped_);
    if (way >= until_top) {
      return {topped_ + (way - until_top) / top_, top_};
    }
    constexpr int halvings = 50;
    const double time = halve({0, topped_}, halvings, [&](double at) { return way_after(at) < way; }).low;
    return {time, speed_after(time)};
  }

 private:
  double speed_after(double time) const {
    const double growing = std::min(time, grows_);
    return speed_ + (growing > 0 ? jerk_ * growing * growing / 2 : 0) +
           (time > grows_ ? acceleration_ * (time - grows_) : 0);
  }
  double way_after(double time) const {
    const double growing = std::min(time, grows_);
    double way = speed_ * growing + (growing > 0 ? jerk_ * growing * growing * growing / 6 : 0);
    if (time > grows_) {
      const double even = time - grows_;
      way += speed_after(grows_) * even + acceleration_ * even * even / 2;
    }
    return way;
  }

  double speed_, top_, acceleration_, jerk_;
  double grows_ = 0;   // how long the acceleration grows [s]
  double topped_ = 0;  // time at which the top is reached [s]
};

}  // namespace

bool stop_is_faster(const TurnJoint& joint, const std::array<StopSide, 2>& sides, double blend) {
  constexpr double clearly = 0.95;
  constexpr double unlimited = 1e4;  // for a feed without any limit [mm/s]
  const double speed = std::min({joint.limit.speed, sides[0].top, sides[1].top, unlimited});
  double passing = blend > 0 ? blend / speed : 0;
  double stopping = 0;
  for (const StopSide& side : sides) {
    const double acceleration =
        side.shaped ? std::min(side.acceleration, joint.ramp.acceleration) : side.acceleration;
    const double jerk = side.shaped ? std::min(side.jerk, joint.ramp.jerk) : side.jerk;
    if (!std::isfinite(side.acceleration) || !(acceleration > 0) || !(jerk > 0)) {
      return false;
    }
    const double top = std::min(side.top, unlimited);
    const Start pass = SpeedingUp(speed, top, acceleration, jerk).over(side.way);
    const Start rest = SpeedingUp(0, top, side.acceleration, side.jerk).over(side.way);
    passing += pass.time;
    stopping += rest.time;
    const double lost = std::pow(pass.speed - rest.speed, 2) / (2 * side.acceleration);
    (pass.speed < rest.speed ? passing : stopping) += lost / std::max(pass.speed, rest.speed);
  }
  return stopping < clearly * passing;
}

double least_blend(const Toolpath& path, std::size_t segment, double tolerance, bool follows_program) {
  constexpr double straight = 1e-3;  // [rad]
  const double turn = (path.tangent_at_start(segment + 1) - path.tangent_at_end(segment)).norm();
  double least = HUGE_VAL;
  for (const std::size_t i : {segment, segment + 1}) {
    const std::optional<double>& own = path.path_control_of(i).contour_tolerance;
    least = std::min(least, own && follows_program ? *own : tolerance);
  }
  const double shorter = std::min(path.segments[segment].length, path.segments[segment + 1].length);
  return turn > straight ? std::min(least, shorter / 4) : 0;
}

}  // namespace feedscope

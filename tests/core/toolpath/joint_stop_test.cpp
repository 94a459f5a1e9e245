#include "core/toolpath/joint_stop.h"

#include <gtest/gtest.h>

#include <cmath>

namespace feedscope {
namespace {

TurnJoint joint_of(double speed, double acceleration, double jerk) {
  TurnJoint joint;
  joint.limit.speed = speed;
  joint.ramp.acceleration = acceleration;
  joint.ramp.jerk = jerk;
  return joint;
}

constexpr double huge = HUGE_VAL;

/// From rest over 1 mm at 2000 mm/s2 it takes sqrt(1/1000) s to either side.
TEST(JointStop, IsFasterThanCreeping) {
  const StopSide side{1, 1000, 2000, huge, true};
  EXPECT_TRUE(stop_is_faster(joint_of(0.1, 1, 1), {side, side}, 0));
  EXPECT_FALSE(stop_is_faster(joint_of(100, 1000, huge), {side, side}, 0));
}

/// A joint that holds no ramps is passed: from its speed on the tip is ahead of one that starts at rest.
TEST(JointStop, IsNeverFasterWhereTheJointHoldsNoRamps) {
  const StopSide side{1, 1000, 2000, 1e6, false};
  for (const double speed : {0.001, 0.1, 10.0, 500.0}) {
    EXPECT_FALSE(stop_is_faster(joint_of(speed, 1e-3, 1e-3), {side, side}, 0)) << speed;
  }
}

/// At constant speed 1 mm to either side takes 1/v s, from rest with jerk alone cbrt(6/j) s: equal at
/// v = 1/cbrt(6/j), of which a twentieth is not worth a stop.
TEST(JointStop, ComparesTheTimesOverTheReach) {
  constexpr double jerk = 6000;
  const double start = std::cbrt(6 / jerk);
  const StopSide held{1, 1000, 1e5, jerk, true};
  EXPECT_TRUE(stop_is_faster(joint_of(0.9 / start, 1e-6, huge), {held, held}, 0));
  EXPECT_FALSE(stop_is_faster(joint_of(1.1 / start, 1e-6, huge), {held, held}, 0));
}

/// 0.05 mm of a corner at 0.03 mm/s: its blend takes more than a second and a half.
TEST(JointStop, IsFasterWhereTheBlendOfTheCornerCreeps) {
  const StopSide side{5, 30, 2000, 1e5, false};
  EXPECT_TRUE(stop_is_faster(joint_of(0.03, huge, huge), {side, side}, 0.05));
  EXPECT_FALSE(stop_is_faster(joint_of(20, huge, huge), {side, side}, 0.05));
}

}  // namespace
}  // namespace feedscope

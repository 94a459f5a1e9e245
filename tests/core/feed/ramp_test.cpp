#include "core/feed/ramp.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <span>

#include "core/feed/profile_walk.h"

namespace feedscope {
namespace {

constexpr RampLimits limits{1000, 15000};

TEST(Ramp, BelowTheAccelerationLimitTakesTwiceTheRootOfStepOverJerk) {
  // 15 mm/s < A^2/J = 66.7 mm/s: two parabolas
  EXPECT_NEAR(ramp_time(5, 20, limits), 2 * std::sqrt(15.0 / 15000), 1e-15);
  EXPECT_NEAR(ramp_length(5, 20, limits), 25 * std::sqrt(15.0 / 15000), 1e-13);
}

TEST(Ramp, WithTheAccelerationLimitTakesStepOverAccelerationPlusAccelerationOverJerk) {
  EXPECT_NEAR(ramp_time(0, 300, limits), 0.3 + 1.0 / 15, 1e-15);
  EXPECT_NEAR(ramp_length(300, 0, limits), 150 * (0.3 + 1.0 / 15), 1e-12);
}

TEST(Ramp, ReachableSpeedIsTheInverseOfTheLength) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> exponent(-4, 3);
  for (int i = 0; i < 2000; ++i) {
    const double v0 = i % 5 == 0 ? 0 : std::pow(10, exponent(random));
    const double length = std::pow(10, exponent(random));
    const double v1 = reachable_speed(v0, length, limits);
    ASSERT_GT(v1, v0);
    // the length is the difference of nearly equal speeds where v0 is large
    ASSERT_NEAR(ramp_length(v0, v1, limits), length, 1e-9 * length + 1e-7 * v0 * std::sqrt(v0) * 1e-4)
        << "v0 " << v0 << " length " << length;
  }
}

TEST(Ramp, SpeedChangeEndsAtTheTargetWithoutAccelerationFromAnyStart) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> speed(0, 400), acceleration(-1500, 1500);
  for (int i = 0; i < 5000; ++i) {
    const double v = speed(random), a = acceleration(random), target = speed(random);
    Motion1d motion{0, v, a};
    for (const Phase& phase : speed_change(v, a, target, limits)) {
      ASSERT_GE(phase.duration, 0) << v << ' ' << a << ' ' << target;
      ASSERT_LE(std::abs(phase.jerk), limits.jerk);
      motion = advance(motion, phase.jerk, phase.duration);
      ASSERT_LE(std::abs(motion.a), std::max(limits.acceleration, std::abs(a)) * (1 + 1e-12));
    }
    ASSERT_NEAR(motion.v, target, 1e-9);
    ASSERT_NEAR(motion.a, 0, 1e-8);
  }
}

TEST(Profile, FromRestToRestOverALongLineIsTwoRampsAndACruise) {
  const SpeedProfile profile = plan_profile(0, 0, 0, 100, 50, limits);
  ASSERT_TRUE(profile.feasible);
  EXPECT_DOUBLE_EQ(profile.peak, 50);
  const double ramps = 2 * ramp_length(0, 50, limits);
  EXPECT_NEAR(profile.duration(), 2 * ramp_time(0, 50, limits) + (100 - ramps) / 50, 1e-12);
}

TEST(Profile, FromRestToRestOverAShortLineIsFourParabolasOfTime) {
  // peak v with 2 v sqrt(v/J) = L, time 4 sqrt(v/J)
  const SpeedProfile profile = plan_profile(0, 0, 0, 1, 1000, limits);
  const double peak = std::cbrt(0.25 * limits.jerk);
  EXPECT_NEAR(profile.peak, peak, 1e-9);
  EXPECT_NEAR(profile.duration(), 4 * std::sqrt(peak / limits.jerk), 1e-12);
}

TEST(Profile, SaysWhenTheEndSpeedCannotBeReached) {
  EXPECT_FALSE(plan_profile(0, 0, 50, 0.1, 100, limits).feasible);
  EXPECT_FALSE(plan_profile(50, 0, 0, 0.1, 100, limits).feasible);
  EXPECT_TRUE(plan_profile(0, 0, reachable_speed(0, 0.1, limits), 0.1, 100, limits).feasible);
}

TEST(Profile, CoversItsLengthAndEndsAsAskedFromAnyFeasibleStart) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> speed(0, 100), acceleration(-400, 400), length(0.01, 30);
  int feasible = 0;
  for (int i = 0; i < 20000; ++i) {
    const double v0 = speed(random), a0 = i % 2 == 0 ? 0 : acceleration(random);
    const double v1 = speed(random), s = length(random);
    const SpeedProfile profile = plan_profile(v0, a0, v1, s, 150, limits);
    if (!profile.feasible || v0 - a0 * a0 / (2 * limits.jerk) < 0) {
      continue;
    }
    ++feasible;
    ASSERT_NEAR(profile.length(), s, 1e-8 * (s + 1)) << v0 << ' ' << a0 << ' ' << v1 << ' ' << s;
    ProfileWalk walk(profile);
    const Motion1d end = walk.move_to(2 * s);
    ASSERT_NEAR(end.v, v1, 1e-8);
    ASSERT_NEAR(end.a, 0, 1e-6);
    ASSERT_LE(walk.largest_speed(), std::max(150.0, v0 + a0 * a0 / (2 * limits.jerk)) * (1 + 1e-9));
  }
  EXPECT_GT(feasible, 10000);
}

TEST(Profile, HoldsItsPeakWithoutTheRoundingOfTheRampThatLedThere) {
  // 300 s at the peak: 1e-13 mm/s2 left of the ramp would be 5e-9 mm.
  constexpr double length = 4721;
  const SpeedProfile profile = plan_profile(0.27133, 99.882, 0, length, 15.25, {820, 44180.05});
  ASSERT_TRUE(profile.feasible);
  const auto covered = [](Motion1d motion, std::span<const Phase> phases) {
    for (const Phase& phase : phases) {
      motion = advance(motion, phase.jerk, phase.duration);
    }
    return motion.s;
  };
  const std::span phases(profile.phases);
  const double up = covered({0, profile.v0, profile.a0}, phases.first(3));
  const double held = profile.peak * profile.phases[3].duration;
  const double down = covered({0, profile.peak, 0}, phases.last(3));
  EXPECT_NEAR(up + held + down, length, 1e-11);
}

TEST(ProfileWalk, StopsAtThePathLengthAskedFor) {
  const SpeedProfile profile = plan_profile(10, 0, 5, 8, 60, limits);
  ProfileWalk walk(profile);
  for (double s = 0; s < 8; s += 0.37) {
    EXPECT_NEAR(walk.move_to(s).s, s, 1e-12);
  }
}

}  // namespace
}  // namespace feedscope

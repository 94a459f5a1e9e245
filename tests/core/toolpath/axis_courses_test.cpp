#include "core/toolpath/axis_courses.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/core/toolpath/table_machine.h"

namespace feedscope {
namespace {

constexpr std::size_t axis_c = 5;

const RotaryAxis& axis_of(const Machine& machine) {
  return *machine.kinematics.find('C');
}

TEST(AxisCourses, HoldTheTermsOfAConstantSpeed) {
  const Machine machine = table_machine();
  const RotaryAxis& c = axis_of(machine);
  const auto with = [&](double first, double second, double third) {
    AxisCourses courses(machine);
    courses.add(axis_c, Series(0, first, second, third));
    return courses.speed();
  };
  EXPECT_NEAR(with(0.2, 0, 0).speed, c.velocity / 0.2, 1e-9);
  EXPECT_NEAR(with(0, -0.02, 0).speed, std::sqrt(0.75 * c.acceleration / 0.02), 1e-9);
  EXPECT_NEAR(with(0, 0, 0.5).speed, std::cbrt(0.4 * c.jerk / 0.5), 1e-9);
  EXPECT_EQ(with(0, 0, 0.5).by, TurnLimit::By::jerk);
  EXPECT_EQ(with(0, 0, 0.5).axis, 5);
  EXPECT_EQ(with(0, 0, 0).speed, std::numeric_limits<double>::infinity());
}

TEST(AxisCourses, TakeWholeAccelerationsAndNoJerkForABound) {
  const Machine machine = table_machine();
  const RotaryAxis& c = axis_of(machine);
  AxisCourses courses(machine, {1, HUGE_VAL});
  courses.add(axis_c, Series(0, 0.05, 0.02, 0.5));
  EXPECT_EQ(courses.speed().by, TurnLimit::By::acceleration);
  EXPECT_NEAR(courses.speed().speed, std::sqrt(c.acceleration / 0.02), 1e-9);
  EXPECT_NEAR(courses.ramp(0, 0).acceleration, c.acceleration / 0.05, 1e-9);
  EXPECT_NEAR(courses.ramp(0, 3).acceleration, c.acceleration / (0.05 + 2 * 3 * 0.02), 1e-9);
  EXPECT_EQ(courses.ramp(0, 3).jerk, HUGE_VAL);
}

TEST(AxisCourses, GiveHalfOfTheJerkThatIsLeftToTheRampInABend) {
  const Machine machine = table_machine();
  AxisCourses courses(machine);
  courses.add(axis_c, Series(0, 0, 0.02, 0.001));
  const double speed = 10;
  const double left = axis_of(machine).jerk - speed * speed * speed * 0.001;
  EXPECT_NEAR(courses.ramp(speed, 0).acceleration, left / 2 / (3 * 0.02 * speed), 1e-9);
  EXPECT_EQ(courses.ramp(speed, 0).acceleration_axis, 5);
  EXPECT_TRUE(courses.ramp(speed, 0).acceleration_by_jerk);
  EXPECT_EQ(courses.ramp(speed, 0).jerk, std::numeric_limits<double>::infinity()) << "its slope is zero";
}

/// Whatever the derivatives: ramps within theirs keep acceleration and jerk of the axis within its limits,
/// with any signs, up to the speed that the tip has at the end of the reach.
TEST(AxisCourses, KeepEveryAxisWithinItsLimitsOnRamps) {
  const Machine machine = table_machine();
  const RotaryAxis& c = axis_of(machine);
  std::mt19937 random(22);
  const auto size = [&](double from, double to) {
    return std::exp(std::uniform_real_distribution<double>(std::log(from), std::log(to))(random));
  };
  for (int i = 0; i < 2000; ++i) {
    const double first = size(1e-5, 1), second = size(1e-5, 10), third = size(1e-5, 100);
    AxisCourses courses(machine);
    courses.add(axis_c, Series(0, first, second, third));
    const double speed = size(0.3, 1) * courses.speed().speed;
    const double reach = i % 3 == 0 ? 0 : size(0.01, 10);
    const TurnRamp ramp = courses.ramp(speed, reach);
    ASSERT_GT(ramp.acceleration, 0);
    ASSERT_GT(ramp.jerk, 0);
    const double fastest = std::sqrt(speed * speed + 2 * ramp.acceleration * reach);
    EXPECT_LE(second * fastest * fastest + first * ramp.acceleration, c.acceleration * (1 + 1e-9));
    EXPECT_LE(third * std::pow(fastest, 3) + 3 * second * fastest * ramp.acceleration + first * ramp.jerk,
              c.jerk * (1 + 1e-6));
  }
}

}  // namespace
}  // namespace feedscope

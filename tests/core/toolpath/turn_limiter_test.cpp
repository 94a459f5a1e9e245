#include "core/toolpath/turn_limiter.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "core/base/units.h"
#include "core/toolpath/joint_shape.h"
#include "core/toolpath/machine_path.h"
#include "tests/core/toolpath/table_machine.h"

namespace feedscope {
namespace {

constexpr double deg = units::pi / 180;

Settings with(std::initializer_list<std::pair<const char*, double>> values) {
  Settings settings;
  for (const auto& [key, value] : values) {
    settings.set(key, value);
  }
  return settings;
}

MachinePath path_of(const std::string& text, const Settings& settings,
                    const Machine& machine = table_machine()) {
  ReadOptions options;
  options.dialect = Dialect::sinumerik;
  options.unit = LengthUnit::mm;
  options.rotary_axes = "AC";
  const ReadProgram program =
      read_program(std::make_shared<const SourceText>("test.mpf", text), nullptr, options);
  return on_machine(std::make_shared<const Toolpath>(build_toolpath(program)), machine, settings);
}

/// C turns by 3 degrees a millimetre, then not at all.
constexpr const char* stops_turning = "TRAORI\nG0 X0 Y0 Z0\nG1 F60000 X20 C60\nX40\nX60\n";

TEST(TurnJoints, GoOverFromOneSlopeToTheOtherWithinTheOrientationTolerance) {
  const auto path = path_of(stops_turning, with({{"orientation_tolerance_deg", 0.1}}));
  ASSERT_EQ(path->turn_joints.size(), 1) << "where the turn ends; the first block begins at rest";
  const TurnJoint& joint = path->turn_joints[0];
  EXPECT_EQ(joint.segment, 0);
  EXPECT_NEAR(joint.step[2], -3 * deg, 1e-12);
  // A sixth of step and reach, 3 degrees a millimetre.
  const double half = 6 * 0.1 / 3;
  EXPECT_NEAR(joint.before, half, 1e-12);
  EXPECT_NEAR(joint.behind, half, 1e-12);
  EXPECT_NEAR(std::abs(joint_turn(joint, 2, 0).value()), 0.1 * deg, 1e-12);
  // v^2 step/half <= 0.75 A gives 8.5 mm/s, v^3 step/half^2 <= 0.4 J 4.2 mm/s.
  EXPECT_NEAR(joint.limit.speed, std::cbrt(0.4 * 14400 * half * half / 3), 1e-9);
  EXPECT_EQ(joint.limit.by, TurnLimit::By::jerk);
  EXPECT_EQ(joint.limit.axis, 5);
}

TEST(TurnJoints, ReachOverBothBlocksButNotMoreThanTwiceAsFarToOneSide) {
  const auto reach = [](const char* blocks) {
    const auto path = path_of(std::string("TRAORI\nG0 X0 Y0 Z0\nG1 F60000\n") + blocks,
                              with({{"orientation_tolerance_deg", 1}}));
    EXPECT_EQ(path->turn_joints.size(), 1);
    return std::pair(path->turn_joints[0].before, path->turn_joints[0].behind);
  };
  EXPECT_EQ(reach("X20 C0.02\nX20.5\n"), std::pair(1.0, 0.5));
  EXPECT_EQ(reach("X1 C0.02\nX1.75\n"), std::pair(1.0, 0.75));
}

/// C turns by s^2/2 degrees over s mm, in blocks of 1 mm: its second derivative is 1 degree/mm2 everywhere,
/// so that inside only the acceleration holds the tip, v^2 <= 0.75 A, however many blocks there are.
TEST(TurnJoints, OfEvenBlocksRunAsTheCurveThatTheBlocksStandFor) {
  std::string text = "TRAORI\nG0 X0 Y0 Z0\nG1 F60000\n";
  for (int i = 1; i <= 8; ++i) {
    text += fmt::format("X{} C{:.3f}\n", i, 0.5 * i * i);
  }
  const auto path = path_of(text, with({{"orientation_tolerance_deg", 0.5}}));
  ASSERT_EQ(path->turn_joints.size(), 7);
  for (std::size_t i = 1; i + 1 < path->turn_joints.size(); ++i) {
    const TurnJoint& joint = path->turn_joints[i];
    EXPECT_NEAR(joint.before, 1, 1e-9);
    EXPECT_NEAR(joint.behind, 1, 1e-9);
    EXPECT_NEAR(joint.limit.speed, std::sqrt(0.75 * 1440), 1e-3) << i;
    EXPECT_EQ(joint.limit.by, TurnLimit::By::acceleration) << i;
  }
  EXPECT_EQ(path->turn_joints.back().limit.by, TurnLimit::By::jerk) << "there it ends at once";
}

TEST(TurnJoints, LetTheVelocityJumpByAShareOfWhatAPeriodTakesUp) {
  // A step of 0.001 degrees a millimetre on blocks of 0.1 mm, as rounded numbers make it.
  const std::string text = "TRAORI\nG0 X0 Y0 Z0\nG1 F60000 X0.1 C0.0001\nX0.2\nX0.3\n";
  const auto rounded = path_of(text, with({}));
  const auto jumps = path_of(text, with({{"interpolation_period_s", 0.002}}));
  ASSERT_EQ(rounded->turn_joints.size(), 1);
  ASSERT_EQ(jumps->turn_joints.size(), 1);
  EXPECT_NEAR(rounded->turn_joints[0].limit.speed, std::cbrt(0.4 * 14400 * 0.01 / 0.001), 1e-6);
  EXPECT_NEAR(jumps->turn_joints[0].limit.speed, 0.2 * 1440 * 0.002 / 0.001, 1e-6);
  EXPECT_EQ(jumps->turn_joints[0].limit.by, TurnLimit::By::jump);
}

TEST(TurnJoints, AreWhereTheFeedGoesOnOnly) {
  const auto path = path_of(
      "TRAORI\nG0 X0 Y0 Z0\nG1 F6000 X20 C60\nG0 X40\nG1 X60 C80\nG4 F1\nG1 X80 C90\nX100 C100\nM30\n",
      with({}));
  EXPECT_EQ(path->segment_turns.size(), 4);
  EXPECT_EQ(path->turn_joints.size(), 0) << "the last two turn at one slope; before are a rapid and a dwell";
}

TEST(TurnJoints, CountTheLinearAxesThatMakeUpForTheTurn) {
  Machine machine = table_machine();
  machine.kinematics.tool_length = 150;
  const Settings placed = with({{"part_zero_x_mm", 400}, {"part_zero_y_mm", 0}, {"part_zero_z_mm", -300}});
  const auto path = path_of(stops_turning, placed, machine);
  ASSERT_EQ(path->turn_joints.size(), 1);
  // 420 mm from the axis of C, that changes its slope by 3 degrees a millimetre.
  const TurnJoint& joint = path->turn_joints[0];
  EXPECT_LT(joint.limit.axis, 3);
  EXPECT_EQ(joint.limit.by, TurnLimit::By::jerk);
  EXPECT_NEAR(joint.limit.speed, std::cbrt(0.4 * 50000 * joint.before * joint.behind / (3 * deg * 420)),
              0.05 * joint.limit.speed);
}

/// C goes as s^3/60 degrees over s mm, in blocks whose lengths differ by a tenth: the rounded course has the
/// second derivative s/10 of the curve that the blocks stand for. Its third one is not even, which costs
/// speed.
TEST(TurnJoints, OfUnevenBlocksRunAsTheCurveThatTheBlocksStandFor) {
  std::string text = "TRAORI\nG0 X0 Y0 Z0\nG1 F60000\n";
  double x = 0;
  for (int i = 0; i < 20; ++i) {
    x += i % 2 == 0 ? 0.95 : 1.05;
    text += fmt::format("X{:.3f} C{:.6f}\n", x, x * x * x / 60);
  }
  const auto path = path_of(text, with({{"orientation_tolerance_deg", 2}}));
  ASSERT_EQ(path->turn_joints.size(), 19);
  for (std::size_t i = 8; i < 18; ++i) {
    const TurnJoint& joint = path->turn_joints[i];
    const double place = path->segments[i].end.x();
    EXPECT_NEAR(joint_turn(joint, 2, 0).d2(), place / 10 * deg, 0.06 * place / 10 * deg) << i;
    const double of_the_curve = std::sqrt(0.75 * 1440 / (place / 10));
    EXPECT_LT(joint.limit.speed, 1.03 * of_the_curve) << i;
    EXPECT_GT(joint.limit.speed, 0.6 * of_the_curve) << i;
  }
}

/// On blocks that are twice as long by turns the second derivative is largest between the places. At the
/// speed of the nearer joint the axis stays within its acceleration everywhere.
TEST(TurnJoints, KeepTheAccelerationBetweenPlacesOfUnevenBlocks) {
  Machine machine = table_machine();
  for (RotaryAxis& axis : machine.kinematics.rotary) {
    axis.jerk *= 100;  // else it holds the tip before
  }
  std::mt19937 random(5);
  std::uniform_real_distribution<double> slope(-3, 3);
  std::string text = "TRAORI\nG0 X0 Y0 Z0\nG1 F60000\n";
  double x = 0, c = 0;
  for (int i = 0; i < 200; ++i) {
    const double length = i % 2 == 0 ? 1 : 2;
    x += length;
    c += length * slope(random);
    text += fmt::format("X{:.3f} C{:.6f}\n", x, c);
  }
  const auto path = path_of(text, with({{"orientation_tolerance_deg", 20}}), machine);
  ASSERT_EQ(path->turn_joints.size(), 199);
  double largest = 0;
  for (std::size_t i = 1; i < path->turn_joints.size(); ++i) {
    const TurnJoint& before = path->turn_joints[i - 1];
    const TurnJoint& behind = path->turn_joints[i];
    const double length = path->segments[behind.segment].length;
    if (before.stops || behind.stops) {
      continue;
    }
    for (int k = 0; k <= 20; ++k) {
      const double at = length * k / 20;
      const double speed = (at < length / 2 ? before : behind).limit.speed;
      const double second = joint_turn(before, 2, at).d2() + joint_turn(behind, 2, at - length).d2();
      largest = std::max(largest, std::abs(second) * speed * speed);
    }
  }
  EXPECT_LE(largest, 1440 * deg);
  EXPECT_GT(largest, 0.7 * 1440 * deg);
}

/// Beside blocks that do not turn a joint that reaches over all of its blocks holds their ramps, whatever
/// their length: none is cut short so that nothing would hold.
TEST(TurnJoints, ReachOverAllOfDenseBlocksBesideThoseThatDoNotTurn) {
  for (const double length : {0.8, 0.85, 0.9, 1.0, 1.3}) {
    std::string text = "TRAORI\nG0 X0 Y0 Z0\nG1 F3000\n";
    for (int i = 1; i <= 12; ++i) {
      text += fmt::format("X{:.3f} C{:.4f}\n", i * length, 3 * length * std::min(i, 4));
    }
    const auto path = path_of(text, with({{"orientation_tolerance_deg", 10}}));
    const TurnJoint* joint = path->turn_joint(3);
    ASSERT_NE(joint, nullptr);
    EXPECT_NEAR(joint->before, length, 1e-9);
    EXPECT_NEAR(joint->behind, length, 1e-9);
  }
}

}  // namespace
}  // namespace feedscope

#include "core/toolpath/tip_swing.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "core/base/units.h"
#include "tests/core/analysis/turned_runs.h"

namespace feedscope {
namespace {

using test::at;
using test::turned;
using test::TurnedRun;

/// The axis of C is at X0 Y0 of the part.
std::vector<std::string> known(std::vector<std::string> more = {}) {
  for (const char* text :
       {"tool_length_mm=80", "part_zero_x_mm=0", "part_zero_y_mm=0", "part_zero_z_mm=-280"}) {
    more.emplace_back(text);
  }
  return more;
}

double swing_time(const TurnedRun& run) {
  double sum = 0;
  for (const ToolpathPause& pause : run.path->pauses) {
    sum += pause.kind == Pause::swing ? pause.time : 0;
  }
  return sum;
}

/// C turns by 90 degrees under a tip 100 mm from its axis: X and Y run on a circle, at most at 10 mm/s. A
/// third of it takes the turn from and to rest at the limits of the machine at most.
TEST(TipSwing, IsAsSlowAsTheLinearAxesThatHoldTheTip) {
  const std::string text = "TRAORI\nG0 X100 Y0 Z50\nG1 C90 F100000\n";
  const TurnedRun run = turned(text, "essid", known({"X.velocity=0.6", "Y.velocity=0.6"}));
  const double at_limit = 100 * units::pi / 2 / 10;
  EXPECT_GT(swing_time(run), at_limit);
  EXPECT_LT(swing_time(run), at_limit + 0.5);
  const double middle = run.trajectory->duration() - swing_time(run) / 2;
  EXPECT_EQ(run.trajectory->state(middle).cause, (Cause{CauseKind::swing, 0}));
  EXPECT_NEAR(at(run, middle).rotary[2].position, units::pi / 4, 1e-6);
  const RotarySample here = at(run, middle);
  EXPECT_NEAR(std::hypot(here.linear[0].velocity, here.linear[1].velocity), 10, 0.01);
  EXPECT_LT(swing_time(turned(text, "essid", known())), 1.5);
}

/// Beside a motion of 0.001 mm the same turn is held by the same axes.
TEST(TipSwing, TakesAboutAsLongAsBesideATinyMotion) {
  const std::string start = "TRAORI\nG0 X10 Y5 Z20 A3=0 B3=0.5 C3=0.8660254\n";
  const std::vector<std::string> slow = known({"Y.velocity=0.5", "Z.velocity=0.5"});
  const TurnedRun before = turned(start, "essid", slow);
  const TurnedRun alone = turned(start + "G1 A3=0 B3=-0.5 C3=0.8660254 F100000\n", "essid", slow);
  const TurnedRun beside = turned(start + "G1 X10.001 A3=0 B3=-0.5 C3=0.8660254 F100000\n", "essid", slow);
  const double swing = alone.trajectory->duration() - before.trajectory->duration();
  const double along = beside.trajectory->duration() - before.trajectory->duration();
  EXPECT_NEAR(swing, along, 0.15 * along);
  EXPECT_EQ(alone.summary.time_by_cause[cause_index({CauseKind::indexing, 5})], 0);
}

/// All axes within their limits, and where their velocities say.
TEST(TipSwing, HoldsTheLimitsOfAllAxes) {
  // No great circle leads to the nearer position of the second vector: it passes the pole aside.
  for (const std::string way : {"ORIAXES A3=0.1 B3=0.7 C3=0.8", "ORIVECT A3=0.1 B3=0.7 C3=0.8",
                                "ORIAXES A3=-0.5 B3=0.1 C3=0.8", "ORIVECT A3=-0.5 B3=0.1 C3=0.8"}) {
    const TurnedRun run =
        turned(fmt::format("TRAORI\n{}\nG0 X60 Y-30 Z40 A3=0.3 B3=0.4 C3=0.8\nG1 {} F1000000\n",
                           way.substr(0, 7), way.substr(8)),
               "essid", known());
    const double begin = run.trajectory->duration() - swing_time(run);
    ASSERT_GT(swing_time(run), 0);
    constexpr int steps = 2000;
    const double step = swing_time(run) / steps;
    double most = 0;
    const auto holds = [&](const AxisState& here, const AxisState& next, double velocity, double acceleration,
                           double jerk) {
      EXPECT_LE(std::abs(here.velocity), velocity * (1 + 1e-6)) << way;
      EXPECT_LE(std::abs(here.acceleration), acceleration * (1 + 1e-6)) << way;
      EXPECT_LE(std::abs(here.jerk), jerk * (1 + 1e-6)) << way;
      EXPECT_NEAR((next.position - here.position) / step, (next.velocity + here.velocity) / 2,
                  jerk * step * step)
          << way;
      most = std::max({most, std::abs(here.velocity) / velocity, std::abs(here.acceleration) / acceleration,
                       std::abs(here.jerk) / jerk});
    };
    for (int i = 1; i + 1 < steps; ++i) {
      const RotarySample here = at(run, begin + i * step);
      const RotarySample next = at(run, begin + (i + 1) * step);
      for (std::size_t k = 0; k < 3; ++k) {
        const AxisLimits& limits = *run.setup.machine.axes.find("XYZ"[k]);
        holds(here.linear[k], next.linear[k], limits.velocity, limits.acceleration, limits.jerk);
        if (const RotaryAxis* axis = run.setup.machine.kinematics.find("ABC"[k])) {
          holds(here.rotary[k], next.rotary[k], axis->velocity, axis->acceleration, axis->jerk);
        }
      }
    }
    EXPECT_GT(most, 0.6) << way;
  }
}

/// 60 degrees at 600 degrees a minute; a time that G93 gives.
TEST(TipSwing, FollowsAFeedInDegreesAMinute) {
  EXPECT_NEAR(swing_time(turned("TRAORI\nG0 X5 Y0 Z20\nG1 C60 F600\n", "essid", known())), 6, 0.2);
  EXPECT_NEAR(swing_time(turned("TRAORI\nG0 X5 Y0 Z20\nG93 G1 C60 F20\n", "essid", known())), 3, 0.2);
}

TEST(TipSwing, IsATurnOfRotaryAxesAloneWhereTheTipIsNotHeld) {
  EXPECT_EQ(swing_time(turned("G0 X100 Y0 Z50\nG1 C90 F100000\n", "essid", known())), 0);
  const TurnedRun unknown = turned("TRAORI\nG0 X100 Y0 Z50\nG1 C90 F100000\n");
  EXPECT_EQ(swing_time(unknown), 0);
  EXPECT_EQ(unknown.summary.not_counted.tip_followings, 1U);
  EXPECT_TRUE(std::isnan(at(unknown, unknown.trajectory->duration() - 0.1).linear[0].position));
}

}  // namespace
}  // namespace feedscope

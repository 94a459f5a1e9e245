#include "core/analysis/rotary/rotary_figures.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

#include "core/analysis/rotary/turn_law.h"
#include "tests/core/analysis/turned_runs.h"

namespace feedscope {
namespace {

using test::at;
using test::run_of;
using test::turned;
using test::TurnedRun;

constexpr double deg = units::pi / 180;

/// The closed form of a turn from rest to rest: its largest values are not those of instants beside them.
TEST(RotaryPeaks, OfAnIndexingTurnAreThoseOfItsLaw) {
  const TurnedRun run = turned("G0 C90\n");
  const RotaryAxis& c = *run.setup.machine.kinematics.find('C');
  const RestToRestPlace law = rest_to_rest_peaks(90 * deg, c.velocity, c.acceleration, c.jerk);
  const AxisPeaks& peaks = run.summary.rotary->rotary[2];
  EXPECT_NEAR(peaks.velocity, law.velocity, 1e-9);
  EXPECT_NEAR(peaks.acceleration, law.acceleration, 1e-9);
  EXPECT_NEAR(peaks.jerk, c.jerk, 1e-9);
  EXPECT_FALSE(run.summary.rotary->linear);
}

/// The largest magnitudes of a rotary axis at evenly spaced instants.
AxisPeaks seen_of(const TurnedRun& run, std::size_t axis) {
  constexpr int looks = 40'000;
  AxisPeaks seen;
  for (int i = 0; i <= looks; ++i) {
    const AxisState motion = at(run, run.trajectory->duration() * i / looks).rotary[axis];
    seen.add(motion.velocity, motion.acceleration, motion.jerk);
  }
  return seen;
}

/// But for the rounding of an instant.
constexpr double nearly = 1 - 1e-6;

/// Of the axes of the machine, which go up and down with the angles, in one block that the feed limits.
TEST(RotaryPeaks, AreThoseOfEveryTurnOfALongBlock) {
  for (const char* model : {"essid", "ward"}) {
    const TurnedRun run =
        turned("TRAORI\nG0 X60 Y0 Z5\nG1 F300 X-60 C3000\n", model,
               {"tool_length_mm=100", "part_zero_x_mm=150", "part_zero_y_mm=-120", "part_zero_z_mm=-300"});
    constexpr int looks = 40'000;
    AxisPeaks seen;
    for (int i = 0; i <= looks; ++i) {
      const AxisState x = at(run, run.trajectory->duration() * i / looks).linear[0];
      seen.add(x.velocity, x.acceleration, x.jerk);
    }
    ASSERT_TRUE(run.summary.rotary->linear);
    const AxisPeaks& peaks = (*run.summary.rotary->linear)[0];
    SCOPED_TRACE(model);
    EXPECT_GE(peaks.velocity, seen.velocity * nearly);
    EXPECT_LE(peaks.velocity, seen.velocity * 1.001);
    EXPECT_GE(peaks.acceleration, seen.acceleration * nearly);
    EXPECT_LE(peaks.acceleration, seen.acceleration * 1.001);
  }
}

/// Blocks of unequal length, whose joints reach over a part of the longer ones alone: jerk jumps there,
/// within a piece of the motion.
TEST(RotaryPeaks, AreWhatTheInstantsOfAShortProgramShow) {
  for (const char* model : {"essid", "msaddek", "cam"}) {
    const TurnedRun run = turned(
        "TRAORI\nG1 F6000 X20 C60 A5\nX40 C70 A5\nX43 C55 A8\nX80 C30 A2\nX82 C31 A2\nX90 C60\nX100 C60\n",
        model, {"orientation_tolerance_deg=0.2"});
    for (const std::size_t axis : {0U, 2U}) {
      const AxisPeaks seen = seen_of(run, axis);
      const AxisPeaks& peaks = run.summary.rotary->rotary[axis];
      SCOPED_TRACE(fmt::format("{} {}", model, axis == 0 ? 'A' : 'C'));
      EXPECT_GE(peaks.velocity, seen.velocity * nearly);
      EXPECT_LE(peaks.velocity, seen.velocity * 1.001);
      EXPECT_GE(peaks.acceleration, seen.acceleration * nearly);
      EXPECT_LE(peaks.acceleration, seen.acceleration * 1.01);
      if (std::isfinite(peaks.jerk)) {
        EXPECT_GE(peaks.jerk, seen.jerk * nearly);
        EXPECT_LE(peaks.jerk, seen.jerk * 1.01) << "just before or behind a jump";
      }
    }
  }
}

class RotaryPeaksOf : public testing::TestWithParam<unsigned> {};

TEST_P(RotaryPeaksOf, RandomProgramsAreNotBelowAnyInstant) {
  for (const char* model : {"essid", "msaddek", "cam", "gassara"}) {
    const TurnedRun run = turned(test::random_turns(GetParam()), model, {"orientation_tolerance_deg=0.2"});
    for (const std::size_t axis : {0U, 2U}) {
      const AxisPeaks seen = seen_of(run, axis);
      const AxisPeaks& peaks = run.summary.rotary->rotary[axis];
      SCOPED_TRACE(fmt::format("{} {}", model, axis == 0 ? 'A' : 'C'));
      EXPECT_GE(peaks.velocity, seen.velocity * nearly);
      EXPECT_GE(peaks.acceleration, seen.acceleration * nearly);
      if (std::isfinite(peaks.jerk)) {
        EXPECT_GE(peaks.jerk, seen.jerk * nearly);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RotaryPeaksOf, testing::Values(1, 2, 3, 4, 5));

/// Of the ramps on lines and on blends, whose axes hold the tip where the tool nears the vertical axis.
TEST(RotaryPeaks, OfTheBladeAreWithinTheLimitsButForTheShareOfJoints) {
  for (const char* model : {"essid", "gassara", "msaddek", "tapie"}) {
    const TurnedRun run =
        run_of("sinumerik_blade.mpf",
               {"tool_length_mm=150", "part_zero_x_mm=0", "part_zero_y_mm=0", "part_zero_z_mm=-300"}, model);
    for (const RotaryAxis& axis : run.setup.machine.kinematics.rotary) {
      const AxisPeaks& peaks = run.summary.rotary->rotary[rotary_names.find(axis.name)];
      EXPECT_LE(peaks.velocity, 1.001 * axis.velocity) << model << ' ' << axis.name;
      EXPECT_LE(peaks.acceleration, 1.8 * axis.acceleration) << model << ' ' << axis.name;
    }
    for (std::size_t i = 0; i < known_axes.size(); ++i) {
      const AxisLimits& limits = *run.setup.machine.axes.find(known_axes[i].name);
      EXPECT_LE((*run.summary.rotary->linear)[i].acceleration, 1.8 * limits.acceleration) << model;
    }
  }
}

}  // namespace
}  // namespace feedscope

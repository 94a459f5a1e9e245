#include "core/analysis/rotary_course.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "core/analysis/envelope/envelope.h"
#include "core/analysis/explanation/explanation.h"
#include "core/analysis/explanation/remedies.h"
#include "core/analysis/run.h"
#include "core/base/units.h"
#include "tests/support/folders.h"

namespace feedscope {
namespace {

constexpr double deg = units::pi / 180;
using TurnedRun = feedscope::Run;  // in tests Run is a member of testing::Test

TurnedRun turned(const std::string& text, const std::string& model = "essid",
                 const std::vector<std::string>& assignments = {}) {
  SetupRequest request;
  request.machine = "five-axis-table-ac";
  request.model = model;
  request.assignments = assignments;
  Setup setup = make_setup(request);
  ReadOptions options;
  options.dialect = Dialect::sinumerik;
  options.unit = LengthUnit::mm;
  const auto source = std::make_shared<const SourceText>("test.mpf", text);
  return simulate_run(load_program(source, nullptr, reading_on(options, setup.machine)), setup);
}

RotarySample at(const TurnedRun& run, double time) {
  return run.sources.rotary->at(run.trajectory->state(time));
}

TEST(RotaryCourse, IsThereOnlyWhereAnAxisTurns) {
  EXPECT_EQ(turned("G0 X10\nG1 X20 F1000\n").sources.rotary, nullptr);
  EXPECT_NE(turned("G0 X10\nG0 A20\nG1 X20 F1000\n").sources.rotary, nullptr);
}

/// C turns 90 degrees at the limits of the machine: half of it after half of its time, fastest there.
TEST(RotaryCourse, IndexesFromRestToRest) {
  const TurnedRun run = turned("G0 C90\n");
  const RotaryAxis& c = *run.setup.machine.kinematics.find('C');
  const double end = turning_time(c, 90 * deg);
  ASSERT_NEAR(run.trajectory->duration(), end, 1e-9);
  EXPECT_NEAR(at(run, end / 2).angle[2], 45 * deg, 1e-9);
  EXPECT_NEAR(at(run, end).angle[2], 90 * deg, 1e-9);
  EXPECT_NEAR(at(run, 0.01).angle[2], c.jerk * 1e-6 / 6, 1e-12);
  EXPECT_NEAR(at(run, end / 2).velocity[2], run.summary.rotary_velocity->at(2), 1e-9);
  EXPECT_TRUE(std::isnan(at(run, 0).angle[1]));  // the machine has no B
  EXPECT_EQ(at(run, end / 2).angle[0], 0);
}

/// 60 degrees along 20 mm at 10 mm/s: 30 degrees a second in the middle.
TEST(RotaryCourse, GoesLinearlyAlongAFeedBlock) {
  const TurnedRun run = turned("G1 X20 C60 F600\n", "cam");
  const double middle = run.trajectory->duration() / 2;
  EXPECT_NEAR(at(run, middle).angle[2], 30 * deg, 1e-9);
  EXPECT_NEAR(at(run, middle).velocity[2], 30 * deg, 1e-9);
}

/// Steps of the angles' velocities against their accelerations: 0.75 of the limit beside a joint, and what a
/// ramp adds.
TEST(RotaryCourse, ChangesItsVelocityWithinTheLimitsWhereBlocksMeet) {
  for (const double tolerance : {0.01, 0.05, 0.5}) {
    const TurnedRun run = turned("TRAORI\nG1 F6000 X20 C60 A5\nX40 A5\nX60 C0 A20\nX80 C30\nX100\n", "essid",
                                 {fmt::format("orientation_tolerance_deg={}", tolerance)});
    ASSERT_GE(run.input.toolpath->turn_joints.size(), 3U);
    const double step = 1e-4;
    for (const char name : {'A', 'C'}) {
      const RotaryAxis& axis = *run.setup.machine.kinematics.find(name);
      const auto i = static_cast<std::size_t>(name - 'A');
      double largest = 0;
      for (double time = 0; time + step < run.trajectory->duration(); time += step) {
        largest =
            std::max(largest, std::abs(at(run, time + step).velocity[i] - at(run, time).velocity[i]) / step);
      }
      EXPECT_LE(largest, 1.75 * axis.acceleration) << name << " at " << tolerance;
      EXPECT_GT(largest, 0.1 * axis.acceleration) << name << " at " << tolerance;
    }
  }
}

TEST(RotaryCourse, LeavesTheProgrammedAnglesByTheOrientationTolerance) {
  const std::string text = "TRAORI\nG1 F6000 X20 C60\nX40\n";
  const TurnedRun run = turned(text, "cam", {"orientation_tolerance_deg=0.2"});
  double farthest = 0;
  for (int i = 0; i <= 20000; ++i) {
    const State state = run.trajectory->state(run.trajectory->duration() * i / 20000);
    const double programmed = std::min(60.0, 3 * state.position.x()) * deg;
    farthest = std::max(farthest, std::abs(run.sources.rotary->at(state).angle[2] - programmed));
  }
  EXPECT_NEAR(farthest, 0.2 * deg, 1e-3 * deg);
}

TEST(RotaryCourse, TakesTheLongerTheTighterTheOrientationTolerance) {
  double before = 0;
  for (const double tolerance : {0.5, 0.1, 0.02, 0.004}) {
    const double time = turned("TRAORI\nG1 F12000 X20 C60\nX40\nX60 C0\nX80\n", "essid",
                               {fmt::format("orientation_tolerance_deg={}", tolerance)})
                            .trajectory->duration();
    EXPECT_GT(time, before) << tolerance;
    before = time;
  }
}

/// The tip runs round the axis of C at 50 mm, the tool leaning by 30 degrees outwards: X, Y and Z hold it by
/// what the table does not. Against differences of the machine's places, worked out from path and angles.
TEST(MachineAxes, HaveTheVelocityThatHoldsTheTipOnItsPath) {
  std::string text = "TRAORI\nG0 X50 Y0 Z0 A3=0.5 B3=0 C3=0.866\nG1 F6000\n";
  for (int i = 1; i <= 120; ++i) {
    const double turn = 3 * i * deg;
    text += fmt::format("X{:.4f} Y{:.4f} A3={:.6f} B3={:.6f} C3=0.866\n", 50 * std::cos(turn),
                        50 * std::sin(turn), 0.5 * std::cos(turn), 0.5 * std::sin(turn));
  }
  const TurnedRun run = turned(
      text, "essid", {"tool_length_mm=150", "part_zero_x_mm=30", "part_zero_y_mm=0", "part_zero_z_mm=-320"});
  ASSERT_TRUE(run.summary.machine_velocity);
  const KinematicChain chain = chain_of(run.setup.machine.kinematics);
  const auto places = [&](double time) {
    const State state = run.trajectory->state(time);
    const RotarySample sample = run.sources.rotary->at(state);
    std::vector<double> angles;
    for (const std::size_t k : chain.rotary()) {
      angles.push_back(sample.angle[rotary_names.find(chain.axes()[k].name)]);
    }
    return chain.places(state.position + Vec3(30, 0, -320), angles, 150);
  };
  double largest = 0;
  for (int i = 100; i < 1900; ++i) {
    const double time = run.trajectory->duration() * i / 2000;
    const State state = run.trajectory->state(time);
    const SegmentTurn* turn = run.input.toolpath->segment_turn(run.trajectory->path().segment(state.element));
    if (turn == nullptr || !turn->at_tip) {
      continue;
    }
    const auto velocity = run.sources.rotary->linear_velocity(state, run.sources.rotary->at(state));
    const double h = 1e-5;
    const std::vector<double> before = places(time - h);
    const std::vector<double> behind = places(time + h);
    for (const std::size_t k : chain.linear()) {
      const auto axis = static_cast<std::size_t>(chain.axes()[k].name - 'X');
      ASSERT_NEAR(velocity[axis], (behind[k] - before[k]) / (2 * h), 0.5) << time << ' ' << axis;
      largest = std::max(largest, std::abs(velocity[axis]));
    }
  }
  EXPECT_GT(largest, 1);
  EXPECT_LE(largest, 1.001 * std::max({(*run.summary.machine_velocity)[0], (*run.summary.machine_velocity)[1],
                                       (*run.summary.machine_velocity)[2]}));
}

/// Trials begin with the program, not with what another machine has made of it.
TEST(RotaryTrials, WorkOutTheTurnsAnew) {
  const TurnedRun run = turned("TRAORI\nG1 F500 C90\nG1 F6000 X20 C150\nX40\nX60 C0\n");
  const auto time_with = [&](const Remedy& remedy) {
    return try_remedy(run.input, run.setup, remedy, nullptr).duration();
  };
  const double now = run.trajectory->duration();
  EXPECT_NEAR(time_with(Remedy()), now, 1e-9);
  EXPECT_LT(time_with(Remedy{{{"C.jerk", 80.0}}}), now - 0.01);
  EXPECT_LT(time_with(Remedy{{{"orientation_tolerance_deg", 0.5}}}), now - 0.01);
  Remedy faster;
  faster.feed_factor = 1.2;
  const double alone = 90 / (500.0 / 60);  // C by itself at 500 degrees a minute
  EXPECT_LT(time_with(faster), now - 0.9 * alone * (1 - 1 / 1.2));
}

/// A shipped program on the machine with a table that tilts.
TurnedRun run_of(const char* file, const std::vector<std::string>& assignments = {}) {
  SetupRequest request;
  request.machine = "five-axis-table-ac";
  request.assignments = assignments;
  const feedscope::Setup setup = make_setup(request);
  const std::string path = std::string(FEEDSCOPE_SOURCE_DIR "/resources/programs/") + file;
  return simulate_run(load_program(path, nullptr, reading_on({}, setup.machine)), setup);
}

/// The program of lesson 17 that is posted at a tilt, and the other one in a part clamped at that tilt.
TEST(RotaryCourse, OfAPartThatIsTurnedIsThatOfTheProgramPostedAtTheTilt) {
  const double turned_part = run_of("lesson_singular.nc", {"part_angle_x_deg=-10"}).trajectory->duration();
  const double posted = run_of("lesson_singular_tilted.nc").trajectory->duration();
  const double plain = run_of("lesson_singular.nc").trajectory->duration();
  EXPECT_NEAR(turned_part, posted, 0.02 * posted) << "but for the turn to the first place";
  EXPECT_LT(turned_part, 0.8 * plain);
}

TEST(RotaryCourse, GivesTheToolItsDirectionInThePart) {
  const TurnedRun run = turned("G0 A30\nG0 C90\nG1 X1 F1000\n");
  const double a = turning_time(*run.setup.machine.kinematics.find('A'), 30 * deg);
  const auto direction = [&](double time) {
    return run.sources.rotary->tool_direction(run.trajectory->state(time));
  };
  EXPECT_LT((direction(0) - Vec3::UnitZ()).norm(), 1e-12);
  // A turns the tool counter-clockwise about X against the part: towards -Y.
  EXPECT_LT((direction(a) - Vec3(0, -0.5, std::sqrt(0.75))).norm(), 1e-9);
  // Then C by 90 degrees about Z: -Y becomes +X.
  const double end = run.trajectory->duration();
  EXPECT_LT((direction(end) - Vec3(0.5, 0, std::sqrt(0.75))).norm(), 1e-9);
}

std::string random_turns(unsigned seed) {
  std::mt19937 random(seed);
  const auto any = [&](double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(random);
  };
  std::string text = "G17 G90 F3000\nTRAORI\n";
  for (int i = 0; i < 60; ++i) {
    const double which = any(0, 1);
    if (which < 0.1) {
      text += fmt::format("G0 A{:.3f} C{:.3f}\n", any(-60, 45), any(-170, 170));
    } else if (which < 0.2) {
      text += fmt::format("G0 X{:.3f} Y{:.3f} C{:.3f}\n", any(-50, 50), any(-50, 50), any(-90, 90));
    } else if (which < 0.3) {
      text += fmt::format("G1 X{:.3f} Y{:.3f}\n", any(-50, 50), any(-50, 50));
    } else {
      text += fmt::format("G1 X{:.3f} Y{:.3f} Z{:.3f} A{:.3f} C{:.3f}\n", any(-50, 50), any(-50, 50),
                          any(-10, 10), any(-60, 45), any(-170, 170));
    }
  }
  return text;
}

class RotaryCourses : public testing::TestWithParam<const char*> {};

/// Positions do not jump, and velocities are their slopes.
TEST_P(RotaryCourses, AreContinuousOnRandomPrograms) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    const TurnedRun run = turned(random_turns(seed), GetParam());
    const double duration = run.trajectory->duration();
    const int steps = 4000;
    const double h = duration / steps;
    double fastest = 0;
    for (int i = 0; i < steps; ++i) {
      const RotarySample from = at(run, i * h);
      const RotarySample to = at(run, (i + 1) * h);
      const RotarySample middle = at(run, (i + 0.5) * h);
      for (const std::size_t axis : {std::size_t{0}, std::size_t{2}}) {
        const double largest = (*run.summary.rotary_velocity)[axis];
        ASSERT_LE(std::abs(to.angle[axis] - from.angle[axis]), 1.02 * largest * h + 1e-6)
            << GetParam() << " seed " << seed << " at " << i * h << " s";
        const RotarySample near = at(run, (i + 0.5) * h + 1e-6);
        const double slope = (near.angle[axis] - middle.angle[axis]) / 1e-6;
        fastest = std::max(fastest, std::abs(middle.velocity[axis]));
        if (std::abs(near.velocity[axis] - middle.velocity[axis]) <
            0.01 * largest) {  // no block ends between
          ASSERT_NEAR(slope, middle.velocity[axis], 0.02 * largest)
              << GetParam() << " seed " << seed << " at " << i * h << " s";
        }
      }
    }
    EXPECT_GT(fastest, 0.5);
  }
}

INSTANTIATE_TEST_SUITE_P(Models, RotaryCourses,
                         testing::Values("cam", "essid", "gassara", "tapie", "msaddek", "ward"));

TEST(RotaryColumn, EnvelopeHoldsWhatEveryInstantHas) {
  const TurnedRun run = turned(random_turns(4));
  const Envelope envelope(run.trajectory, run.sources);
  ASSERT_TRUE(envelope.has(QuantitySource::rotary));
  std::vector<double> times;
  for (int i = 0; i <= 40; ++i) {
    times.push_back(run.trajectory->duration() * i / 40);
  }
  const std::vector<Band> bands = envelope.columns(times);
  for (std::size_t i = 0; i < bands.size(); ++i) {
    for (int k = 0; k <= 50; ++k) {
      const RotarySample sample = at(run, times[i] + (times[i + 1] - times[i]) * k / 50);
      const Extent& position = bands[i][QuantityId::position_c];
      EXPECT_GE(sample.angle[2], double{position.min} - 0.02);
      EXPECT_LE(sample.angle[2], double{position.max} + 0.02);
    }
    EXPECT_TRUE(bands[i][QuantityId::velocity_b].empty());
  }
}

/// The machine's C makes 50 turns a minute, 300 degrees a second; 60 degrees a millimetre leave 5 mm/s.
TEST(RotaryReason, IsTheVelocityOfTheAxisOverItsTurnByThePath) {
  const TurnedRun run = turned("TRAORI\nG1 X10 A5 F6000\nG1 X30 C1200\nG1 X60\n");
  double found = 0;
  for (int i = 0; i < 2000; ++i) {
    const State state = run.trajectory->state(run.trajectory->duration() * i / 2000);
    if (state.cause != Cause{CauseKind::axis_velocity, 5}) {
      continue;
    }
    const Reason reason = explain(run, state).reason;
    ASSERT_EQ(reason.formula.id, FormulaId::turning_velocity);
    EXPECT_EQ(reason.formula.text(), "W_C / |q'_C|");
    EXPECT_NEAR(reason.formula.value(), 5, 1e-9);
    EXPECT_TRUE(reason.sets_it());
    ASSERT_TRUE(reason.tilt);
    EXPECT_NEAR(*reason.tilt, 5 * deg, 1e-9);
    found += 1;
  }
  EXPECT_GT(found, 100);
  ASSERT_EQ(run.input.toolpath->singular_places.size(), 1U);
  const SingularPlace& place = run.input.toolpath->singular_places.front();
  EXPECT_EQ(place.line, 3U);
  EXPECT_EQ(place.axis, 'C');
  EXPECT_NEAR(place.speed, 5, 1e-9);
  EXPECT_NEAR(place.tilt, 5 * deg, 1e-9);
}

}  // namespace
}  // namespace feedscope

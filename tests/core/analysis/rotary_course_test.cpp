#include "core/analysis/rotary/rotary_course.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <string>

#include "core/analysis/envelope/envelope.h"
#include "core/analysis/explanation/explanation.h"
#include "core/analysis/explanation/remedies.h"
#include "core/analysis/notes/remarks.h"
#include "core/analysis/run/run.h"
#include "core/base/error.h"
#include "core/base/units.h"
#include "tests/core/analysis/turned_runs.h"
#include "tests/support/english.h"

namespace feedscope {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr double deg = units::pi / 180;
using test::at;
using test::random_turns;
using test::run_of;
using test::turned;
using test::TurnedRun;

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
  EXPECT_NEAR(at(run, end / 2).rotary[2].position, 45 * deg, 1e-9);
  EXPECT_NEAR(at(run, end).rotary[2].position, 90 * deg, 1e-9);
  EXPECT_NEAR(at(run, 0.01).rotary[2].position, c.jerk * 1e-6 / 6, 1e-12);
  EXPECT_NEAR(at(run, end / 2).rotary[2].velocity, run.summary.rotary->rotary[2].velocity, 1e-9);
  EXPECT_TRUE(std::isnan(at(run, 0).rotary[1].position));  // the machine has no B
  EXPECT_EQ(at(run, end / 2).rotary[0].position, 0);
}

/// 60 degrees along 20 mm at 10 mm/s: 30 degrees a second in the middle.
TEST(RotaryCourse, GoesLinearlyAlongAFeedBlock) {
  const TurnedRun run = turned("G1 X20 C60 F600\n", "cam");
  const double middle = run.trajectory->duration() / 2;
  EXPECT_NEAR(at(run, middle).rotary[2].position, 30 * deg, 1e-9);
  EXPECT_NEAR(at(run, middle).rotary[2].velocity, 30 * deg, 1e-9);
}

/// Steps of the angles' velocities against their accelerations: 0.75 of the limit beside a joint, and what a
/// ramp adds.
TEST(RotaryCourse, ChangesItsVelocityWithinTheLimitsWhereBlocksMeet) {
  for (const double tolerance : {0.01, 0.05, 0.5}) {
    const TurnedRun run = turned("TRAORI\nG1 F6000 X20 C60 A5\nX40 A5\nX60 C0 A20\nX80 C30\nX100\n", "essid",
                                 {fmt::format("orientation_tolerance_deg={}", tolerance)});
    ASSERT_GE(run.path->turn_joints.size(), 3U);
    const double step = 1e-4;
    for (const char name : {'A', 'C'}) {
      const RotaryAxis& axis = *run.setup.machine.kinematics.find(name);
      const auto i = static_cast<std::size_t>(name - 'A');
      double largest = 0;
      for (double time = 0; time + step < run.trajectory->duration(); time += step) {
        largest = std::max(
            largest,
            std::abs(at(run, time + step).rotary[i].velocity - at(run, time).rotary[i].velocity) / step);
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
    farthest = std::max(farthest, std::abs(run.sources.rotary->at(state).rotary[2].position - programmed));
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
  ASSERT_TRUE(run.summary.rotary->linear);
  const KinematicChain chain = chain_of(run.setup.machine.kinematics);
  const auto places = [&](double time) {
    const State state = run.trajectory->state(time);
    const RotarySample sample = run.sources.rotary->at(state);
    std::vector<double> angles;
    for (const std::size_t k : chain.rotary()) {
      angles.push_back(sample.rotary[rotary_names.find(chain.axes()[k].name)].position);
    }
    return chain.places(state.position + Vec3(30, 0, -320), angles, 150);
  };
  double largest = 0;
  for (int i = 100; i < 1900; ++i) {
    const double time = run.trajectory->duration() * i / 2000;
    const State state = run.trajectory->state(time);
    const SegmentTurn* turn = run.path->segment_turn(run.trajectory->path().segment(state.element));
    if (turn == nullptr || !turn->at_tip) {
      continue;
    }
    const std::array<AxisState, 3> linear = run.sources.rotary->at(state).linear;
    const double h = 1e-5;
    const std::vector<double> before = places(time - h);
    const std::vector<double> behind = places(time + h);
    for (const std::size_t k : chain.linear()) {
      const auto axis = static_cast<std::size_t>(chain.axes()[k].name - 'X');
      ASSERT_NEAR(linear[axis].position, (before[k] + behind[k]) / 2, 1e-3) << time << ' ' << axis;
      ASSERT_NEAR(linear[axis].velocity, (behind[k] - before[k]) / (2 * h), 0.5) << time << ' ' << axis;
      largest = std::max(largest, std::abs(linear[axis].velocity));
    }
  }
  EXPECT_GT(largest, 1);
  const std::array<AxisPeaks, 3>& peaks = *run.summary.rotary->linear;
  EXPECT_LE(largest, 1.001 * std::max({peaks[0].velocity, peaks[1].velocity, peaks[2].velocity}));
}

/// Every derivative of an axis against the difference of the one below, where no block ends within it. On
/// lines, arcs and joints, at changing speed.
TEST(MachineAxes, HaveTheDerivativesOfTheirPlaces) {
  const TurnedRun run =
      turned("TRAORI\nG1 F6000 X20 C60 A5\nX40 A5\nG3 X60 Y20 I0 J20 C0 A20\nG1 Y60 C30\nX100\n", "essid",
             {"tool_length_mm=150", "part_zero_x_mm=30", "part_zero_y_mm=0", "part_zero_z_mm=-320"});
  const double h = 1e-6;
  int compared = 0;
  const auto compare = [&](const AxisState& before, const AxisState& now, const AxisState& behind,
                           double time) {
    const auto near = [&](double value, double low, double high, double change, const char* what) {
      if (std::abs(change) < 1e-3 * (1 + std::abs(value))) {  // no step within
        ++compared;
        ASSERT_NEAR(value, (high - low) / (2 * h), 2e-3 * (1 + std::abs(value))) << what << " at " << time;
      }
    };
    near(now.velocity, before.position, behind.position, behind.velocity - before.velocity, "velocity");
    near(now.acceleration, before.velocity, behind.velocity, behind.acceleration - before.acceleration,
         "acceleration");
    near(now.jerk, before.acceleration, behind.acceleration, behind.jerk - before.jerk, "jerk");
  };
  for (double time = 1e-3; time < run.trajectory->duration() - 1e-3; time += 1.37e-3) {
    const RotarySample before = at(run, time - h);
    const RotarySample middle = at(run, time);
    const RotarySample behind = at(run, time + h);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (axis != 1) {  // the machine has no B
        compare(before.rotary[axis], middle.rotary[axis], behind.rotary[axis], time);
      }
      compare(before.linear[axis], middle.linear[axis], behind.linear[axis], time);
    }
  }
  EXPECT_GT(compared, 1000);
}

/// On the step of the slope of an axis at right angles to the tool, the lean is the rounding of its angle; on
/// that of C, the share by which the tool leans from the axis.
TEST(OrientationErrors, AreWhatTheRoundingOfAnglesTurnsTheTool) {
  const auto lean = [](const char* text) {
    return turned(text, "cam", {"orientation_tolerance_deg=0.2"}).summary.rotary->orientation;
  };
  const OrientationError of_a = lean("TRAORI\nG1 F6000 X20 A10\nX40\n");
  EXPECT_NEAR(of_a.angle, 0.2 * deg, 1e-6);
  EXPECT_EQ(of_a.line, 2U);
  EXPECT_NEAR(lean("TRAORI\nG0 A-30\nG1 F6000 X20 C60\nX40\n").angle, 0.1 * deg, 1e-5);
  EXPECT_EQ(lean("TRAORI\nG1 F6000 X20 C60\nX40\n").line, 0U) << "the tool lies along C";
  EXPECT_EQ(lean("G0 C60\nG1 X10 F1000\n").angle, 0);
}

/// OTOL and CYCLE832 of the program go before the setting, unless it says that they do not.
TEST(OrientationTolerances, OfTheProgramGoBeforeTheSetting) {
  const auto lean = [](const std::string& text, const char* program = "on") {
    return turned(text, "essid",
                  {"orientation_tolerance_deg=0.2", fmt::format("program_tolerance={}", program)})
               .summary.rotary->orientation.angle /
           deg;
  };
  const std::string path = "TRAORI\nG1 F6000 X20 A10\nX40\n";
  EXPECT_NEAR(lean(path), 0.2, 1e-5);
  EXPECT_NEAR(lean("OTOL=0.5\n" + path), 0.5, 1e-5);
  EXPECT_NEAR(lean("OTOL=0.5\n" + path, "off"), 0.2, 1e-5);
  EXPECT_NEAR(lean("OTOL=0.5\nOTOL=-1\n" + path), 0.2, 1e-5);
  EXPECT_NEAR(lean("CYCLE832(0.01,11,0.8)\n" + path), 0.8, 1e-5);
  EXPECT_LT(lean("OTOL=0\n" + path), 1.001e-4) << "as tight as can be, and no stop";
  EXPECT_NEAR(lean("OTOL=0.5\nTRAORI\nG1 F6000 X20 A10\nOTOL=0.1\nX40\n"), 0.1, 1e-5) << "the tighter one";
}

TEST(RotaryNotes, SayWhichModelAndWhichMachineLeaveThemOut) {
  const auto notes_of = [](const char* machine, const char* model) {
    SetupRequest request;
    request.machine = machine;
    request.model = model;
    const feedscope::Setup setup = make_setup(request);
    ReadOptions options;
    options.dialect = Dialect::sinumerik;
    options.unit = LengthUnit::mm;
    const auto source =
        std::make_shared<const SourceText>("test.mpf", "TRAORI\nG1 F6000 X20 C60 A5\nX40 A5\n");
    const LoadedProgram program = load_program(source, nullptr, reading_on(options, setup.machine));
    std::string all;
    for (const Remark& remark : remarks(simulate_run(program, setup))) {
      all += remark.text.english() + '\n';
    }
    return all;
  };
  EXPECT_THAT(notes_of("spinner-mvc850", "essid"),
              HasSubstr("turns rotary axes, which this machine does not"));
  EXPECT_THAT(notes_of("five-axis-table-ac", "essid"), Not(HasSubstr("in full")));
  EXPECT_THAT(notes_of("five-axis-table-ac", "essid"), Not(HasSubstr("does not have")));
  EXPECT_THAT(notes_of("five-axis-table-ac", "essid"), HasSubstr("jerk of axes may be above"));
  for (const char* model : {"cam", "optimal", "ward", "linuxcnc"}) {
    EXPECT_THAT(notes_of("five-axis-table-ac", model), HasSubstr("limits of rotary axes in full")) << model;
  }
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
  const Remedy faster{{{"feed_override_percent", 120.0}}};
  const double alone = 90 / (500.0 / 60);  // C by itself at 500 degrees a minute
  EXPECT_LT(time_with(faster), now - 0.9 * alone * (1 - 1 / 1.2));
}

/// A part that is turned stands square to the tool before its program turns the axes: they do not jump there.
TEST(RotaryCourse, BeginsWhereAPartThatIsTurnedNeedsTheAxes) {
  const TurnedRun run = run_of("lesson_singular.nc", {"part_angle_x_deg=30"});
  const double duration = run.trajectory->duration();
  std::array<double, 3> before = run.sources.rotary->at(run.trajectory->state(0)).angles();
  EXPECT_NEAR(std::abs(before[0]), 30 * deg, 1e-9);
  constexpr int looks = 20'000;
  const double step = duration / looks;
  const RotaryAxis& a = *run.setup.machine.kinematics.find('A');
  const RotaryAxis& c = *run.setup.machine.kinematics.find('C');
  for (int i = 1; i <= looks; ++i) {
    const std::array<double, 3> angles = run.sources.rotary->at(run.trajectory->state(step * i)).angles();
    ASSERT_LE(std::abs(angles[0] - before[0]), 1.001 * a.velocity * step) << step * i;
    ASSERT_LE(std::abs(angles[2] - before[2]), 1.001 * c.velocity * step) << step * i;
    before = angles;
  }
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
        const double largest = run.summary.rotary->rotary[axis].velocity;
        ASSERT_LE(std::abs(to.rotary[axis].position - from.rotary[axis].position), 1.02 * largest * h + 1e-6)
            << GetParam() << " seed " << seed << " at " << i * h << " s";
        const RotarySample near = at(run, (i + 0.5) * h + 1e-6);
        const double slope = (near.rotary[axis].position - middle.rotary[axis].position) / 1e-6;
        fastest = std::max(fastest, std::abs(middle.rotary[axis].velocity));
        if (std::abs(near.rotary[axis].velocity - middle.rotary[axis].velocity) <
            0.01 * largest) {  // no block ends between
          ASSERT_NEAR(slope, middle.rotary[axis].velocity, 0.02 * largest)
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
      EXPECT_GE(sample.rotary[2].position, double{position.min} - 0.02);
      EXPECT_LE(sample.rotary[2].position, double{position.max} + 0.02);
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
  const auto note = std::ranges::find(run.path.faults, "rotary-feed", &Diagnostic::code);
  ASSERT_NE(note, run.path.faults.end());
  EXPECT_EQ(note->line, 3U);
  EXPECT_THAT(note->message.english(), testing::StartsWith("axis C holds the feed at 300 of "));
  EXPECT_THAT(note->message.english(), testing::EndsWith("the tool is 5 degrees from its axis"));
  EXPECT_THAT(note->hint.english(), testing::HasSubstr("one of 1 such places"));
}

/// The blade has short blocks, corners and joints, and every limit of every axis holds somewhere.
TEST(RotaryReason, IsFoundForEveryRampOfTheBlade) {
  constexpr int instants = 400;
  for (const char* model : {"essid", "msaddek", "tapie"}) {
    SCOPED_TRACE(model);
    const TurnedRun run = run_of("sinumerik_blade.mpf", {}, model);
    for (int i = 0; i < instants; ++i) {
      const State state = run.trajectory->state(run.trajectory->duration() * i / instants);
      const bool of_axis = state.cause.axis >= 0 && (state.cause.kind == CauseKind::axis_acceleration ||
                                                     state.cause.kind == CauseKind::axis_jerk);
      if (of_axis) {
        EXPECT_TRUE(explain(run, state).reason.sets_it()) << state.time;
      }
    }
  }
}

/// Whatever settings a model has.
TEST(RotaryReason, IsLookedForInRunsOfEveryModel) {
  for (const ControlModel* model : all_models()) {
    SCOPED_TRACE(model->info().id);
    try {
      const TurnedRun run =
          turned("TRAORI\nG1 X10 A5 F6000\nG1 X30 C1200\nG1 X60 A20 C0\n", model->info().id);
      for (int i = 0; i < 200; ++i) {
        EXPECT_NO_THROW(explain(run, run.trajectory->state(run.trajectory->duration() * i / 200)));
      }
    } catch (const InputError& refused) {
      EXPECT_THAT(refused.what(), HasSubstr("rotary")) << "of a model that knows none";
    }
  }
}

/// C turns evenly by 30 degrees a millimetre: its jerk is that along the path times this, and its
/// acceleration likewise, of which turning takes nothing.
TEST(RotaryReason, OnARampIsWhatTurningLeavesOfTheLimitOfTheAxis) {
  const TurnedRun run =
      turned("TRAORI\nG1 X10 A5 F60000\nG1 X50 C1200\nG1 X90\n", "essid", {"C.velocity=1000"});
  std::map<FormulaId, int> found;
  int asked = 0;
  for (int i = 0; i < 4000; ++i) {
    const State state = run.trajectory->state(run.trajectory->duration() * i / 4000);
    const bool ramps =
        state.cause.kind == CauseKind::axis_acceleration || state.cause.kind == CauseKind::axis_jerk;
    if (!ramps || state.cause.axis < 3) {
      continue;
    }
    ++asked;
    const Reason reason = explain(run, state).reason;
    if (reason.sets_it()) {
      ++found[reason.formula.id];
      const RotaryAxis& axis = *run.setup.machine.kinematics.find("ABC"[state.cause.axis - 3]);
      const bool by_jerk = reason.formula.id == FormulaId::turning_ramp_jerk;
      EXPECT_EQ(reason.formula.numbers[1].value, by_jerk ? axis.jerk : axis.acceleration);
    }
  }
  EXPECT_GT(asked, 20);
  EXPECT_GT(found[FormulaId::turning_ramp_jerk], asked / 4);
}

}  // namespace
}  // namespace feedscope

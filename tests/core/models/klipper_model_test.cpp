#include "core/models/klipper/klipper_model.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/analysis/explanation/explanation.h"
#include "core/analysis/run/run.h"
#include "core/program/controls/klipper_settings.h"
#include "tests/support/paths.h"

namespace feedscope {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr double acceleration = 1000;  // [mm/s2]

/// 100 mm/s and 1000 mm/s2 along the path, square corner velocity 5 mm/s, no cruise ratio.
Machine machine() {
  Machine made;
  made.id = made.name = made.control = made.reference = "klipper";
  for (const char axis : coordinate_names) {
    for (const char* limit : {"velocity", "acceleration", "jerk", "blend_jerk"}) {
      set_axis_limit(made, axis, limit, 500);
    }
  }
  made.settings.set("max_velocity_m_min", 6.0);
  made.settings.set("max_acceleration_m_s2", acceleration / 1000);
  made.settings.set("minimum_cruise_ratio", 0.0);
  return made;
}

Trajectory run(const Toolpath& path, const Machine& on = machine()) {
  const ControlModel& klipper = find_model("klipper");
  return klipper.simulate(path, on, complete_settings(klipper, on));
}

ControlReading reading(const std::string& text) {
  const LoadedProgram loaded = load_program(std::make_shared<const SourceText>(SourceText("test.nc", text)));
  const ControlModel& klipper = find_model("klipper");
  return klipper.read(loaded.toolpath, complete_settings(klipper, machine()));
}

TEST(KlipperModel, ALineIsATrapezoid) {
  const Trajectory line = run(testing::polyline({{0, 0, 0}, {40, 0, 0}}, 50));
  EXPECT_NEAR(line.duration(), 40.0 / 50 + 50 / acceleration, 1e-12);
  EXPECT_EQ(line.state(0.01).cause.kind, CauseKind::path_acceleration);
  EXPECT_EQ(line.state(0.4).cause.kind, CauseKind::programmed_feed);
  EXPECT_EQ(run(testing::polyline({{0, 0, 0}, {400, 0, 0}}, 500)).state(2).cause.kind,
            CauseKind::path_velocity);
}

/// What the square corner velocity is called by: the speed at 90 degrees.
TEST(KlipperModel, PassesASquareCornerAtTheSquareCornerVelocity) {
  const Trajectory corner = run(testing::polyline({{0, 0, 0}, {40, 0, 0}, {40, 40, 0}}, 50));
  EXPECT_NEAR(corner.state_at_path(40).speed, 5, 1e-9);
  EXPECT_EQ(corner.state_at_path(39.99).slower_place.kind, CauseKind::square_corner_velocity);
}

TEST(KlipperModel, LimitsZAlongThePath) {
  Machine slow_z = machine();
  slow_z.settings.set("max_z_velocity_m_min", 0.6);  // 10 mm/s
  slow_z.settings.set("max_z_acceleration_m_s2", 0.1);
  const Trajectory down = run(testing::polyline({{0, 0, 0}, {30, 0, 40}}, 500), slow_z);
  const double speed = 10 / 0.8;
  EXPECT_NEAR(down.duration(), 50 / speed + speed / (100 / 0.8), 1e-9);
  EXPECT_EQ(down.state(2).cause, (Cause{CauseKind::axis_velocity, 2}));
  EXPECT_EQ(down.state(0.01).cause, (Cause{CauseKind::axis_acceleration, 2}));
}

/// From rest to rest with half of the way left for constant speed: v^2 = A L / 2 instead of A L.
TEST(KlipperModel, KeepsAPartOfTheWayForConstantSpeed) {
  Machine cruising = machine();
  cruising.settings.set("minimum_cruise_ratio", 0.5);
  const Trajectory line = run(testing::polyline({{0, 0, 0}, {4, 0, 0}}, 90), cruising);
  const State middle = line.state(line.duration() / 2);
  EXPECT_NEAR(middle.speed, std::sqrt(acceleration * 4 / 2), 1e-9);
  EXPECT_EQ(middle.cause.kind, CauseKind::cruise_ratio);
}

double duration_of(const std::string& text, const Machine& on) {
  const ControlModel& klipper = find_model("klipper");
  const Settings settings = complete_settings(klipper, on);
  const LoadedProgram loaded =
      load_program(std::make_shared<const SourceText>(SourceText("test.gcode", text)));
  return klipper.simulate(loaded.toolpath, on, settings).duration();
}

/// A move of the extruder alone is a trapezoid from rest to rest between two stops, as long as a G4 of it.
TEST(KlipperModel, RunsTheExtruderAloneWithinItsLimits) {
  Machine extruder = machine();
  extruder.settings.set("max_extrude_velocity_mm_s", 20.0);
  extruder.settings.set("max_extrude_acceleration_m_s2", 1.0);
  const auto expect = [&](const std::string& moves, double seconds) {
    SCOPED_TRACE(moves);
    const auto between = [](const std::string& middle) {
      return "G21\nG90\nG1 X10 F3000\n" + middle + "\nG1 X20 F3000\n";
    };
    EXPECT_NEAR(duration_of(between(moves), extruder), duration_of(between("G4 P0"), extruder) + seconds,
                1e-9);
  };
  expect("G1 E-2 F600", 2 / 10.0 + 10 / 1000.0);
  expect("G1 E2 F1800", 2 / 20.0 + 20 / 1000.0);
  expect("G1 E0.1 F1800", 2 * std::sqrt(0.1 / 1000));
  expect("G0 X10 E-2 F600", 2 / 10.0 + 10 / 1000.0);
  expect("M83\nG1 E2 F600\nG1 E2", 2 * (2 / 10.0 + 10 / 1000.0));
  expect("G1 E2 F600\nG1 E2", 2 / 10.0 + 10 / 1000.0);
  expect("G1 E2 F600\nG92 E0\nG1 E2", 2 * (2 / 10.0 + 10 / 1000.0));
  expect("G92 E7\nG1 E5 F600", 2 / 10.0 + 10 / 1000.0);
  extruder.settings.set("minimum_cruise_ratio", 0.9);
  expect("G1 E2 F1800", 2 / std::sqrt(2 * 100.0) + std::sqrt(2 * 100.0) / 1000);
  expect("M204 S500\nG1 E2 F1800\nM204 S1000", 2 / 10.0 + 10 / 1000.0);
}

/// Klipper, kinematics/extruder.py: 4 d^2 over the section of the filament.
TEST(KlipperModel, TakesTheLimitsOfTheUsualNozzleForTheExtruder) {
  const Machine usual = machine();
  const KlipperSettings limits(usual, complete_settings(find_model("klipper"), usual));
  EXPECT_NEAR(limits.max_extrude_velocity, 100 * 0.266081, 1e-4);
  EXPECT_NEAR(limits.max_extrude_acceleration, acceleration * 0.266081, 1e-3);
}

TEST(KlipperModel, RunsChordsOfTheResolution) {
  Toolpath path = testing::polyline({{0, 0, 0}, {10, 0, 0}}, 20);
  testing::append_arc(path, Vec3(10, 10, 0), 1.05, 20);  // 10.5 mm long, resolution 1 mm
  const Trajectory arc = run(path);
  ASSERT_EQ(arc.path().size(), 11U);
  EXPECT_NEAR(arc.path().element(1).length, 2 * 10 * std::sin(0.0525), 1e-9);
  EXPECT_NEAR((arc.path().element(5).end - Vec3(10, 10, 0)).norm(), 10, 1e-9);
}

TEST(KlipperReading, RunsNoLineWithoutItsCommand) {
  const ControlReading read = reading(
      "G21 G90\n"
      "G0 X10\n"
      "X20 Y5\n"
      "(G1 X30)\n"
      "G01 X40\n"
      "M3 S1000\n"
      "N7 G1 X50 F600\n"
      "G2 X60 R5\n"
      "G1 X70 F0\n");
  std::vector<std::uint32_t> lines;
  for (const Diagnostic& note : read.refused) {
    EXPECT_EQ(note.code, "refused");
    lines.push_back(note.line);
  }
  EXPECT_THAT(lines, ElementsAre(3, 4, 5, 6, 8, 9));
  EXPECT_THAT(read.refused[0].message.english(), HasSubstr("unknown command X20"));
  ASSERT_EQ(read.path->segments.size(), 2U);
  EXPECT_DOUBLE_EQ(read.path->segments[0].feed, 25);  // a rapid runs at the feed in force
  EXPECT_FALSE(read.path->segments[0].rapid);
  EXPECT_DOUBLE_EQ(read.path->segments[1].feed, 10);
}

/// A run of the program as Klipper reads it.
Trajectory run_text(const std::string& text) {
  return run(*reading(text).path);
}

TEST(KlipperLimits, ChangeTheMovesBehindThem) {
  const Trajectory line = run_text(
      "G1 X40 F3000\n"
      "M400\n"
      "M204 S500\n"
      "G1 X80\n"
      "M400\n"
      "set_velocity_limit VELOCITY=20 ACCEL=2000\n"
      "G1 X120\n");
  const double first = 40.0 / 50 + 50 / acceleration;
  const double second = 40.0 / 50 + 50.0 / 500;
  EXPECT_NEAR(line.duration(), first + second + 40.0 / 20 + 20.0 / 2000, 1e-9);
  EXPECT_EQ(line.state(first + second + 1).cause.kind, CauseKind::path_velocity);
}

TEST(KlipperLimits, TheLesserOfPrintAndTravelIsTaken) {
  const Trajectory line = run_text("M204 P800 T500\nG1 X40 F3000\n");
  EXPECT_NEAR(line.duration(), 40.0 / 50 + 50.0 / 500, 1e-9);
}

TEST(KlipperLimits, TheCornerHasThoseOfBothMoves) {
  const Trajectory corner =
      run_text("G1 X40 F3000\nSET_VELOCITY_LIMIT SQUARE_CORNER_VELOCITY=8\nG1 Y40\nG1 X0\n");
  EXPECT_NEAR(corner.state_at_path(40).speed, 5, 1e-9);  // the move before keeps its own
  EXPECT_NEAR(corner.state_at_path(80).speed, 8, 1e-9);
}

TEST(KlipperLimits, TheCruiseRatioComesByEitherWord) {
  const double top = std::sqrt(acceleration * 4 / 2);
  for (const char* word : {"MINIMUM_CRUISE_RATIO=0.5", "ACCEL_TO_DECEL=500"}) {
    const Trajectory line = run_text(std::string("SET_VELOCITY_LIMIT ") + word + "\nG1 X4 F5400\n");
    EXPECT_NEAR(line.state(line.duration() / 2).speed, top, 1e-9) << word;
  }
}

TEST(KlipperLimits, HoldForProgramsThatRunAsTheyAreMeant) {
  const std::string text = "M204 S500\nG1 X40 F3000\n";
  const LoadedProgram loaded = load_program(std::make_shared<const SourceText>(SourceText("test.nc", text)));
  EXPECT_NEAR(run(*loaded.toolpath).duration(), 40.0 / 50 + 50.0 / 500, 1e-9);
}

TEST(KlipperLimits, RejectsLinesWithoutSense) {
  const ControlReading read = reading(
      "M204\n"
      "M204 P500\n"
      "M204 S0\n"
      "SET_VELOCITY_LIMIT MINIMUM_CRUISE_RATIO=1\n"
      "SET_VELOCITY_LIMIT ACCEL=fast\n"
      "SET_VELOCITY_LIMIT VELOCITY=100\n"
      "G1 X1 F600\n");
  std::vector<std::uint32_t> lines;
  for (const Diagnostic& note : read.refused) {
    lines.push_back(note.line);
  }
  EXPECT_THAT(lines, ElementsAre(1, 2, 3, 4, 5));
  EXPECT_THAT(read.refused[1].message.english(), HasSubstr("M204 needs S, or P and T"));
  EXPECT_THAT(read.refused[4].message.english(), HasSubstr("invalid value of ACCEL"));
}

/// *Why here?* names the limits in force at the place, not those of the machine.
TEST(KlipperLimits, ExplainWithWhatIsInForce) {
  const std::string text = "G1 X40 F3000\nM204 S500\nSET_VELOCITY_LIMIT VELOCITY=20\nG1 X80\nM400\nG1 X120\n";
  const LoadedProgram loaded = load_program(std::make_shared<const SourceText>(SourceText("test.nc", text)));
  const feedscope::Run done = simulate_run(loaded, make_setup({.machine = "klipper-corexy",
                                                               .model = "klipper",
                                                               .tolerance = {},
                                                               .assignments = {"max_acceleration_m_s2=1"}}));
  const State at = done.trajectory->state_at_path(100);
  ASSERT_EQ(at.cause.kind, CauseKind::path_velocity);
  EXPECT_NEAR(explain(done, at).reason.formula.value(), 20, 1e-9);
}

TEST(KlipperReading, WaitsInMilliseconds) {
  const ControlReading read = reading("G1 X10 F600\nG4 P250\nG1 X20\n");
  ASSERT_EQ(read.path->segments.size(), 3U);
  EXPECT_DOUBLE_EQ(read.path->dwell_of(read.path->segments[1]), 0.25);
}

/// By the direction from the centre the end is where the arc starts: clockwise -2 pi, of which 6 chords of
/// 1 mm with the last one to the end; anticlockwise 0, the way to the end.
TEST(KlipperReading, AnArcWhoseEndIsOffItsCircleIsChordsAndAWayToTheEnd) {
  for (const double end : {9.0, 10.6}) {
    const std::string words = " X" + std::to_string(end) + " Y0 I1 J0\n";
    const auto clockwise = reading("G1 X10 F600\nG2" + words).path->segments;
    ASSERT_EQ(clockwise.size(), 7U) << end;
    for (std::size_t i = 1; i < 6; ++i) {
      EXPECT_NEAR(clockwise[i].length, 1, 1e-9) << end;
      EXPECT_EQ(clockwise[i].line, 2U);
    }
    EXPECT_DOUBLE_EQ(clockwise[6].end.x(), end);
    const auto anticlockwise = reading("G1 X10 F600\nG3" + words).path->segments;
    ASSERT_EQ(anticlockwise.size(), 2U) << end;
    EXPECT_NEAR(anticlockwise[1].length, std::abs(end - 10), 1e-9);
  }
}

/// No direction leads from the centre to itself; atan2() of Klipper's two zeros is pi.
TEST(KlipperReading, AnArcToItsOwnCentreHasALength) {
  for (const char* command : {"G2", "G3"}) {
    const Toolpath path = *reading(std::string("G1 X10 F600\n") + command + " X11 Y0 I1 J0\n").path;
    ASSERT_EQ(path.segments.size(), 4U);
    EXPECT_NEAR(path.length(), 10 + 3, 1e-9) << "chords of 60 degrees, and from the circle to its centre";
    EXPECT_GT(run(path).duration(), 0);
  }
}

TEST(KlipperReading, MovesOriginAndSpeed) {
  const ControlReading read = reading("G1 X10 F600\nG92 X0\nM220 S200\nG1 X5\nG91\nG1 X1 F600\n");
  ASSERT_EQ(read.path->segments.size(), 3U);
  EXPECT_DOUBLE_EQ(read.path->segments[1].end.x(), 15);
  EXPECT_DOUBLE_EQ(read.path->segments[1].feed, 20);
  EXPECT_DOUBLE_EQ(read.path->segments[2].end.x(), 16);
}

}  // namespace
}  // namespace feedscope

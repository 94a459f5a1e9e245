#include "core/models/grbl/grbl_model.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/analysis/run/run.h"
#include "tests/support/paths.h"

namespace feedscope {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr double acceleration = 400;  // [mm/s2]

/// All axes alike: 100 mm/s, 400 mm/s2; no steps, so that nothing is rounded but to 32 bits.
Machine machine() {
  Machine made;
  made.id = made.name = made.control = made.reference = "grbl";
  for (const char axis : coordinate_names) {
    set_axis_limit(made, axis, "velocity", 6);
    set_axis_limit(made, axis, "acceleration", acceleration / 1000);
    set_axis_limit(made, axis, "jerk", 100);
    set_axis_limit(made, axis, "blend_jerk", 100);
  }
  return made;
}

Trajectory run(const Toolpath& path, const Machine& on = machine()) {
  const ControlModel& grbl = find_model("grbl");
  return grbl.simulate(path, on, complete_settings(grbl, on));
}

LoadedProgram program(const std::string& text) {
  return load_program(std::make_shared<const SourceText>(SourceText("test.nc", text)));
}

ControlReading reading(const std::string& text) {
  const ControlModel& grbl = find_model("grbl");
  return grbl.read(program(text).toolpath, complete_settings(grbl, machine()));
}

std::vector<std::uint32_t> lines_of(const std::vector<Diagnostic>& notes) {
  std::vector<std::uint32_t> lines;
  for (const Diagnostic& note : notes) {
    EXPECT_EQ(note.code, "refused");
    EXPECT_EQ(note.severity, Severity::info);
    lines.push_back(note.line);
  }
  return lines;
}

/// Up, at F and down again: L/F + F/A.
TEST(GrblModel, ALineIsATrapezoid) {
  const Trajectory line = run(testing::polyline({{0, 0, 0}, {40, 0, 0}}, 50));
  EXPECT_NEAR(line.duration(), 40.0 / 50 + 50 / acceleration, 1e-6);
  EXPECT_NEAR(line.state(0.05).speed, 0.05 * acceleration, 1e-4);
  EXPECT_EQ(line.state(0.05).cause, (Cause{CauseKind::axis_acceleration, 0}));
  EXPECT_EQ(line.state(0.5).cause.kind, CauseKind::programmed_feed);
  const State braking = line.state(line.duration() - 0.05);
  EXPECT_EQ(braking.cause.kind, CauseKind::ramp_down);
  EXPECT_EQ(braking.slower_place.kind, CauseKind::exact_stop);
}

/// v^2 = A d s / (1 - s) / |j_X| with s = sin(45 deg); the corner bisector moves both axes by 1/sqrt(2).
TEST(GrblModel, PassesACornerAtTheSpeedOfTheJunctionDeviation) {
  const Trajectory corner = run(testing::polyline({{0, 0, 0}, {40, 0, 0}, {40, 40, 0}}, 50));
  const double s = std::sqrt(0.5);
  const double speed = std::sqrt(acceleration * std::sqrt(2) * 0.01 * s / (1 - s));
  const State there = corner.state_at_path(40);
  EXPECT_NEAR(there.speed, speed, 1e-4);
  const State before = corner.state_at_path(39.9);
  EXPECT_EQ(before.cause.kind, CauseKind::ramp_down);
  EXPECT_EQ(before.slower_place.kind, CauseKind::junction_deviation);
}

TEST(GrblModel, StopsWhereThePathTurnsBack) {
  const Trajectory back = run(testing::polyline({{0, 0, 0}, {40, 0, 0}, {10, 0, 0}}, 50));
  EXPECT_NEAR(back.state_at_path(40).speed, 0, 1e-3);
}

/// 14 blocks behind the running one are known: a speed from which they are enough to stop, and little more.
TEST(GrblModel, ShortBlocksAreAsFastAsTheBufferAllows) {
  constexpr double length = 0.05;
  std::vector<Vec3> points;
  for (int i = 0; i <= 2000; ++i) {
    points.emplace_back(length * i, 0, 0);
  }
  const auto level = [&](double blocks) {
    Machine buffered = machine();
    buffered.settings.set("buffer_blocks", blocks);
    return run(testing::polyline(points, 100), buffered).state_at_path(50).speed;
  };
  for (const double blocks : {15.0, 60.0}) {
    EXPECT_GE(level(blocks), std::sqrt(2 * acceleration * (blocks - 1) * length) * 0.9);
    EXPECT_LE(level(blocks), std::sqrt(2 * acceleration * (blocks + 1) * length) * 1.01);
  }
  const State there = run(testing::polyline(points, 100)).state_at_path(50);
  EXPECT_TRUE(there.cause.kind == CauseKind::axis_acceleration ||
              there.slower_place.kind == CauseKind::lookahead_horizon);
}

/// 2 sqrt(2 R d) long at most, on the arc with both ends.
TEST(GrblModel, RunsChordsOfArcs) {
  Toolpath path = testing::polyline({{0, 0, 0}, {10, 0, 0}}, 20);
  testing::append_arc(path, Vec3(10, 30, 0), 2, 20);
  const Trajectory arc = run(path);
  const BlendedPath& laid = arc.path();
  const double longest = 2 * std::sqrt(0.002 * (2 * 30 - 0.002));
  for (std::size_t i = 1; i < laid.size(); ++i) {
    EXPECT_EQ(laid.kind(i), ElementKind::line);
    EXPECT_EQ(laid.segment(i), 1U);
    const PathElement chord = laid.element(i);
    EXPECT_LE(chord.length, longest * 1.1);
    EXPECT_NEAR((chord.end - Vec3(10, 30, 0)).norm(), 30, 1e-4);
  }
  EXPECT_EQ(laid.size() - 1, static_cast<std::size_t>(std::floor(60 / longest)));
}

TEST(GrblModel, RoundsEndsToStepsAndSkipsWhatIsShorter) {
  Machine stepped = machine();
  for (const char axis : coordinate_names) {
    set_axis_value(stepped, axis, "steps_per_mm", 10.0);
  }
  const Trajectory line =
      run(testing::polyline({{0, 0, 0}, {1.04, 0, 0}, {1.03, 0.02, 0}, {5, 0, 0}}, 20), stepped);
  ASSERT_EQ(line.path().size(), 2U);
  EXPECT_NEAR(line.path().element(0).end.x(), 1.0, 1e-12);
}

TEST(GrblReading, DoesNotRunWhatItRejects) {
  const ControlReading read = reading(
      "%\n"
      "G21 G90 F600\n"
      "G1 X10\n"
      "G43 H1 Z5\n"
      "G1 X20 F1200 G64\n"
      "X30\n"
      "G2 I5\n"
      "T1 M6\n");
  EXPECT_THAT(lines_of(read.refused), ElementsAre(1, 4, 5, 7, 8));
  EXPECT_THAT(read.refused[1].message.english(), HasSubstr("error 20: H"));
  ASSERT_EQ(read.path->segments.size(), 2U);
  EXPECT_EQ(read.path->segments[1].line, 6U);
  EXPECT_DOUBLE_EQ(read.path->segments[1].feed, 10);  // the feed of a rejected line is lost
}

/// Numbers of 32 bits are up to 0.25 um from the programmed ones at 4 m: the program counts.
TEST(GrblReading, EndsLinesWhereTheProgramDoes) {
  const std::string text = "G1 X4286.467420 Y-7988.858316 F1000\nG4 P1\nX4961.585148\nG2 X4971.585148 I5\n";
  const Toolpath written = *program(text).toolpath;
  const Toolpath read = *reading(text).path;
  ASSERT_EQ(read.segments.size(), 4U);
  EXPECT_EQ(read.segments[0].end, written.segments[0].end);
  EXPECT_EQ(read.segments[1].end, written.segments[0].end) << "the dwell is there";
  EXPECT_EQ(read.segments[0].length, read.segments[0].end.norm());
  EXPECT_EQ(read.segments[2].end.x(), 4961.585148F) << "an arc begins there";
}

TEST(GrblReading, WaitsForTheEndOfMotionWhereSomethingIsSwitched) {
  const ControlReading read =
      reading("G1 X1 F60\nM3 S1000\nX2\nM3\nX3\nS2000\nX4\nM8\nM8\nX5\nG54\nX6\nG55\nX7\nM2\n");
  std::vector<std::uint32_t> waits;
  for (const Segment& segment : read.path->segments) {
    if (segment.kind == SegmentKind::dwell) {
      waits.push_back(segment.line);
    }
  }
  EXPECT_THAT(waits, ElementsAre(2, 6, 8, 13, 15));
}

/// Held for $1 at each stop but the last.
TEST(GrblModel, HoldsTheMotorsAtEveryStopButTheLast) {
  const Machine on = machine();
  const ControlModel& grbl = find_model("grbl");
  const auto time = [&](const std::string& text) {
    return grbl.simulate(program(text).toolpath, on, complete_settings(grbl, on)).duration();
  };
  const double half = time("G1 X20 F3000\nM2\n");
  EXPECT_NEAR(time("G1 X20 F3000\nM3 S1\nX40\nM2\n"), 2 * half + 0.025, 1e-6);
  EXPECT_NEAR(time("G1 X20 F3000\nG4 P0.12\nX40\n"), 2 * half + 0.025 + 0.15, 1e-6);
}

TEST(GrblReading, RunsLinesAsTheyAreMeantIfAsked) {
  const ControlModel& grbl = find_model("grbl");
  Machine lenient = machine();
  lenient.settings.set("refuse", "off");
  const LoadedProgram loaded = program("G1 X10 F600\nG43 H1 X20\n");
  const ControlReading read = grbl.read(loaded.toolpath, complete_settings(grbl, lenient));
  EXPECT_TRUE(read.refused.empty());
  EXPECT_EQ(read.path, loaded.toolpath);
}

}  // namespace
}  // namespace feedscope

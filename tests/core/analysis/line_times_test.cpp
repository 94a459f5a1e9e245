#include "core/analysis/time/line_times.h"

#include <gtest/gtest.h>

#include <random>

#include "core/base/error.h"
#include "core/models/control_model.h"
#include "tests/core/analysis/hand_made_run.h"
#include "tests/support/parts.h"
#include "tests/support/paths.h"

namespace feedscope {
namespace {

using testing::line_to;

const Vec3 axis_speed(500, 250, 100);

/// Lines 2, 4, 2 and 2 of 10, 20, 10 and 5 mm at 10 mm/s, then 3 s of waiting in line 7.
Trajectory loop_and_dwell() {
  Toolpath toolpath;
  toolpath.segments = {line_to(Vec3(10, 0, 0), 10, 10, 2), line_to(Vec3(30, 0, 0), 20, 10, 4),
                       line_to(Vec3(40, 0, 0), 10, 10, 2), line_to(Vec3(45, 0, 0), 5, 10, 2)};
  testing::append_dwell(toolpath, 3);
  toolpath.segments.back().line = 7;
  return testing::trajectory_of(
      toolpath, {{{0, 0, 10, 0, 0, 0, {}}, 4.5}, {{0, 0, 0, 0, 0, 4, {CauseKind::dwell}}, 3}}, axis_speed);
}

TEST(LineTimes, AddsUpWhatALineCostsInAllItsRuns) {
  const LineTimes times(loop_and_dwell());
  EXPECT_NEAR(times.of(2).time, 2.5, 1e-12);
  EXPECT_NEAR(times.of(2).length, 25, 1e-12);
  EXPECT_EQ(times.of(2).runs, 2U);  // the last two blocks follow each other
  EXPECT_NEAR(times.of(4).time, 2, 1e-12);
  EXPECT_EQ(times.of(4).runs, 1U);
  EXPECT_NEAR(times.largest(), 3, 1e-12);
  EXPECT_EQ(times.line_count(), 7U);
}

TEST(LineTimes, OfALineThatDoesNotRunIsZero) {
  const LineTimes times(loop_and_dwell());
  for (const std::uint32_t line : {0U, 1U, 3U, 6U, 8U, 4'000'000'000U}) {
    EXPECT_EQ(times.of(line).time, 0) << line;
    EXPECT_EQ(times.of(line).runs, 0U) << line;
    EXPECT_EQ(times.of(line).mean_feed(), 0) << line;
  }
}

TEST(LineTimes, KnowsWhereALineOrTheNextThatRunsBegins) {
  const LineTimes times(loop_and_dwell());
  const std::vector<std::uint32_t> first{0, 0, 0, 1, 1, 4, 4, 4};
  for (std::uint32_t line = 0; line < first.size(); ++line) {
    EXPECT_EQ(times.first_element(line), first[line]) << line;
  }
  EXPECT_EQ(times.first_element(8), std::nullopt);
  EXPECT_EQ(LineTimes().first_element(1), std::nullopt);
}

TEST(LineTimes, LeavesDwellsOutOfTheMeanFeed) {
  const LineTimes times(loop_and_dwell());
  EXPECT_NEAR(times.of(7).dwell, 3, 1e-12);
  EXPECT_EQ(times.of(7).mean_feed(), 0);
  EXPECT_NEAR(times.of(1, 7).mean_feed(), 10, 1e-12);
}

TEST(LineTimes, OfSeveralLinesIsTheirSum) {
  const LineTimes times(loop_and_dwell());
  EXPECT_NEAR(times.of(2, 4).time, 4.5, 1e-12);
  EXPECT_NEAR(times.of(3, 1000).time, 5, 1e-12);
  EXPECT_EQ(times.of(1, 7).runs, 4U);
  EXPECT_EQ(times.of(5, 4).time, 0);
}

TEST(LineTimes, OfNothingIsEmpty) {
  const LineTimes times{Trajectory()};
  EXPECT_EQ(times.line_count(), 0U);
  EXPECT_EQ(times.total(), 0);
  EXPECT_EQ(times.of(1).time, 0);
}

TEST(LineTimes, StopsWhenCancelled) {
  Progress progress;
  progress.cancel();
  EXPECT_THROW(LineTimes(loop_and_dwell(), &progress), Cancelled);
}

/// A line's time is that of the instants at which the run is on it.
TEST(LineTimes, AgreeWithTheMotionOfEveryModel) {
  std::mt19937 random(11);
  for (const ControlModel* model : all_models()) {
    Toolpath path = testing::random_path(random, 60);
    std::uniform_int_distribution<std::uint32_t> line(1, 20);  // as loops and subprograms do
    for (Segment& segment : path.segments) {
      segment.line = line(random);
    }
    const Trajectory run = model->simulate(path, testing::spinner(), testing::spinner_settings(*model));
    const LineTimes times(run);
    std::vector<double> expected(21);
    double length = 0;
    for (const Part& part : testing::parts_of(run)) {
      expected[run.state(part.time + part.duration / 2).line] += part.duration;
    }
    for (std::uint32_t i = 1; i <= 20; ++i) {
      EXPECT_NEAR(times.of(i).time, expected[i], 1e-9 * run.duration()) << model->info().id << " line " << i;
      length += times.of(i).length;
    }
    EXPECT_NEAR(times.total(), run.duration(), 1e-9 * run.duration()) << model->info().id;
    EXPECT_NEAR(length, run.path_length(), 1e-9 * run.path_length()) << model->info().id;
  }
}

TEST(LineTimes, KnowsWhatOfALineIsNotCounted) {
  Toolpath toolpath;
  toolpath.segments = {line_to(Vec3(10, 0, 0), 10, 10, 2)};
  const auto add_pause = [&](Pause kind, bool timed, std::uint32_t line) {
    testing::append_dwell(toolpath, 0);
    toolpath.pauses.back().kind = kind;
    toolpath.pauses.back().timed = timed;
    toolpath.segments.back().line = line;
  };
  add_pause(Pause::machine_move, false, 9);
  add_pause(Pause::tool_change, false, 4);
  add_pause(Pause::spindle_start, false, 4);
  add_pause(Pause::tool_change, false, 4);
  add_pause(Pause::tool_change, true, 5);
  const LineTimes times(testing::trajectory_of(toolpath, {{{0, 0, 10, 0, 0, 0, {}}, 1}}, axis_speed));
  EXPECT_EQ(times.not_counted(4), (std::vector{Pause::tool_change, Pause::spindle_start}));
  EXPECT_EQ(times.not_counted(9), std::vector{Pause::machine_move});
  for (const std::uint32_t line : {0U, 2U, 5U, 10U}) {
    EXPECT_TRUE(times.not_counted(line).empty()) << line;
  }
}

}  // namespace
}  // namespace feedscope

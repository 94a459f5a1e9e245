#include "core/analysis/run/summary.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

#include "tests/core/analysis/hand_made_run.h"
#include "tests/support/paths.h"

namespace feedscope {
namespace {

const Vec3 rapid_speed(500, 250, 100);

using testing::line_to;
using testing::Passage;

Trajectory trajectory_of(const Toolpath& toolpath, const std::vector<Passage>& runs) {
  return testing::trajectory_of(toolpath, runs, rapid_speed);
}

Toolpath one_line(const Vec3& end) {
  Toolpath toolpath;
  toolpath.segments = {line_to(end, end.norm(), 50)};
  return toolpath;
}

/// Rest to rest along (3, 4, 0) / 5 by four phases of constant jerk J, each of time h: the ramp of MODELS
/// section 1 up and down. Peak speed J h^2, peak acceleration J h, length 2 J h^3.
Trajectory four_phases(double jerk, double h) {
  const double length = 2 * jerk * h * h * h;
  const Cause x{CauseKind::axis_jerk, 0};
  const Cause down{CauseKind::ramp_down, -1};
  const auto stop = static_cast<std::uint8_t>(cause_index({CauseKind::exact_stop}));
  const double v = jerk * h * h / 2;
  const double a = jerk * h;
  return trajectory_of(one_line(Vec3(0.6, 0.8, 0) * length),
                       {{{0, 0, 0, 0, jerk, 0, x}, h},
                        {{0, jerk * h * h * h / 6, v, a, -jerk, 0, x}, h},
                        {{0, length / 2, 2 * v, -a, -jerk, 0, down, Law::ramp, stop}, 2 * h}});
}

TEST(Summary, IsGivenUpWhenCancelled) {
  Progress progress;
  const Trajectory run = four_phases(8000, 0.05);
  EXPECT_NO_THROW(summarise(run, {}, rapid_speed, &progress));
  progress.cancel();
  EXPECT_THROW(summarise(run, {}, rapid_speed, &progress), Cancelled);
}

TEST(Summary, OfARestToRestMoveIsTheClosedForm) {
  const double jerk = 8000;
  const double h = 0.05;
  Toolpath toolpath;
  const double length = 2 * jerk * h * h * h;  // 2 mm
  toolpath.segments = {line_to(Vec3(0.6, 0.8, 0) * length, length, 50)};
  const Summary summary = summarise(four_phases(jerk, h), toolpath, rapid_speed);

  EXPECT_DOUBLE_EQ(summary.cycle_time, 0.2);
  EXPECT_DOUBLE_EQ(summary.programmed_time, length / 50);
  EXPECT_DOUBLE_EQ(summary.mean_feed, length / 0.2);
  EXPECT_EQ(summary.max_contour_error, 0);
  EXPECT_DOUBLE_EQ(summary.peak_feed, jerk * h * h);
  EXPECT_DOUBLE_EQ(summary.axes[0].velocity, 0.6 * jerk * h * h);
  EXPECT_DOUBLE_EQ(summary.axes[1].velocity, 0.8 * jerk * h * h);
  EXPECT_DOUBLE_EQ(summary.axes[1].acceleration, 0.8 * jerk * h);
  EXPECT_DOUBLE_EQ(summary.axes[0].jerk, 0.6 * jerk);
  EXPECT_EQ(summary.axes[2].velocity, 0);
  EXPECT_DOUBLE_EQ(summary.time_by_cause[cause_index({CauseKind::axis_jerk, 0})], 0.1);
  EXPECT_DOUBLE_EQ(summary.time_by_cause[cause_index({CauseKind::ramp_down, -1})], 0.1);
  EXPECT_DOUBLE_EQ(summary.time_by_slower_place[cause_index({CauseKind::exact_stop, -1})], 0.1);
}

TEST(Summary, FindsThePeakInsideAPiece) {
  // v = 10 + 40 t - 80 t^2 / 2 over 1 s: largest at t = 0.5, 20 mm/s; both ends are at 10 mm/s.
  const Summary summary =
      summarise(trajectory_of(one_line(Vec3(10 + 20 - 80.0 / 6, 0, 0)), {{{0, 0, 10, 40, -80, 0, {}}, 1}}),
                {}, rapid_speed);
  EXPECT_DOUBLE_EQ(summary.peak_feed, 20);
  EXPECT_DOUBLE_EQ(summary.axes[0].velocity, 20);
  EXPECT_DOUBLE_EQ(summary.axes[0].acceleration, 40);
}

TEST(Summary, FindsTheCentripetalPeaksOfACircle) {
  // Steady 50 mm/s on radius 10: acceleration v^2/r = 250, jerk v^3/r^2 = 1250 on each axis in turn.
  Toolpath toolpath;
  toolpath.start = Vec3(10, 0, 0);
  toolpath.arcs = {{Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), Vec3::Zero(), 10, 2 * std::numbers::pi}};
  Segment circle = line_to(toolpath.start, toolpath.arcs[0].length(), 50);
  circle.kind = SegmentKind::arc;
  circle.index = 0;
  toolpath.segments = {circle};
  const Summary summary =
      summarise(trajectory_of(toolpath, {{{0, 0, 50, 0, 0, 0, {}}, circle.length / 50}}), {}, rapid_speed);
  EXPECT_NEAR(summary.peak_feed, 50, 1e-12);
  for (const std::size_t axis : {0U, 1U}) {
    EXPECT_NEAR(summary.axes[axis].velocity, 50, 50 * 1e-4);
    EXPECT_NEAR(summary.axes[axis].acceleration, 250, 250 * 1e-4);
    EXPECT_NEAR(summary.axes[axis].jerk, 1250, 1250 * 1e-4);
  }
  EXPECT_EQ(summary.axes[2].acceleration, 0);
}

TEST(Summary, FindsPeaksOnABlendOfEitherLaw) {
  // With constant du/dt the peaks of a cubic are at its ends: |S''(0)| and |S'''|.
  Toolpath toolpath;
  toolpath.start = Vec3(-1, 0, 0);
  toolpath.segments = {line_to(Vec3::Zero(), 1, 50), line_to(Vec3(0, 1, 0), 1, 50)};
  const CubicBlend blend{Vec3(-1, 0, 0), Vec3::Zero(), Vec3(0, 1, 0), 2.5};
  const auto run = [&](Law law, double v, double duration) {
    TrajectoryBuilder builder(std::make_shared<const Toolpath>(toolpath), rapid_speed);
    builder.add_corner(ElementKind::blend, 0, 1, blend.length());
    builder.add_piece({0, 0, v, 0, 0, 0, {}, law}, duration);
    return summarise(builder.finish(), {}, rapid_speed);
  };
  const CurvePoint start = blend.at(0);
  const Summary by_parameter = run(Law::parameter, 4, 0.25);
  EXPECT_NEAR(by_parameter.axes[0].velocity, 4 * start.d1.x(), 1e-9);
  EXPECT_NEAR(by_parameter.axes[0].acceleration, 16 * std::abs(start.d2.x()), 1e-9);
  EXPECT_NEAR(by_parameter.axes[0].jerk, 64 * std::abs(start.d3.x()), 1e-9);

  const Summary by_length = run(Law::path_length, 3, blend.length() / 3);
  EXPECT_NEAR(by_length.peak_feed, 3, 1e-9);
  EXPECT_NEAR(by_length.axes[0].velocity, 3, 1e-9);
}

TEST(Summary, CountsRapidsAtTheAxesSpeedAndDwellsInTheProgrammedTime) {
  Toolpath toolpath;
  Segment rapid = line_to(Vec3(30, 40, 0), 50, 0);  // Y limits: 250 / 0.8 = 312.5 mm/s
  rapid.rapid = true;
  const Segment without_feed = line_to(Vec3(30, 40, 20), 20, 0);  // Z limits: 100 mm/s
  toolpath.segments = {rapid};
  testing::append_dwell(toolpath, 1.5);
  toolpath.segments.push_back(without_feed);
  toolpath.segments.push_back(line_to(Vec3(130, 40, 20), 100, 25));
  EXPECT_DOUBLE_EQ(summarise({}, toolpath, rapid_speed).programmed_time, 50 / 312.5 + 1.5 + 0.2 + 4);
}

TEST(Summary, TakesNoTimeForARapidToWhereTheToolIs) {
  Toolpath toolpath = one_line(Vec3(10, 0, 0));
  const double time = summarise({}, toolpath, rapid_speed).programmed_time;
  Segment rapid = line_to(Vec3(10, 0, 0), 0, 0);
  rapid.rapid = true;
  toolpath.segments.push_back(rapid);
  EXPECT_EQ(summarise({}, toolpath, rapid_speed).programmed_time, time);
}

TEST(Summary, TakesTheAxesSpeedAlongAnArcWithoutFeed) {
  // Equal axes V: speed V / max(|cos|, |sin|), so a quarter takes (r / V) times the integral of
  // max(|cos|, |sin|) over a quarter turn, sqrt(2).
  Toolpath toolpath;
  toolpath.start = Vec3(10, 0, 0);
  toolpath.arcs = {{Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), Vec3::Zero(), 10, std::numbers::pi / 2}};
  Segment arc = line_to(Vec3(0, 10, 0), toolpath.arcs[0].length(), 0);
  arc.kind = SegmentKind::arc;
  arc.index = 0;
  toolpath.segments = {arc};
  EXPECT_NEAR(summarise({}, toolpath, Vec3::Constant(100)).programmed_time, 0.1 * std::numbers::sqrt2, 1e-4);
}

TEST(Summary, LeavesDwellsOutOfTheMeanFeed) {
  Toolpath toolpath = one_line(Vec3(10, 0, 0));
  testing::append_dwell(toolpath, 3);
  const Summary summary = summarise(
      trajectory_of(toolpath, {{{0, 0, 5, 0, 0, 0, {}}, 2}, {{0, 0, 0, 0, 0, 1, {CauseKind::dwell}}, 3}}), {},
      rapid_speed);
  EXPECT_DOUBLE_EQ(summary.mean_feed, 5);
  EXPECT_DOUBLE_EQ(summary.time_by_cause[cause_index({CauseKind::dwell, -1})], 3);
}

TEST(Summary, TakesTheLargestOfTheBlends) {
  Toolpath toolpath;  // two right angles, where the distance of the corner is T (4 - alpha) sin(45) / 4
  toolpath.segments = {line_to(Vec3(4, 0, 0), 4, 50), line_to(Vec3(4, 4, 0), 4, 50),
                       line_to(Vec3(8, 4, 0), 4, 50)};
  TrajectoryBuilder builder(std::make_shared<const Toolpath>(toolpath), rapid_speed);
  builder.add_corner(ElementKind::blend, 0, 0.8, 1);
  builder.add_corner(ElementKind::blend, 1, 0.2, 0.3);
  const Summary summary = summarise(builder.finish(), {}, rapid_speed);
  EXPECT_NEAR(summary.max_corner_distance, 0.8 * 1.5 * std::sqrt(0.5) / 4, 1e-12);
  EXPECT_NEAR(summary.max_contour_error, 0.8 * 1.5 * 0.5 / 4, 1e-12);
}

TEST(Summary, OfNothingIsZero) {
  const Summary summary = summarise({}, {}, rapid_speed);
  EXPECT_EQ(summary.cycle_time, 0);
  EXPECT_EQ(summary.programmed_time, 0);
  EXPECT_EQ(summary.mean_feed, 0);
  EXPECT_EQ(summary.time_by_cause, std::vector<double>(all_causes().size(), 0));
}

TEST(Summary, TimesByCauseAddUpToTheCycleTime) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> magnitude(-9, 1);
  std::uniform_int_distribution<std::size_t> cause(0, all_causes().size() - 1);
  std::vector<Passage> runs;
  for (int i = 0; i < 200000; ++i) {
    runs.push_back({{0, 0, 0, 0, 0, 0, all_causes()[cause(random)]}, std::pow(10, magnitude(random))});
  }
  const Summary summary = summarise(trajectory_of(one_line(Vec3(1, 0, 0)), runs), {}, rapid_speed);
  const double sum = std::accumulate(summary.time_by_cause.begin(), summary.time_by_cause.end(), 0.0);
  EXPECT_NEAR(sum, summary.cycle_time, 1e-12 * summary.cycle_time);
}

}  // namespace
}  // namespace feedscope

#include "core/analysis/summary.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

namespace feedscope {
namespace {

const Vec3 rapid_speed(500, 250, 100);

Segment line_to(const Vec3& end, double length, double feed) {
  Segment segment;
  segment.end = end;
  segment.length = length;
  segment.feed = feed;
  return segment;
}

PathElement line_element(const Vec3& start, const Vec3& end, double s) {
  PathElement element;
  element.start = start;
  element.end = end;
  element.s = s;
  element.length = (end - start).norm();
  return element;
}

Trajectory trajectory_of(BlendedPath path, std::vector<Piece> pieces, double duration,
                         std::vector<BlendRecord> blends = {}) {
  const std::size_t n = path.elements.size();
  return Trajectory(std::move(path), std::move(pieces), duration, std::move(blends),
                    std::vector<std::uint32_t>(n, 1), std::vector<double>(n, 50),
                    std::vector<bool>(n, false));
}

/// Rest to rest along (3, 4, 0) / 5 by four phases of constant jerk J, each of time h: the ramp of MODELS
/// section 1 up and down. Peak speed J h^2, peak acceleration J h, length 2 J h^3.
Trajectory four_phases(double jerk, double h) {
  const double length = 2 * jerk * h * h * h;
  BlendedPath path;
  path.elements = {line_element(Vec3::Zero(), Vec3(0.6, 0.8, 0) * length, 0)};
  const Cause x{CauseKind::axis_jerk, 0};
  const Cause down{CauseKind::ramp_down, -1};
  const double v = jerk * h * h / 2;
  const double a = jerk * h;
  std::vector<Piece> pieces{{0, 0, 0, 0, jerk, 0, x, Law::path_length},
                            {h, jerk * h * h * h / 6, v, a, -jerk, 0, x, Law::path_length},
                            {2 * h, length / 2, 2 * v, 0, -jerk, 0, down, Law::path_length},
                            {3 * h, length - jerk * h * h * h / 6, v, -a, jerk, 0, down, Law::path_length}};
  return trajectory_of(std::move(path), std::move(pieces), 4 * h);
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
}

TEST(Summary, FindsThePeakInsideAPiece) {
  // v = 10 + 40 t - 80 t^2 / 2 over 1 s: largest at t = 0.5, 20 mm/s; both ends are at 10 mm/s.
  BlendedPath path;
  path.elements = {line_element(Vec3::Zero(), Vec3(10 + 20 - 80.0 / 6, 0, 0), 0)};
  const Summary summary = summarise(
      trajectory_of(std::move(path), {{0, 0, 10, 40, -80, 0, {}, Law::path_length}}, 1), {}, rapid_speed);
  EXPECT_DOUBLE_EQ(summary.peak_feed, 20);
  EXPECT_DOUBLE_EQ(summary.axes[0].velocity, 20);
  EXPECT_DOUBLE_EQ(summary.axes[0].acceleration, 40);
}

TEST(Summary, FindsTheCentripetalPeaksOfACircle) {
  // Steady 50 mm/s on radius 10: acceleration v^2/r = 250, jerk v^3/r^2 = 1250 on each axis in turn.
  BlendedPath path;
  path.arcs = {{Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), Vec3::Zero(), 10, 2 * std::numbers::pi}};
  PathElement circle = line_element(Vec3(10, 0, 0), Vec3(10, 0, 0), 0);
  circle.kind = ElementKind::arc;
  circle.length = path.arcs[0].length();
  path.elements = {circle};
  const double duration = circle.length / 50;
  const Summary summary = summarise(
      trajectory_of(std::move(path), {{0, 0, 50, 0, 0, 0, {}, Law::path_length}}, duration), {}, rapid_speed);
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
  BlendedPath path;
  path.blends = {{Vec3(-1, 0, 0), Vec3::Zero(), Vec3(0, 1, 0), 2.5}};
  PathElement blend = line_element(Vec3(-1, 0, 0), Vec3(0, 1, 0), 0);
  blend.kind = ElementKind::blend;
  blend.length = path.blends[0].length();
  path.elements = {blend};
  const CurvePoint start = path.blends[0].at(0);
  const Summary by_parameter =
      summarise(trajectory_of(path, {{0, 0, 4, 0, 0, 0, {}, Law::parameter}}, 0.25), {}, rapid_speed);
  EXPECT_NEAR(by_parameter.axes[0].velocity, 4 * start.d1.x(), 1e-9);
  EXPECT_NEAR(by_parameter.axes[0].acceleration, 16 * std::abs(start.d2.x()), 1e-9);
  EXPECT_NEAR(by_parameter.axes[0].jerk, 64 * std::abs(start.d3.x()), 1e-9);

  const Summary by_length = summarise(
      trajectory_of(path, {{0, 0, 3, 0, 0, 0, {}, Law::path_length}}, blend.length / 3), {}, rapid_speed);
  EXPECT_NEAR(by_length.peak_feed, 3, 1e-9);
  EXPECT_NEAR(by_length.axes[0].velocity, 3, 1e-9);
}

TEST(Summary, CountsRapidsAtTheAxesSpeedAndDwellsInTheProgrammedTime) {
  Toolpath toolpath;
  Segment rapid = line_to(Vec3(30, 40, 0), 50, 0);  // Y limits: 250 / 0.8 = 312.5 mm/s
  rapid.rapid = true;
  Segment dwell;
  dwell.kind = SegmentKind::dwell;
  dwell.end = rapid.end;
  dwell.dwell = 1.5;
  const Segment without_feed = line_to(Vec3(30, 40, 20), 20, 0);  // Z limits: 100 mm/s
  toolpath.segments = {rapid, dwell, without_feed, line_to(Vec3(130, 40, 20), 100, 25)};
  EXPECT_DOUBLE_EQ(summarise({}, toolpath, rapid_speed).programmed_time, 50 / 312.5 + 1.5 + 0.2 + 4);
}

TEST(Summary, TakesTheAxesSpeedAlongAnArcWithoutFeed) {
  // Equal axes V: speed V / max(|cos|, |sin|), so a quarter takes (r / V) times the integral of
  // max(|cos|, |sin|) over a quarter turn, sqrt(2).
  Toolpath toolpath;
  toolpath.start = Vec3(10, 0, 0);
  toolpath.arcs = {{Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), Vec3::Zero(), 10, std::numbers::pi / 2}};
  Segment arc = line_to(Vec3(0, 10, 0), toolpath.arcs[0].length(), 0);
  arc.kind = SegmentKind::arc;
  arc.arc = 0;
  toolpath.segments = {arc};
  EXPECT_NEAR(summarise({}, toolpath, Vec3::Constant(100)).programmed_time, 0.1 * std::numbers::sqrt2, 1e-4);
}

TEST(Summary, LeavesDwellsOutOfTheMeanFeed) {
  BlendedPath path;
  path.elements = {line_element(Vec3::Zero(), Vec3(10, 0, 0), 0),
                   line_element(Vec3(10, 0, 0), Vec3(10, 0, 0), 10)};
  path.elements[1].kind = ElementKind::dwell;
  const Summary summary =
      summarise(trajectory_of(std::move(path),
                              {{0, 0, 5, 0, 0, 0, {}, Law::path_length},
                               {2, 0, 0, 0, 0, 1, {CauseKind::dwell, -1}, Law::path_length}},
                              5),
                {}, rapid_speed);
  EXPECT_DOUBLE_EQ(summary.mean_feed, 5);
  EXPECT_DOUBLE_EQ(summary.time_by_cause[cause_index({CauseKind::dwell, -1})], 3);
}

TEST(Summary, TakesTheLargestContourErrorOfTheBlends) {
  std::vector<BlendRecord> blends(3);
  blends[1].epsilon = 0.08;
  blends[2].epsilon = 0.02;
  EXPECT_EQ(summarise(trajectory_of({}, {}, 0, blends), {}, rapid_speed).max_contour_error, 0.08);
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
  BlendedPath path;
  path.elements = {line_element(Vec3::Zero(), Vec3(1, 0, 0), 0)};
  std::vector<Piece> pieces;
  double time = 0;
  for (int i = 0; i < 200000; ++i) {
    pieces.push_back({time, 0, 0, 0, 0, 0, all_causes()[cause(random)], Law::path_length});
    time += std::pow(10, magnitude(random));
  }
  const Summary summary = summarise(trajectory_of(std::move(path), std::move(pieces), time), {}, rapid_speed);
  const double sum = std::accumulate(summary.time_by_cause.begin(), summary.time_by_cause.end(), 0.0);
  EXPECT_NEAR(sum, summary.cycle_time, 1e-12 * summary.cycle_time);
}

}  // namespace
}  // namespace feedscope

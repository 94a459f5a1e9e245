#include "core/analysis/difference/run_difference.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "core/analysis/run/run.h"
#include "tests/core/analysis/hand_made_run.h"
#include "tests/support/paths.h"
#include "tests/support/random_cases.h"

namespace feedscope {
namespace {

using testing::line_to;
using testing::Passage;
using testing::trajectory_of;

const Vec3 axis_speed = Vec3::Constant(300);

Toolpath one_line(double length) {
  Toolpath path;
  path.start = Vec3::Zero();
  path.segments = {line_to(Vec3(length, 0, 0), length, 100, 1)};
  return path;
}

/// At `feed` [mm/s] and `acceleration` [mm/s2] from the start of an element on.
Piece motion(std::uint32_t element, double feed, double acceleration = 0) {
  Piece piece;
  piece.element = element;
  piece.v = feed;
  piece.a = acceleration;
  return piece;
}

/// A line at one feed [mm/s].
Trajectory steady(double length, double feed) {
  return trajectory_of(one_line(length), {{motion(0, feed), length / feed}}, axis_speed);
}

std::vector<double> evenly(double duration, int count) {
  std::vector<double> times;
  for (int i = 0; i <= count; ++i) {
    times.push_back(i == count ? duration : duration * i / count);
  }
  return times;
}

LoadedProgram read(const std::string& text) {
  return load_program(std::make_shared<const SourceText>("test.nc", text));
}

std::shared_ptr<const Trajectory> run_with(const LoadedProgram& program, const std::string& model,
                                           double tolerance) {
  return simulate_run(program,
                      make_setup({.machine = {}, .model = model, .tolerance = tolerance, .assignments = {}}))
      .trajectory;
}

std::shared_ptr<const Trajectory> run_with(const Toolpath& path, const std::string& model, double tolerance) {
  Setup setup = make_setup({.machine = {}, .model = model, .tolerance = tolerance, .assignments = {}});
  return std::make_shared<const Trajectory>(
      setup.model->simulate(std::make_shared<const Toolpath>(path), setup.machine, setup.settings));
}

TEST(RunDifference, OfALineAtTwoFeedsIsTheSameOnEachMillimetre) {
  const Trajectory slow = steady(200, 50);
  const Trajectory fast = steady(200, 80);
  const std::vector<double> times = evenly(slow.duration(), 16);
  const RunDifference difference = compare_places(slow, fast, times);
  const double each = 1 / 50.0 - 1 / 80.0;
  for (std::size_t i = 0; i < times.size(); ++i) {
    EXPECT_NEAR(difference.pace[i], each, 1e-9) << i;
    EXPECT_NEAR(difference.lost[i], each * 50 * times[i], 1e-12) << i;
    EXPECT_NEAR(difference.reference_time[i], times[i] * 50 / 80, 1e-12) << i;
    EXPECT_EQ(difference.distance[i], 0) << i;
  }
  EXPECT_EQ(difference.lost.back(), slow.duration() - fast.duration());
  const RunDifference other_way = compare_places(fast, slow, evenly(fast.duration(), 16));
  EXPECT_NEAR(other_way.pace[7], -each, 1e-9);
}

/// From rest with constant acceleration: v dv = a ds.
TEST(RunDifference, OfALineThatIsSpedUpFollowsTheTimeLaw) {
  const double length = 100;
  const double acceleration = 500;
  const double duration = std::sqrt(2 * length / acceleration);
  const Trajectory ramp =
      trajectory_of(one_line(length), {{motion(0, 0, acceleration), duration}}, axis_speed);
  const Trajectory level = steady(length, 200);
  const std::vector<double> times = evenly(duration, 40);
  const RunDifference difference = compare_places(ramp, level, times);
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double place = acceleration * times[i] * times[i] / 2;
    EXPECT_NEAR(difference.lost[i], times[i] - place / 200, 1e-12) << i;
    EXPECT_TRUE(std::isfinite(difference.pace[i])) << i;
  }
  // The other way round, the law is solved for the time.
  const std::vector<double> others = evenly(level.duration(), 40);
  const RunDifference back = compare_places(level, ramp, others);
  for (std::size_t i = 0; i < others.size(); ++i) {
    EXPECT_NEAR(back.reference_time[i], std::sqrt(2 * 200 * others[i] / acceleration), 1e-9) << i;
  }
}

TEST(RunDifference, WaitsAreComparedWithWaits) {
  Toolpath path = one_line(10);
  Segment wait = line_to(Vec3(10, 0, 0), 0, 100, 2);
  wait.kind = SegmentKind::dwell;
  wait.index = 0;
  path.pauses = {{1, Pause::dwell, true, 0}};
  path.segments.push_back(wait);
  path.segments.push_back(line_to(Vec3(20, 0, 0), 10, 100, 3));
  const auto with_dwell = [&](double feed, double dwell) {
    return trajectory_of(path,
                         {{motion(0, feed), 10 / feed}, {motion(1, 0), dwell}, {motion(2, feed), 10 / feed}},
                         axis_speed);
  };
  const Trajectory run = with_dwell(10, 2);
  const Trajectory reference = with_dwell(10, 0.5);
  const std::vector<double> times{0, 0.5, 1, 1, 2, 3, 3, 3.5, 4};
  const RunDifference difference = compare_places(run, reference, times);
  const std::vector<double> lost{0, 0, 0, 0, 0.75, 1.5, 1.5, 1.5, 1.5};
  for (std::size_t i = 0; i < times.size(); ++i) {
    EXPECT_NEAR(difference.lost[i], lost[i], 1e-12) << i;
    EXPECT_NEAR(difference.pace[i], 0, 1e-9) << i;
  }
}

/// Two lines with a corner of `turn` between them.
Toolpath corner(double turn) {
  return testing::polyline({{0, 0, 0}, {50, 0, 0}, {50 + 50 * std::cos(turn), 50 * std::sin(turn), 0}}, 100);
}

struct Peak {
  double time;
  BlendRecord blend;
};

Peak peak_of(const Trajectory& trajectory) {
  const BlendRecord blend = trajectory.blend(0);
  const double s = trajectory.path().s(blend.element) + blend.length / 2;
  return {trajectory.state_at_path(s).time, blend};
}

/// By trying many places.
double nearest_of(const Trajectory& trajectory, const Vec3& place) {
  constexpr int tried = 20'000;
  double least = std::numeric_limits<double>::infinity();
  const BlendedPath& path = trajectory.path();
  for (std::size_t element = 0; element < path.size(); ++element) {
    const ElementCurve curve = path.curve(element);
    const double low = element == 0 ? path.length(0) - 1 : 0;  // a millimetre beside the corner will do
    const double high = element == 2 ? 1 : path.length(element);
    for (int i = 0; i <= tried; ++i) {
      least = std::min(least, (curve.at(std::lerp(low, high, double(i) / tried)).position - place).norm());
    }
  }
  return least;
}

/// Seen from the sharper corner, the peak of the wider one is the nearest place of it. Seen from the wider
/// one, the lines beside the sharper corner may be nearer.
TEST(RunDifference, OfACornerAtTwoTolerancesIsThatOfTheDeviations) {
  for (const double degrees : {20.0, 45.0, 90.0, 120.0, 150.0}) {
    const double turn = degrees * std::numbers::pi / 180;
    const Toolpath path = corner(turn);
    const auto sharp = run_with(path, "essid", 0.01);
    const auto wide = run_with(path, "essid", 0.05);
    const Peak sharper = peak_of(*sharp);
    const Peak wider = peak_of(*wide);
    const double apart = wider.blend.epsilon - sharper.blend.epsilon;
    ASSERT_GT(apart, 0.01);
    const RunDifference outside = compare_places(*sharp, *wide, std::vector{sharper.time});
    EXPECT_NEAR(outside.distance[0], apart, 1e-7) << degrees;
    EXPECT_NEAR(outside.reference_time[0], wider.time, 1e-9) << degrees;
    const RunDifference inside = compare_places(*wide, *sharp, std::vector{wider.time});
    EXPECT_NEAR(inside.distance[0], nearest_of(*sharp, wide->state(wider.time).position), 1e-7) << degrees;
  }
}

/// Away from the corner both are on the same line at the same place: the paths are one, and what is lost is
/// known from the laws.
TEST(RunDifference, BesideACornerComparesTheSamePlacesOfTheLines) {
  const Toolpath path = corner(std::numbers::pi / 2);
  const auto sharp = run_with(path, "essid", 0.01);
  const auto wide = run_with(path, "essid", 0.05);
  const std::vector<double> times = evenly(sharp->duration(), 500);
  const RunDifference difference = compare_places(*sharp, *wide, times);
  const double wide_transition = peak_of(*wide).blend.transition;
  int compared = 0;
  for (std::size_t i = 0; i < times.size(); ++i) {
    const State here = sharp->state(times[i]);
    const State there = wide->state(difference.reference_time[i]);
    if (std::abs(here.position.x() - 50) > wide_transition || here.position.y() > wide_transition) {
      EXPECT_LT((here.position - there.position).norm(), 1e-7) << i;
      EXPECT_LT(difference.distance[i], 1e-7) << i;
      ++compared;
    }
  }
  EXPECT_GT(compared, 100);
  EXPECT_NEAR(difference.lost.back(), sharp->duration() - wide->duration(), 1e-12);
}

constexpr const char* of_everything =
    "G1 F6000 X50\nY50\nG2 X100 Y0 I50 J0\nG4 P0.5\nG1 X150\nY0.5\nX200 Z10\nX200.1\nX200.2 Z10.01\nG0 X0\n";

TEST(RunDifference, OfARunWithItselfIsNothing) {
  const LoadedProgram program = read(of_everything);
  for (const ControlModel* model : all_models()) {
    const auto run = run_with(program, model->info().id, 0.02);
    if (run->path().is_executed()) {
      continue;  // open: places on the chords of an arc are not matched yet
    }
    const std::vector<double> times = evenly(run->duration(), 777);
    const RunDifference difference = compare_places(*run, *run, times);
    for (std::size_t i = 0; i < times.size(); ++i) {
      EXPECT_NEAR(difference.lost[i], 0, 1e-9) << model->info().id << ' ' << i;
      EXPECT_NEAR(difference.pace[i], 0, 1e-8) << model->info().id << ' ' << i;
      EXPECT_NEAR(difference.distance[i], 0, 1e-7) << model->info().id << ' ' << i;
    }
  }
}

TEST(RunDifference, OfRandomProgramsAddsUpAndIsTheOppositeTheOtherWay) {
  std::mt19937 random(6);
  for (int round = 0; round < test::random_cases(12); ++round) {
    const Toolpath path = testing::random_path(random, 40);
    for (const ControlModel* model : all_models()) {
      const std::string& id = model->info().id;
      const auto fine = run_with(path, id, 0.005);
      if (fine->path().is_executed()) {
        continue;  // open: places on the chords of an arc are not matched yet
      }
      const auto coarse = run_with(path, id, 0.1);
      const std::vector<double> times = evenly(fine->duration(), 400);
      const RunDifference difference = compare_places(*fine, *coarse, times);
      EXPECT_EQ(difference.lost.front(), 0) << id;
      EXPECT_NEAR(difference.lost.back(), fine->duration() - coarse->duration(), 1e-9 * fine->duration())
          << id << ' ' << round;
      EXPECT_TRUE(std::ranges::is_sorted(difference.reference_time)) << id << ' ' << round;
      for (std::size_t i = 0; i < times.size(); ++i) {
        ASSERT_TRUE(std::isfinite(difference.pace[i]) && std::isfinite(difference.distance[i])) << id;
        ASSERT_GE(difference.distance[i], 0);
      }
      const RunDifference back = compare_places(*coarse, *fine, difference.reference_time);
      for (std::size_t i = 0; i < times.size(); ++i) {
        const State here = fine->state(times[i]);
        if (here.speed > 0.1 * here.programmed_feed) {  // near a standstill any rounding is a long time
          EXPECT_NEAR(back.lost[i], -difference.lost[i], 1e-4)
              << id << ' ' << round << ' ' << i << ' ' << here.line << ' ' << here.speed << ' '
              << difference.lost[i] << ' ' << fine->duration();
        }
      }
    }
  }
}

/// Many places are divided between threads.
TEST(RunDifference, OfManyPlacesIsThatOfEach) {
  const LoadedProgram program = read(of_everything);
  for (const ControlModel* model : all_models()) {
    const std::string& id = model->info().id;
    const auto fine = run_with(program, id, 0.005);
    const auto coarse = run_with(program, id, 0.1);
    const std::vector<double> times = evenly(fine->duration(), 20'000);
    Progress progress;
    const RunDifference difference = compare_places(*fine, *coarse, times, &progress);
    EXPECT_EQ(progress.fraction(), 1) << id;
    ASSERT_EQ(difference.distance.size(), times.size());
    for (std::size_t i = 0; i < times.size(); i += 89) {
      const RunDifference alone = compare_places(*fine, *coarse, std::vector{times[i]});
      EXPECT_NEAR(difference.distance[i], alone.distance[0], 1e-6) << id << ' ' << i;
    }
    progress.cancel();
    EXPECT_THROW(compare_places(*fine, *coarse, times, &progress), Cancelled);
  }
}

TEST(RunDifference, NeedsTwoRunsOfOneProgram) {
  const Trajectory run = steady(100, 50);
  EXPECT_THROW(compare_places(run, Trajectory(), std::vector{0.0}), std::invalid_argument);
  const auto other = run_with(read(of_everything), "cam", 0.01);
  EXPECT_THROW(compare_places(run, *other, std::vector{0.0}), std::invalid_argument);
  EXPECT_TRUE(compare_places(run, run, {}).lost.empty());
}

TEST(RunDifference, TakesTimesBeyondTheRunForItsEnds) {
  const RunDifference difference = compare_places(steady(100, 50), steady(100, 25), std::vector{-1.0, 99.0});
  EXPECT_EQ(difference.lost.front(), 0);
  EXPECT_EQ(difference.lost.back(), -2);
}

}  // namespace
}  // namespace feedscope

#include "core/models/optimal/filtered_path.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/base/error.h"
#include "core/base/units.h"
#include "core/trajectory/part_walk.h"
#include "tests/support/motion_checks.h"
#include "tests/support/paths.h"

namespace feedscope {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

Trajectory ward_run(const Toolpath& path, double filters = 3) {
  const ControlModel& ward = find_model("ward");
  Settings settings = testing::spinner_settings(ward);
  settings.set("contour_tolerance_mm", 0.01);
  settings.set("filters", filters);
  return ward.simulate(path, testing::spinner(), settings);
}

BlendedPath fitted(const Trajectory& run) {
  const AxisVectors axes(testing::spinner());
  TrajectoryBuilder builder(run.path().programmed(), axes.velocity);
  FilteredPath(run, axes, FilteredPath::usual_error, builder).lay();
  return builder.path();
}

/// Of `point` from `path` near path length `s` [mm].
double distance_from(const BlendedPath& path, const Vec3& point, double s) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 20; ++i) {
    const std::size_t e = path.element_at(s);
    const CurvePoint at = path.curve(e).at(s - path.s(e));
    least = std::min(least, (at.position - point).norm());
    s = std::clamp(s + (point - at.position).dot(at.d1), 0.0, path.length());
  }
  return least;
}

void expect_within_error(const Trajectory& run, const BlendedPath& path, int samples) {
  for (std::size_t e = 1; e < path.size(); ++e) {
    ASSERT_LT((path.curve(e).start - path.curve(e - 1).end).norm(), 1e-9) << "element " << e;
  }
  for (int i = 0; i <= samples; ++i) {
    const State at = run.state(run.duration() * i / samples);
    ASSERT_LE(distance_from(path, at.position, at.path_length), FilteredPath::usual_error)
        << "at " << at.time << " s";
  }
}

void expect_close_everywhere(const Trajectory& run, int samples = 2000) {
  const BlendedPath path = fitted(run);
  ASSERT_NEAR(path.length(), run.path_length(), 1e-6 * (1 + run.path_length()));
  expect_within_error(run, path, samples);
}

TEST(FilteredPath, LiesWithinItsErrorOfTheMotion) {
  std::mt19937 random(23);
  for (int i = 0; i < 20; ++i) {
    SCOPED_TRACE(i);
    expect_close_everywhere(ward_run(testing::random_path(random, 4 + 3 * i), i % 2 == 0 ? 3 : 2));
    if (::testing::Test::HasFatalFailure()) {
      return;
    }
  }
}

TEST(FilteredPath, LiesWithinItsErrorWhereTheMotionBeginsOnAnArc) {
  // p' = p'' = 0 there, and the curvature of the path is infinite.
  Toolpath path;
  path.start = Vec3(5, 0, 0);
  testing::append_arc(path, Vec3::Zero(), 1.5 * units::pi, 50);
  expect_close_everywhere(ward_run(path));
}

TEST(FilteredPath, HasOneCurveForAStraightLineAndMeetsItsEnds) {
  const BlendedPath path = fitted(ward_run(testing::polyline({{1, 2, 3}, {40, 30, -5}}, 50)));
  ASSERT_EQ(path.size(), 1U);
  const ElementCurve curve = path.curve(0);
  EXPECT_EQ(curve.start, Vec3(1, 2, 3));
  EXPECT_LT((curve.end - Vec3(40, 30, -5)).norm(), 1e-12);
  for (const CourseKnot& knot : curve.course) {
    EXPECT_EQ(knot.curvature.norm(), 0);
  }
}

TEST(FilteredPath, EndsElementsWhereTheMotionStands) {
  // Contour tolerance 0 in the corner of a stretch: see the kink at (10, 0).
  const BlendedPath path =
      fitted(ward_run(testing::polyline({{0, 0, 0}, {10, 0, 0}, {5, 0, 0}, {5, 8, 0}}, 50)));
  ASSERT_GE(path.size(), 3U);
  EXPECT_LT((path.curve(0).end - Vec3(10, 0, 0)).norm(), 1e-9);
  EXPECT_NEAR(path.curve(0).at(10).d1.x(), 1, 1e-12);
  EXPECT_NEAR(path.curve(1).at(0).d1.x(), -1, 1e-12);
}

/// Curves no longer than half as much again as their chords.
void expect_short_curves(const BlendedPath& path) {
  for (std::size_t e = 0; e < path.size(); ++e) {
    const auto course = path.curve(e).course;
    for (std::size_t i = 0; i + 1 < course.size(); ++i) {
      const double chord = (course[i + 1].position - course[i].position).norm();
      ASSERT_LE(course[i + 1].s - course[i].s, 1.5 * chord) << "element " << e << ", curve " << i;
    }
  }
}

TEST(FilteredPath, GoesThroughNearReversalsWithoutLoops) {
  // There the motion nearly stands while it turns: within nanometres and less the curvature has no bound.
  std::mt19937 random(41);
  std::uniform_real_distribution<double> exponent(-12, 0);
  std::uniform_real_distribution<double> length(-4, 1.5);
  std::normal_distribution<double> across;
  for (int i = 0; i < 300; ++i) {
    SCOPED_TRACE(i);
    Vec3 along = Vec3(across(random), across(random), across(random)).normalized();
    std::vector<Vec3> points{{-31.856, 21.052, 0}};
    for (int k = 0; k < 6; ++k) {
      points.push_back(points.back() + std::pow(10, length(random)) * along);
      const Vec3 off(across(random), across(random), across(random));
      along = (std::pow(10, exponent(random)) * off - along).normalized();
    }
    const Trajectory run = ward_run(testing::polyline(points, 350), i % 2 == 0 ? 3 : 2);
    const BlendedPath path = fitted(run);
    expect_short_curves(path);
    expect_within_error(run, path, 200);
    if (::testing::Test::HasFatalFailure()) {
      return;
    }
  }
}

TEST(FilteredPath, ManyBlocksShorterThanRoundingAllowsAreLaidTogether) {
  std::vector<Vec3> points;
  for (int i = 0; i <= 1000; ++i) {
    points.push_back({1e-5 * i, 1e-5 * (i % 2), 0});
  }
  const Trajectory run = ward_run(testing::polyline(points, 50));
  const BlendedPath path = fitted(run);
  EXPECT_LT(path.size(), 200U);
  expect_close_everywhere(run, 100);
}

TEST(FilteredPath, RefusesWhatTurnsAboutTooOftenAndNamesTheLine) {
  constexpr double turns = 40'000;
  Toolpath path;
  path.start = Vec3(1, 0, 0);
  testing::append_arc(path, Vec3::Zero(), turns * 2 * units::pi, 50);
  path.segments.back().line = 12;
  const Trajectory run = ward_run(path);
  try {
    fitted(run);
    FAIL() << "laid";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(),
                AllOf(HasSubstr("path of ward needs more than 202000 curves"), HasSubstr("up to line 12"),
                      HasSubstr("choose the path of another model")));
  }
}

TEST(FilteredPath, KeepsDwells) {
  Toolpath toolpath = testing::polyline({{0, 0, 0}, {10, 0, 0}}, 50);
  testing::append_dwell(toolpath, 0.25);
  testing::append_line(toolpath, Vec3(10, 10, 0), 50);
  const BlendedPath path = fitted(ward_run(toolpath));
  ASSERT_EQ(path.size(), 3U);
  EXPECT_EQ(path.kind(1), ElementKind::dwell);
  EXPECT_LT((path.curve(2).end - Vec3(10, 10, 0)).norm(), 1e-9);
}

}  // namespace
}  // namespace feedscope

#include "core/blend/fitted_course.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace feedscope {
namespace {

CourseKnot on_circle(double radius, double angle) {
  const Vec3 out(std::cos(angle), std::sin(angle), 0);
  return {0, radius * out, Vec3(-out.y(), out.x(), 0), -out / radius};
}

/// Knots of a circle every `step` [rad], with their path lengths.
std::vector<CourseKnot> circle_course(double radius, double step, int count) {
  std::vector<CourseKnot> course{on_circle(radius, 0)};
  for (int i = 1; i <= count; ++i) {
    CourseKnot knot = on_circle(radius, i * step);
    knot.s = course.back().s + course_length(course.back(), knot);
    course.push_back(knot);
  }
  return course;
}

TEST(FittedCourse, IsExactOnALine) {
  const Vec3 direction = Vec3(1, 2, -2) / 3;
  CourseKnot from{0, Vec3(5, -1, 2), direction, Vec3::Zero()};
  CourseKnot to{0, from.position + 7 * direction, direction, Vec3::Zero()};
  to.s = course_length(from, to);
  EXPECT_NEAR(to.s, 7, 1e-14);
  const CurvePoint at = CourseSpan(from, to).at(2.5);
  EXPECT_LT((at.position - (from.position + 2.5 * direction)).norm(), 1e-14);
  EXPECT_LT((at.d1 - direction).norm(), 1e-14);
  EXPECT_LT(at.d2.norm(), 1e-14);
}

TEST(FittedCourse, FollowsACircleToTheSixthOrderOfTheStep) {
  constexpr double radius = 10;
  double before = 0;
  for (const double step : {0.8, 0.4}) {
    const std::vector<CourseKnot> course = circle_course(radius, step, 3);
    double off = 0;
    for (double s = 0; s <= course.back().s; s += 0.01) {
      off = std::max(off, std::abs(course_at(course, s).position.norm() - radius));
    }
    EXPECT_GT(before == 0 ? 1 : before / off, before == 0 ? 0.5 : 50);
    before = off;
  }
  EXPECT_LT(before, 1e-6);
}

TEST(FittedCourse, IsGivenByPathLength) {
  const std::vector<CourseKnot> course = circle_course(10, 0.3, 4);
  EXPECT_NEAR(course.back().s, 12, 1e-7);
  constexpr double h = 1e-4;
  for (double s = 0.1; s < course.back().s - 0.1; s += 0.37) {
    const CurvePoint at = course_at(course, s);
    const CurvePoint before = course_at(course, s - h);
    const CurvePoint after = course_at(course, s + h);
    EXPECT_NEAR(at.d1.norm(), 1, 1e-14);
    EXPECT_NEAR((after.position - at.position).norm(), h, 1e-9 * h + 1e-12);
    EXPECT_LT(((after.position - before.position) / (2 * h) - at.d1).norm(), 1e-9);
    EXPECT_LT(((after.d1 - before.d1) / (2 * h) - at.d2).norm(), 1e-8);
    EXPECT_LT(((after.d2 - before.d2) / (2 * h) - at.d3).norm(), 1e-5);
  }
}

TEST(FittedCourse, FindsTheNearestPlace) {
  const std::vector<CourseKnot> course = circle_course(10, 0.3, 1);
  const CourseSpan span(course[0], course[1]);
  const double angle = 0.11;
  double s = span.length() / 2;
  EXPECT_NEAR(span.distance(10.02 * Vec3(std::cos(angle), std::sin(angle), 0), s), 0.02, 2e-7);
  EXPECT_NEAR(s, 10 * angle, 1e-6);
}

TEST(FittedCourse, MeetsItsKnotsAtBothEnds) {
  const std::vector<CourseKnot> course = circle_course(10, 0.3, 3);
  for (const CourseKnot& knot : course) {
    EXPECT_LT((course_at(course, knot.s).position - knot.position).norm(), 1e-14 * 100);
  }
  EXPECT_LT((course_at(course, course.back().s + 1).position - course.back().position).norm(), 1e-14 * 100);
}

}  // namespace
}  // namespace feedscope

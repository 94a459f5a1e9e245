#include "core/blend/corner.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/base/units.h"
#include "core/blend/blended_path.h"
#include "tests/support/paths.h"

namespace feedscope {
namespace {

constexpr double far = 1e9;  // no neighbour cuts the transition

std::vector<Vec3> directions() {
  const std::vector<Vec3> points = testing::essid_table1();
  std::vector<Vec3> unit;
  for (std::size_t i = 1; i < points.size(); ++i) {
    unit.push_back((points[i] - points[i - 1]).normalized());
  }
  return unit;
}

TEST(TurnAngle, IsExactAtAwkwardAngles) {
  const Vec3 x(1, 0, 0);
  EXPECT_EQ(turn_angle(x, x), 0);
  EXPECT_DOUBLE_EQ(turn_angle(x, -x), units::pi);
  EXPECT_NEAR(turn_angle(x, Vec3(std::cos(1e-9), std::sin(1e-9), 0)), 1e-9, 1e-22);
  EXPECT_NEAR(turn_angle(x, Vec3(0, 0, 1)), units::pi / 2, 1e-15);
}

TEST(Corner, GivesTheTransitionLengthsOfEssidTable1) {
  // models/essid/README.md, 1e-5 relative; beta 0.8 at corner 1, 0.6 where an axis reverses
  const auto unit = directions();
  const double expected[] = {.824239, .226274, .320003};
  const double with_full_tolerance[] = {1.030298, .377124, .533339};
  for (std::size_t i = 0; i < 3; ++i) {
    CornerRule rule;
    const Corner corner = lay_corner(unit[i], unit[i + 1], far, rule);
    EXPECT_NEAR(corner.transition, expected[i], 1e-5 * expected[i]);
    EXPECT_DOUBLE_EQ(corner.epsilon, i == 0 ? 0.08 : 0.06);
    rule.beta = 1;
    EXPECT_NEAR(lay_corner(unit[i], unit[i + 1], far, rule).transition, with_full_tolerance[i],
                1e-5 * with_full_tolerance[i]);
  }
}

TEST(ArcCorner, IsTangentToBothLinesAndKeepsItsDistance) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto direction = [&] { return Vec3(unit(random), unit(random), unit(random)).normalized(); };
  for (int i = 0; i < 200; ++i) {
    const Vec3 in = direction();
    const Vec3 out = direction();
    const Vec3 point = 100 * direction();
    const Corner corner = lay_arc_corner(in, out, i % 2 == 0 ? far : 0.01, {});
    const Arc arc = corner_arc(point, in, out, corner.transition);
    const CurvePoint start = arc.at(0);
    const CurvePoint end = arc.at(arc.length());
    ASSERT_LT((start.position - (point - corner.transition * in)).norm(), 1e-12);
    ASSERT_LT((end.position - (point + corner.transition * out)).norm(), 1e-12);
    ASSERT_LT((start.d1 - in).norm(), 1e-12);
    ASSERT_LT((end.d1 - out).norm(), 1e-12);
    ASSERT_NEAR((arc.at(arc.length() / 2).position - point).norm(), corner.epsilon, 1e-12);
    ASSERT_LE(corner.epsilon, 0.08 * (1 + 1e-12));
  }
}

TEST(ArcCorner, OfTheSmallestAngleKeepsItsPlaceToRounding) {
  const Vec3 in = Vec3(3, 4, 12) / 13;
  const Vec3 out = (in + 2e-6 * Vec3(4, -3, 0) / 5).normalized();
  const Corner corner = lay_arc_corner(in, out, 500, {});
  const Arc arc = corner_arc(Vec3::Zero(), in, out, corner.transition);
  EXPECT_NEAR(arc.radius, largest_arc_radius, 1);
  EXPECT_LT((arc.at(arc.length()).position - corner.transition * out).norm(), 1e-9);
}

TEST(Corner, GivesLeastRadiusAndLengthOfEssidTable1) {
  const auto unit = directions();
  const double radius[] = {1.81987, .09800, .29401};
  const double length[] = {1.619259, .386451, .596059};
  for (std::size_t i = 0; i < 3; ++i) {
    const Corner corner = lay_corner(unit[i], unit[i + 1], far, {});
    const BlendShape shape(unit[i], unit[i + 1], corner.transition, 2.5);
    EXPECT_NEAR(1 / shape.middle_curvature(), radius[i], 1e-4 * radius[i]);
    EXPECT_NEAR(corner_blend(Vec3::Zero(), unit[i], unit[i + 1], corner.transition, 2.5).length(), length[i],
                1e-5 * length[i]);
    const double tangent = std::tan(corner.turn / 2);
    EXPECT_NEAR(shape.middle_curvature(),
                2.5 * 1.5 * tangent * tangent / (8 * corner.epsilon * std::pow(1.5 - 2.5 / 4, 2)), 1e-9);
  }
}

TEST(Corner, PassesTheCornerAtEpsilon) {
  const auto unit = directions();
  const Vec3 point(3, -4, 5);
  for (std::size_t i = 0; i < 3; ++i) {
    const Corner corner = lay_corner(unit[i], unit[i + 1], far, {});
    const CubicBlend blend = corner_blend(point, unit[i], unit[i + 1], corner.transition, 2.5);
    EXPECT_NEAR((blend.at(0.5).position - point).norm(), corner.epsilon, 1e-12);
  }
}

TEST(Corner, ShortNeighboursCutTheTransitionAndTheDeviation) {
  const auto unit = directions();
  const Corner whole = lay_corner(unit[0], unit[1], far, {});
  const Corner cut = lay_corner(unit[0], unit[1], 0.1, {});
  EXPECT_DOUBLE_EQ(cut.transition, 0.1);
  EXPECT_NEAR(cut.epsilon, whole.epsilon * 0.1 / whole.transition, 1e-15);
}

TEST(BlendShape, CurvatureAtTheEntryFollowsFromTheTurn) {
  // k(0) = (6 - 2 alpha) sin(phi) / (alpha^2 T)
  const auto unit = directions();
  for (const double alpha : {2.0, 2.5, 2.9}) {
    const BlendShape shape(unit[1], unit[2], 0.3, alpha);
    const double phi = turn_angle(unit[1], unit[2]);
    EXPECT_NEAR(shape.at(0).k, (6 - 2 * alpha) * std::sin(phi) / (alpha * alpha * 0.3), 1e-12);
  }
}

TEST(BlendShape, AgreesWithTheCurveAndItsFiniteDifferences) {
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 200; ++i) {
    const Vec3 in = Vec3(normal(random), normal(random), normal(random)).normalized();
    const Vec3 out = Vec3(normal(random), normal(random), normal(random)).normalized();
    const double transition = 0.7;
    const BlendShape shape(in, out, transition, 2.5);
    const CubicBlend curve = corner_blend(Vec3::Zero(), in, out, transition, 2.5);
    for (const double u : {0.1, 0.35, 0.5, 0.8}) {
      const BlendShape::Point p = shape.at(u);
      const CurvePoint c = curve.at(u);
      const double sharp = 1 + p.k + std::abs(p.dk_ds);
      ASSERT_NEAR(p.sigma, c.d1.norm(), 1e-12);
      ASSERT_LT((p.tangent - c.d1.normalized()).norm(), 1e-9);
      const double h = 1e-5;
      const auto before = shape.at(u - h), after = shape.at(u + h);
      ASSERT_NEAR(p.dsigma, (after.sigma - before.sigma) / (2 * h), 1e-6 * sharp);
      ASSERT_NEAR(p.ddsigma, (after.dsigma - before.dsigma) / (2 * h), 1e-5 * sharp * sharp);
      ASSERT_NEAR(p.dk_ds, (after.k - before.k) / (2 * h * p.sigma), 1e-4 * sharp * sharp);
      const Vec3 turning = (after.tangent - before.tangent) / (2 * h * p.sigma);
      ASSERT_LT((turning - p.k * p.normal).norm(), 1e-4 * sharp * sharp);
    }
  }
}

TEST(BlendShape, LargestTangentIsTheLargestOfManyPlaces) {
  const auto unit = directions();
  for (const Vec3& in : unit) {
    for (const Vec3& out : unit) {
      const double turn = turn_angle(in, out);
      if (turn < 0.01 || turn > 3) {
        continue;
      }
      const BlendShape shape(in, out, 0.5, 2.5);
      Vec3 largest = Vec3::Zero();
      for (int i = 0; i <= 2000; ++i) {
        largest = largest.cwiseMax(shape.at(i / 2000.0).tangent.cwiseAbs());
      }
      const Vec3 exact = shape.largest_tangent();
      ASSERT_TRUE((exact.array() >= largest.array() - 1e-12).all());
      ASSERT_LT((exact - largest).norm(), 1e-3);
    }
  }
}

TEST(ElementCurve, DerivativesByPathLengthBelongToAUnitSpeedCurve) {
  const auto unit = directions();
  ElementCurve curve;
  curve.kind = ElementKind::blend;
  curve.blend = corner_blend(Vec3(1, 2, 3), unit[1], unit[2], 0.5, 2.5);
  curve.length = curve.blend.length();
  const double h = 1e-5;
  for (double s = 0.05; s < curve.length - 0.05; s += 0.05) {
    const CurvePoint at = curve.at(s);
    const CurvePoint before = curve.at(s - h), after = curve.at(s + h);
    EXPECT_NEAR(at.d1.norm(), 1, 1e-9);
    EXPECT_NEAR(at.d1.dot(at.d2), 0, 1e-8);
    EXPECT_LT(((after.position - before.position) / (2 * h) - at.d1).norm(), 1e-6);
    EXPECT_LT(((after.d1 - before.d1) / (2 * h) - at.d2).norm(), 1e-5);
    EXPECT_LT(((after.d2 - before.d2) / (2 * h) - at.d3).norm(), 1e-3);
  }
}

}  // namespace
}  // namespace feedscope

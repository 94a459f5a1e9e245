#include "core/limits/segment_limits.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/units.h"
#include "tests/support/paths.h"

namespace feedscope {
namespace {

using units::from_deg;
using units::to_m_min;

AxisVectors mikron() {
  return AxisVectors(testing::mikron());
}

Toolpath circle(double radius, double from, double sweep, double feed) {
  Toolpath path;
  path.start = radius * Vec3(std::cos(from), std::sin(from), 0);
  testing::append_arc(path, Vec3::Zero(), sweep, feed);
  return path;
}

TEST(AxisShare, IsTheLeastLimitOverItsPartOfTheDirection) {
  const AxisBound bound = axis_share(Vec3(10, 20, 30), Vec3(0.6, -0.8, 0));
  EXPECT_DOUBLE_EQ(bound.value, 10 / 0.6);
  EXPECT_EQ(bound.axis, 0);
  EXPECT_EQ(axis_share(Vec3(10, 20, 30), Vec3(0, 0, -1)).axis, 2);
  EXPECT_TRUE(std::isinf(axis_share(Vec3(10, 20, 30), Vec3::Zero()).value));
}

TEST(SegmentLimits, ALineTakesTheAxisThatIsSlowestAlongIt) {
  const Toolpath path = testing::polyline({{0, 0, 0}, {3, 4, 0}}, 1e6);
  const MotionLimits limits = segment_limits(path, 0, mikron());
  EXPECT_DOUBLE_EQ(limits.speed.value, 500 / 0.8);
  EXPECT_EQ(limits.speed.cause, (Cause{CauseKind::axis_velocity, 1}));
  EXPECT_DOUBLE_EQ(limits.acceleration.value, 3000 / 0.8);
  EXPECT_DOUBLE_EQ(limits.jerk.value, 5000 / 0.8);
}

TEST(SegmentLimits, AWholeCircleIsLimitedWhereOneAxisMovesAlone) {
  // R 2.5: V_An = sqrt(R 2.5 m/s2) = 4.743 m/min (print says 2.55), V_Jt = cbrt(5 m/s3 R^2) = 1.89 m/min
  const Toolpath path = circle(2.5, 0.3, 2 * units::pi, units::from_m_min(6));
  const MotionLimits limits = segment_limits(path, 0, mikron());
  EXPECT_NEAR(to_m_min(std::sqrt(2.5 * 2500)), 4.743, 5e-4);
  EXPECT_NEAR(limits.speed.value, std::cbrt(5000 * 2.5 * 2.5), 1e-9);
  EXPECT_EQ(limits.speed.cause.kind, CauseKind::radial_jerk);
  EXPECT_NEAR(limits.jerk.value, 5000, 1e-9);
}

TEST(SegmentLimits, AShortArcAroundTheDiagonalUsesBothAxes) {
  // Tangent at 45 degrees: J_t = 5 sqrt 2 = 7.07 m/s3, least at the ends of the arc
  const Toolpath path = circle(30, from_deg(40), from_deg(10), 1e6);
  const double largest = std::cos(from_deg(40));
  EXPECT_NEAR(segment_limits(path, 0, mikron()).jerk.value, 5000 / largest, 1e-9);
}

TEST(SegmentLimits, ArcsReachTheirExtremesInsideAndInBothSenses) {
  // from 80 to 100 degrees X moves alone at 90 degrees, whichever way round
  for (const double sign : {1.0, -1.0}) {
    const Toolpath path = circle(30, from_deg(90 - sign * 10), sign * from_deg(20), 1e6);
    EXPECT_NEAR(segment_limits(path, 0, mikron()).jerk.value, 5000, 1e-9);
    EXPECT_EQ(segment_limits(path, 0, mikron()).jerk.axis, 0);
  }
}

TEST(SegmentLimits, RapidsRunAtTheSpeedOfTheAxes) {
  Toolpath path = testing::polyline({{0, 0, 0}, {10, 10, 0}}, 0);
  path.segments[0].rapid = true;
  const SpeedBound bound = programmed_speed(path, 0, mikron().velocity);
  EXPECT_NEAR(bound.value, 500 * std::sqrt(2), 1e-9);
  EXPECT_EQ(bound.cause.kind, CauseKind::rapid);
}

struct Crossing {
  double r1, r2, degrees, feed;  // mm, mm, degrees, m/min
};

class CrossingOfTapie : public ::testing::TestWithParam<Crossing> {};

TEST_P(CrossingOfTapie, IsReproduced) {
  // models/tapie/README.md: 0.5 %; t_cy 12 ms. The curvature vectors point to a common centre.
  const auto [r1, r2, degrees, feed] = GetParam();
  const Vec3 inward = -Vec3(std::cos(from_deg(degrees)), std::sin(from_deg(degrees)), 0);
  const SpeedBound bound = crossing_speed(inward * (1 / r2 - 1 / r1), mikron().jerk, 0.012);
  EXPECT_NEAR(to_m_min(bound.value), feed, 0.005 * feed);
  EXPECT_EQ(bound.cause.kind, CauseKind::curvature_crossing);
}

INSTANTIATE_TEST_SUITE_P(Table, CrossingOfTapie,
                         ::testing::Values(Crossing{14, 16, 0, 4.919}, Crossing{14, 16, 30, 5.285},
                                           Crossing{14, 16, 45, 5.849}, Crossing{1.5, 2.5, 0, 0.9},
                                           Crossing{20, 30, 0, 3.6}));

}  // namespace
}  // namespace feedscope

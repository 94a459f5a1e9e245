#include "core/program/path/arc_solver.h"
#include "core/base/units.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/core/program/read_text.h"

namespace feedscope {
namespace {

using units::pi;
const Vec3 up = Vec3::UnitZ();

Vec3 on_circle(double radius, double angle) {
  return {radius * std::cos(angle), radius * std::sin(angle), 0};
}

double flat_distance(const Vec3& a, const Vec3& b) {
  return (a - b).head<2>().norm();
}

TEST(ArcSolver, SoundArcKeepsItsCentre) {
  const ArcSolution arc = solve_center_arc({10, 0, 3}, {0, 10, 3}, {0, 0, 3}, up, 0);
  ASSERT_EQ(arc.count, 1);
  EXPECT_LT((arc.pieces[0].words.center - Vec3(0, 0, 3)).norm(), 1e-12);
  EXPECT_EQ(arc.pieces[0].words.turns, 0);
  EXPECT_EQ(arc.pieces[0].target, Vec3(0, 10, 3));
}

TEST(ArcSolver, CentreComesToLieAtTheHeightOfTheStart) {
  const ArcSolution helix = solve_center_arc({10, 0, 3}, {0, 10, 8}, {0, 0, 99}, up, 0);
  EXPECT_NEAR(helix.pieces[0].words.center.z(), 3, 1e-12);
}

TEST(ArcSolver, EndsThatCoincideInThePlaneAreAFullTurn) {
  EXPECT_EQ(solve_center_arc({10, 0, 0}, {10, 0, 0}, {0, 0, 0}, up, 0).pieces[0].words.turns, 1);
  EXPECT_EQ(solve_center_arc({10, 0, 0}, {10, 0, -4}, {0, 0, 0}, up, 2).pieces[0].words.turns, 3);
}

TEST(ArcSolver, SmallMismatchMovesTheCentreToEqualRadii) {
  const Vec3 start(10, 0, 0);
  const Vec3 end(0, 10.008, 0);
  const ArcSolution arc = solve_center_arc(start, end, Vec3::Zero(), up, 0);
  ASSERT_EQ(arc.count, 1);
  const Vec3 center = arc.pieces[0].words.center;
  EXPECT_NEAR((start - center).norm(), (end - center).norm(), 1e-12);
  EXPECT_LT(center.norm(), 0.008);
}

TEST(ArcSolver, MismatchBeyondTheToleranceIsAFault) {
  EXPECT_EQ(solve_center_arc({10, 0, 0}, {0, 10.009, 0}, Vec3::Zero(), up, 0).fault, ArcFault::none);
  EXPECT_EQ(solve_center_arc({10, 0, 0}, {0, 10.012, 0}, Vec3::Zero(), up, 0).fault,
            ArcFault::radius_mismatch);
  EXPECT_EQ(ArcTolerance().of(1), 0.01);
  EXPECT_EQ(ArcTolerance().of(100), 0.1);
  EXPECT_EQ(ArcTolerance().of(1e5), 0.5);
}

TEST(ArcSolver, WhatAControlAcceptsIsAnArcOfItsOwnTolerance) {
  // LinuxCNC in mm: 0.0283 mm or 0.1 %, not above 2.83 mm.
  const auto reads = [](double radius, double mismatch) {
    const std::string text = fmt::format("G21 G17\nG0 X{:.4f} Y0\nG3 X0 Y{:.4f} I{:.4f} F100\n", radius,
                                         radius + mismatch, -radius);
    return !has_errors(read_text(text, {.dialect = Dialect::linuxcnc}).diagnostics);
  };
  for (const double radius : {1.0, 10.0, 28.0}) {
    EXPECT_TRUE(reads(radius, 0.028)) << radius;
    EXPECT_FALSE(reads(radius, 0.03)) << radius;
  }
  EXPECT_TRUE(reads(100, 0.099));
  EXPECT_FALSE(reads(100, 0.101));
  EXPECT_TRUE(reads(2000, 1.9)) << "no half millimetre at most, as elsewhere";
  EXPECT_FALSE(reads(10000, 3));
  EXPECT_TRUE(
      has_errors(read_text("G0 X10 Y0\nG3 X0 Y10.028 I-10 F100\n", {.dialect = Dialect::fanuc}).diagnostics));
}

TEST(ArcSolver, CentreAtTheStartIsAFault) {
  EXPECT_EQ(solve_center_arc({1, 2, 0}, {1, 2, 0}, {1, 2, 0}, up, 0).fault, ArcFault::center_at_start);
  EXPECT_EQ(solve_center_arc({1, 2, 0}, {1, 2, 5}, {1, 2, 7}, up, 0).fault, ArcFault::center_at_start);
}

/// A nearly full circle whose end is rounded off the circle: one circle through both ends would lie far off.
TEST(ArcSolver, NearlyFullCircleWithAMismatchBecomesTwoTouchingArcs) {
  for (const double gap : {0.0, 1e-5, 1e-3}) {
    const Vec3 start = on_circle(50, 0);
    const Vec3 end = on_circle(50.004, -gap) + Vec3(0, 0, 2);
    const ArcSolution arc = solve_center_arc(start, end, Vec3::Zero(), up, 0);
    ASSERT_EQ(arc.count, 2) << "gap " << gap;
    const auto& [first, second] = arc.pieces;
    EXPECT_NEAR(flat_distance(first.target, first.words.center), 50, 1e-9);
    const double radius = flat_distance(first.target, second.words.center);
    EXPECT_NEAR(flat_distance(end, second.words.center), radius, 1e-9);
    EXPECT_LT(std::abs(radius - 50), 0.004);
    EXPECT_EQ(second.target, end);
    const Vec3 out = first.target - first.words.center;
    const Vec3 again = first.target - second.words.center;
    EXPECT_NEAR(out.cross(again).z(), 0, 1e-9 * 2500) << "one tangent where they touch";
    EXPECT_NEAR(first.target.z(), 1, 1e-3) << "half of the rise";
  }
}

TEST(ArcSolver, RadiusGivesTheSmallerArcAndNegativeRadiusTheLarger) {
  const Vec3 start(10, 0, 0);
  const Vec3 end(0, 10, 0);
  EXPECT_LT(solve_radius_arc(start, end, 10, up, 0).pieces[0].words.center.norm(), 1e-12);
  EXPECT_LT((solve_radius_arc(start, end, -10, up, 0).pieces[0].words.center - Vec3(10, 10, 0)).norm(),
            1e-12);
  EXPECT_LT((solve_radius_arc(start, end, 10, -up, 0).pieces[0].words.center - Vec3(10, 10, 0)).norm(),
            1e-12);
}

TEST(ArcSolver, RadiusOfHalfTheDistanceIsAHalfCircle) {
  for (const double radius : {10.0, 9.995, -10.0}) {
    const ArcSolution arc = solve_radius_arc({-10, 0, 0}, {10, 0, 0}, radius, up, 0);
    ASSERT_EQ(arc.fault, ArcFault::none);
    EXPECT_LT(arc.pieces[0].words.center.norm(), 1e-12);
  }
}

TEST(ArcSolver, ImpossibleRadiusIsAFault) {
  EXPECT_EQ(solve_radius_arc({-10, 0, 0}, {10, 0, 0}, 9.98, up, 0).fault, ArcFault::radius_too_small);
  EXPECT_EQ(solve_radius_arc({-10, 0, 0}, {10, 0, 0}, 0, up, 0).fault, ArcFault::radius_too_small);
  EXPECT_EQ(solve_radius_arc({1, 1, 0}, {1, 1, 4}, 5, up, 0).fault, ArcFault::same_ends);
}

TEST(ArcSolver, BothEndsLieOnEveryArcFound) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> angle(0, 2 * pi);
  std::uniform_real_distribution<double> small(-0.009, 0.009);
  for (int round = 0; round < 2000; ++round) {
    const Vec3 center(3, -4, 0);
    Vec3 start = center + on_circle(10, angle(random));
    const Vec3 end = center + on_circle(10 + small(random), angle(random));
    const ArcSolution arc = solve_center_arc(start, end, center, up, 0);
    ASSERT_EQ(arc.fault, ArcFault::none);
    for (int i = 0; i < arc.count; ++i) {
      const auto& piece = arc.pieces[static_cast<std::size_t>(i)];
      EXPECT_NEAR((start - piece.words.center).norm(), (piece.target - piece.words.center).norm(), 1e-9);
      start = piece.target;
    }
    EXPECT_EQ(start, end);
  }
}

}  // namespace
}  // namespace feedscope

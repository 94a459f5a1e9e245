#include "core/program/path/corner_rounding.h"

#include <gtest/gtest.h>

#include <random>

#include "core/base/units.h"
#include "core/program/heidenhain/geometry/approach.h"
#include "core/program/path/plane_points.h"

namespace feedscope {
namespace {

using heidenhain::approach_path;
using heidenhain::ApproachKind;
using heidenhain::ApproachPath;
using heidenhain::ApproachShape;
using heidenhain::departure_path;

PlaneElement line(Vec2 from, Vec2 to) {
  return PlaneElement::line(from, to);
}
PlaneElement arc(Vec2 from, Vec2 to, Vec2 center, int turn) {
  return PlaneElement::arc(from, to, center, turn, 0);
}

void expect_near(const Vec2& a, const Vec2& b, double tolerance = 1e-12) {
  EXPECT_LT((a - b).norm(), tolerance) << a.transpose() << " against " << b.transpose();
}

// A right angle is rounded by a quarter circle whose ends lie one radius from the corner.
TEST(CornerRounding, RightAngleBecomesAQuarterCircle) {
  const PlaneCorner piece = round_corner(line({0, 0}, {10, 0}), line({10, 0}, {10, 10}), 3);
  ASSERT_EQ(piece.fault, CornerFault::none);
  expect_near(piece.from, {7, 0});
  expect_near(piece.to, {10, 3});
  expect_near(piece.center, {7, 3});
  EXPECT_EQ(piece.turn, 1);
  EXPECT_EQ(round_corner(line({0, 0}, {10, 0}), line({10, 0}, {10, -10}), 3).turn, -1);
}

// Cutting off the radius over the tangent of half the inner angle.
TEST(CornerRounding, AnyAngleIsCutByRadiusTimesTangentOfHalfTheTurn) {
  for (double turn = 0.1; turn < 3; turn += 0.1) {
    const Vec2 end(100 + 100 * std::cos(turn), 100 * std::sin(turn));
    const PlaneCorner piece = round_corner(line({0, 0}, {100, 0}), line({100, 0}, end), 2);
    ASSERT_EQ(piece.fault, CornerFault::none) << turn;
    EXPECT_NEAR(100 - piece.from.x(), 2 * std::tan(turn / 2), 1e-9);
    EXPECT_NEAR((piece.to - Vec2(100, 0)).norm(), 2 * std::tan(turn / 2), 1e-9);
  }
}

// From a line along X onto a circle about the origin: the centre lies one radius above the line and on the
// circle of 10 - 2.
TEST(CornerRounding, LineAndArcAreTouchedInside) {
  const PlaneCorner piece = round_corner(line({0, 0}, {10, 0}), arc({10, 0}, {0, 10}, {0, 0}, 1), 2);
  ASSERT_EQ(piece.fault, CornerFault::none);
  expect_near(piece.center, {std::sqrt(64 - 4), 2});
  EXPECT_NEAR(piece.to.norm(), 10, 1e-12);
  expect_near(piece.from, {std::sqrt(60), 0});
}

TEST(CornerRounding, NamesWhyACornerIsNotRounded) {
  EXPECT_EQ(round_corner(line({0, 0}, {10, 0}), line({10, 0}, {20, 0}), 1).fault, CornerFault::smooth);
  EXPECT_EQ(round_corner(line({0, 0}, {10, 0}), line({10, 0}, {0, 0}), 1).fault, CornerFault::reversal);
  EXPECT_EQ(round_corner(line({0, 0}, {0, 0}), line({0, 0}, {1, 0}), 1).fault, CornerFault::reversal);
  // An arc between one and the same point would be a full circle.
  EXPECT_EQ(round_corner(line({0, 0}, {10, 0}), line({10, 0}, {10, 4}), 1e-12).fault, CornerFault::smooth);
  EXPECT_EQ(round_corner(line({0, 0}, {10, 0}), line({10, 0}, {10, 4}), 5).fault, CornerFault::too_large);
  EXPECT_EQ(round_corner(line({0, 0}, {10, 0}), arc({10, 0}, {0, 10}, {0, 0}, 1), 11).fault,
            CornerFault::too_large);
}

TEST(CornerRounding, ChamferCutsItsSideOffBothLines) {
  const PlaneCorner piece = chamfer_corner(line({0, 0}, {10, 0}), line({10, 0}, {10, 10}), 2);
  ASSERT_EQ(piece.fault, CornerFault::none);
  expect_near(piece.from, {8, 0});
  expect_near(piece.to, {10, 2});
  EXPECT_EQ(piece.turn, 0);
  EXPECT_EQ(chamfer_corner(line({0, 0}, {1, 0}), line({1, 0}, {1, 9}), 2).fault, CornerFault::too_large);
  EXPECT_EQ(chamfer_corner(line({0, 0}, {10, 0}), arc({10, 0}, {0, 10}, {0, 0}, 1), 1).fault,
            CornerFault::not_lines);
}

// Whatever the curves, the arc put in touches both: its radius stands across their tangents.
TEST(CornerRounding, RandomCornersAreTouchedByTheRounding) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(-50, 50);
  std::uniform_real_distribution<double> sizes(0.1, 8);
  int rounded = 0;
  for (int round = 0; round < 5000; ++round) {
    const auto curve = [&](const Vec2& corner, bool ends_there) {
      const Vec2 other(number(random), number(random));
      if (random() % 2 == 0) {
        return ends_there ? line(other, corner) : line(corner, other);
      }
      const Vec2 center(number(random), number(random));
      const Vec2 on_circle = center + turned(corner - center, number(random));
      const int turn = random() % 2 == 0 ? 1 : -1;
      return ends_there ? arc(on_circle, corner, center, turn) : arc(corner, on_circle, center, turn);
    };
    const Vec2 corner(number(random), number(random));
    const PlaneElement first = curve(corner, true);
    const PlaneElement second = curve(corner, false);
    const double radius = sizes(random);
    const PlaneCorner piece = round_corner(first, second, radius);
    if (piece.fault != CornerFault::none) {
      continue;
    }
    ++rounded;
    const auto tangent = [](const PlaneElement& c, const Vec2& at) {
      return c.turn == 0 ? c.tangent_at_end() : Vec2(c.turn * left_of(at - c.center) / c.radius);
    };
    const PlaneElement put_in = arc(piece.from, piece.to, piece.center, piece.turn);
    ASSERT_NEAR((piece.from - piece.center).norm(), radius, 1e-9) << round;
    ASSERT_NEAR((piece.to - piece.center).norm(), radius, 1e-9) << round;
    ASSERT_NEAR(tangent(first, piece.from).dot(put_in.tangent_at_start()), 1, 1e-9) << round;
    ASSERT_NEAR(tangent(second, piece.to).dot(put_in.tangent_at_end()), 1, 1e-9) << round;
  }
  EXPECT_GT(rounded, 1000);
}

// The contour begins at the origin along +X; the tool comes from far away.
TEST(Approach, ReachesTheContourTangentOrNormalToIt) {
  const Vec2 along(1, 0);
  const Vec2 from(-40, 30);
  const auto path = [&](ApproachShape shape) { return *approach_path(shape, from, {0, 0}, along); };
  expect_near(path({.kind = ApproachKind::tangent_line, .length = 5}).point, {-5, 0});
  expect_near(path({.kind = ApproachKind::normal_line, .length = 5, .side = 1}).point, {0, 5});
  expect_near(path({.kind = ApproachKind::normal_line, .length = 5, .side = -1}).point, {0, -5});
  const ApproachPath half = path({.kind = ApproachKind::arc, .radius = 4, .angle = units::pi, .side = -1});
  expect_near(half.point, {0, -8});
  EXPECT_EQ(half.turn, -1);
  const ApproachPath other =
      path({.kind = ApproachKind::arc, .radius = -4, .angle = units::pi / 2, .side = -1});
  expect_near(other.center, {0, 4});
  expect_near(other.point, {-4, 4});
  EXPECT_EQ(other.turn, 1);
}

TEST(Approach, LineAndArcHaveOneTangent) {
  for (const int side : {1, -1}) {
    const ApproachShape shape{.kind = ApproachKind::line_and_arc, .radius = 4, .side = side};
    const Vec2 from(-30, 20 * side);
    const ApproachPath path = *approach_path(shape, from, {0, 0}, {1, 0});
    const PlaneElement last = arc(path.point, {0, 0}, path.center, path.turn);
    expect_near(last.tangent_at_end(), {1, 0});
    expect_near(last.tangent_at_start(), (path.point - from).normalized());
    EXPECT_FALSE(approach_path(shape, {0, 4.0 * side}, {0, 0}, {1, 0}));
  }
}

TEST(Approach, DepartureLeavesInTheDirectionOfTheContour) {
  for (const int side : {1, -1}) {
    const ApproachShape shape{.kind = ApproachKind::line_and_arc, .radius = 4, .side = side};
    const Vec2 to(30, 20 * side);
    const ApproachPath path = *departure_path(shape, {0, 0}, {1, 0}, to);
    const PlaneElement first = arc({0, 0}, path.point, path.center, path.turn);
    expect_near(first.tangent_at_start(), {1, 0});
    expect_near(first.tangent_at_end(), (to - path.point).normalized());
    const ApproachPath quarter = *departure_path(
        {.kind = ApproachKind::arc, .radius = 4, .angle = units::pi / 2, .side = side}, {0, 0}, {1, 0}, to);
    expect_near(quarter.point, {4, 4.0 * side});
    EXPECT_EQ(quarter.turn, side);
    expect_near(departure_path({.kind = ApproachKind::tangent_line, .length = 3}, {0, 0}, {1, 0}, to)->point,
                {3, 0});
  }
}

}  // namespace
}  // namespace feedscope

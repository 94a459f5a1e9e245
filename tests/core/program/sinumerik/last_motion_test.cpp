#include "core/program/sinumerik/geometry/last_motion.h"

#include <gtest/gtest.h>

#include "tests/core/program/sinumerik/part_bench.h"

namespace feedscope::sinumerik {
namespace {

struct SinumerikLastMotion : testing::Test {
  void expect_direction(const Vec3& expected) const {
    EXPECT_LT((last.direction(bench.path) - expected).norm(), 1e-12)
        << last.direction(bench.path).transpose() << " instead of " << expected.transpose();
  }

  PartBench bench;
  LastMotion last;
};

TEST_F(SinumerikLastMotion, HasNoDirectionBeforeTheFirstMotion) {
  bench.path.set_frame(CoordinateFrame::shift({5, 0, 0}));  // the position changes, the tool does not move
  expect_direction(Vec3::Zero());
}

TEST_F(SinumerikLastMotion, PointsAlongALine) {
  bench.path.line({3, 4, 0});
  expect_direction({0.6, 0.8, 0});
}

TEST_F(SinumerikLastMotion, IsTangentToTheEndOfAnArc) {
  // A quarter circle about X10 Y0 from the origin, clockwise: it ends upward at its left, rightward on top.
  ArcRequest arc;
  arc.target = {10, 10, 0};
  arc.center = {10, 0, 0};
  arc.axis = -Vec3::UnitZ();
  last.set_arc_by_center(arc);
  bench.path.arc_by_center(arc);
  expect_direction({1, 0, 0});
}

TEST_F(SinumerikLastMotion, IsTangentToTheLargerArcOfANegativeRadius) {
  // Three quarters of the circle about X0 Y10, clockwise: at X10 Y10 it goes downward.
  ArcRequest arc;
  arc.target = {10, 10, 0};
  arc.radius = -10;
  arc.axis = -Vec3::UnitZ();
  last.set_arc_by_radius(arc);
  bench.path.arc_by_radius(arc);
  expect_direction({0, -1, 0});
}

TEST_F(SinumerikLastMotion, PointsToTheEndOfAnArcThatCannotBeOne) {
  ArcRequest arc;
  arc.target = {10, 0, 0};
  arc.radius = 1;  // less than half the chord
  arc.axis = Vec3::UnitZ();
  last.set_arc_by_radius(arc);
  bench.path.arc_by_radius(arc);
  expect_direction({1, 0, 0});
}

}  // namespace
}  // namespace feedscope::sinumerik

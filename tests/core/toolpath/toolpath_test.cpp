#include "core/toolpath/toolpath.h"
#include "core/base/units.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iomanip>
#include <memory>
#include <sstream>
#include <string>

namespace feedscope {
namespace {

using units::pi;

Toolpath path_of(std::string text) {
  return build_toolpath(read_program(std::make_shared<const SourceText>("test.nc", std::move(text))));
}

TEST(Toolpath, KeepsProgrammedPointsFeedsAndLines) {
  const Toolpath path = path_of("G0 X1 Y2 Z3\nG1 X11 F600\nY5\n");
  ASSERT_EQ(path.segments.size(), 3U);
  EXPECT_TRUE(path.segments[0].rapid);
  EXPECT_EQ(path.segments[0].feed, 0);
  EXPECT_EQ(path.segments[1].end, Vec3(11, 2, 3));
  EXPECT_EQ(path.segments[1].length, 10);
  EXPECT_EQ(path.segments[1].feed, 10) << "600 mm/min";
  EXPECT_EQ(path.segments[2].line, 3U);
  EXPECT_EQ(path.start_of(2), Vec3(11, 2, 3));
  EXPECT_EQ(path.tangent_at_end(2), Vec3::UnitY());
  EXPECT_NEAR(path.length(), Vec3(1, 2, 3).norm() + 13, 1e-12);
}

TEST(Toolpath, BlocksThatDoNotMoveVanishButDwellsAndFullCirclesStay) {
  const Toolpath path = path_of("G1 X0 F100\nG91 X1\nX0\nG4 P1.5\nG2 I1\n");
  ASSERT_EQ(path.segments.size(), 3U);
  EXPECT_EQ(path.segments[1].kind, SegmentKind::dwell);
  EXPECT_EQ(path.dwell_of(path.segments[1]), 1.5);
  EXPECT_EQ(path.segments[1].length, 0);
  EXPECT_EQ(path.tangent_at_start(1), Vec3::Zero());
  EXPECT_NEAR(path.segments[2].length, 2 * pi, 1e-12);
}

TEST(Toolpath, ArcTangentsFollowTheTurn) {
  const Toolpath path = path_of("G0 X10 Y0\nG3 X0 Y10 I-10 F100\nG2 X10 Y0 J-10\n");
  ASSERT_EQ(path.arcs.size(), 2U);
  EXPECT_LT((path.tangent_at_start(1) - Vec3::UnitY()).norm(), 1e-12);
  EXPECT_LT((path.tangent_at_end(1) + Vec3::UnitX()).norm(), 1e-12);
  EXPECT_LT((path.tangent_at_start(2) - Vec3::UnitX()).norm(), 1e-12);
  EXPECT_LT((path.tangent_at_end(2) + Vec3::UnitY()).norm(), 1e-12);
}

TEST(Toolpath, ArcsOfAwkwardAnglesHaveTheirSweepAndMeetTheirEnds) {
  struct Plane {
    const char* word;
    Vec3 first;   ///< axis towards which angle zero points
    Vec3 second;  ///< axis at a quarter turn counter-clockwise
  };
  const Plane planes[] = {{"G17", Vec3::UnitX(), Vec3::UnitY()},
                          {"G18", Vec3::UnitZ(), Vec3::UnitX()},
                          {"G19", Vec3::UnitY(), Vec3::UnitZ()}};
  for (const Plane& plane : planes) {
    for (const double sweep :
         {1e-5, 0.1, pi / 2, pi - 1e-9, pi, pi + 1e-9, 1.5 * pi, 2 * pi - 1e-5, 2 * pi}) {
      for (const int turn : {1, -1}) {
        const Vec3 start = 10 * plane.first;
        const Vec3 end =
            10 * (std::cos(sweep) * plane.first + turn * std::sin(sweep) * plane.second) + Vec3::Ones();
        std::ostringstream text;
        text << std::fixed << std::setprecision(12) << plane.word << " G0 X" << start.x() + 1 << " Y"
             << start.y() + 1 << " Z" << start.z() + 1 << "\nG90.1 " << (turn > 0 ? "G3" : "G2") << " X"
             << end.x() << " Y" << end.y() << " Z" << end.z() << " I1 J1 K1 F100";
        const Toolpath path = path_of(text.str());
        ASSERT_EQ(path.arcs.size(), 1U) << text.str();
        const Arc& arc = path.arcs[0];
        EXPECT_NEAR(arc.sweep, sweep, 1e-9) << text.str();
        EXPECT_NEAR(arc.radius, 10, 1e-9) << text.str();
        EXPECT_LT((arc.at(0).position - path.start_of(1)).norm(), 1e-9) << text.str();
        EXPECT_LT((arc.at(arc.length()).position - path.segments[1].end).norm(), 1e-9) << text.str();
        EXPECT_LT((path.tangent_at_start(1) - turn * plane.second).norm(), 1e-9) << text.str();
      }
    }
  }
}

TEST(Toolpath, NearlyFullCircleRunsThroughItsEndsWithoutACorner) {
  const Toolpath path = path_of("G0 X50\nG2 X50.004 Y0.05 I-50 J0 F100\n");
  ASSERT_EQ(path.segments.size(), 3U);
  EXPECT_LT((path.tangent_at_end(1) - path.tangent_at_start(2)).norm(), 1e-9);
  EXPECT_NEAR(path.segments[1].length + path.segments[2].length, 100 * pi - 0.05, 0.02);
  EXPECT_LT((path.arcs[1].at(path.segments[2].length).position - Vec3(50.004, 0.05, 0)).norm(), 1e-9);
  EXPECT_EQ(path.segments[1].line, path.segments[2].line);
}

TEST(Toolpath, HelixOfManyTurnsRisesEvenly) {
  const Toolpath path = path_of("G0 X10\nG3 X10 Y0 Z6 I-10 P3 F100\n");
  const Arc& helix = path.arcs.at(0);
  EXPECT_NEAR(helix.sweep, 6 * pi, 1e-12);
  EXPECT_NEAR(helix.length(), 3 * std::hypot(20 * pi, 2), 1e-9);
  EXPECT_LT((helix.at(helix.length() / 3).position - Vec3(10, 0, 2)).norm(), 1e-9);
}

TEST(Toolpath, BoundsHoldArcsWithTheirFullExtent) {
  const Toolpath path = path_of("G0 X10 Y0 Z5\nG1 Z0 F100\nG3 X-10 I-10\n");
  EXPECT_LT((path.bounds.min - Vec3(-10, 0, 0)).norm(), 1e-12);
  EXPECT_LT((path.bounds.max - Vec3(10, 10, 5)).norm(), 1e-12);
}

TEST(Toolpath, OfNothingIsEmpty) {
  const Toolpath path = path_of("");
  EXPECT_TRUE(path.segments.empty());
  EXPECT_TRUE(path.bounds.empty());
  EXPECT_EQ(path.length(), 0);
}

}  // namespace
}  // namespace feedscope

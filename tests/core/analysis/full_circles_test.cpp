#include "core/analysis/circularity/full_circles.h"

#include <gtest/gtest.h>

#include <numbers>

#include "core/analysis/run/run.h"
#include "core/base/units.h"

namespace feedscope {
namespace {

FullCircles circles_in(const std::string& blocks) {
  const std::string text = "G21 G90 G17 G94\nG0 X0 Y0 Z0\n" + blocks + "M30\n";
  ReadOptions options;
  options.dialect = Dialect::fanuc;
  return find_full_circles(
      *load_program(std::make_shared<const SourceText>(SourceText("circles", text)), nullptr, options)
           .toolpath);
}

void expect_ten_about_zero(const FullCircles& found, bool counter_clockwise) {
  ASSERT_EQ(found.circles.size(), 1U);
  const FullCircle& circle = found.circles.front();
  EXPECT_NEAR(circle.radius, 10, 1e-9);
  EXPECT_NEAR(circle.center.norm(), 0, 1e-9);
  EXPECT_NEAR(circle.sweep, 2 * std::numbers::pi, 1e-9);
  EXPECT_NEAR(circle.start, 0, 1e-9);
  EXPECT_EQ(circle.counter_clockwise, counter_clockwise);
  EXPECT_EQ(circle.plane, CirclePlane::xy);
}

TEST(FullCircles, OneArcTwoHalvesAndFourQuartersAreOneCircle) {
  const FullCircles one = circles_in("G1 X10 F600\nG3 I-10\n");
  expect_ten_about_zero(one, true);
  EXPECT_EQ(one.circles[0].first_line, 4U);
  EXPECT_EQ(one.circles[0].last_line, 4U);
  EXPECT_NEAR(one.circles[0].feed, 10, 1e-12);
  const FullCircles halves = circles_in("G1 X10 F600\nG2 X-10 I-10\nG2 X10 I10\nG1 X0\n");
  expect_ten_about_zero(halves, false);
  EXPECT_EQ(halves.circles[0].last_line, 5U);
  expect_ten_about_zero(circles_in("G1 X10 F600\nG3 X0 Y10 I-10 J0\nG3 X-10 Y0 I0 J-10\n"
                                   "G3 X0 Y-10 I10 J0\nG3 X10 Y0 I0 J10\n"),
                        true);
}

TEST(FullCircles, PlanesAndDirectionsAreThoseOfTheWords) {
  const FullCircles zx = circles_in("G18\nG1 Z10 F600\nG3 K-10\nG2 K-10\n");
  ASSERT_EQ(zx.circles.size(), 2U);
  EXPECT_EQ(zx.circles[0].plane, CirclePlane::zx);
  EXPECT_TRUE(zx.circles[0].counter_clockwise);
  EXPECT_FALSE(zx.circles[1].counter_clockwise);
  EXPECT_NEAR(zx.circles[0].start, 0, 1e-12);
  EXPECT_TRUE(is_same_circle(zx.circles[0], zx.circles[1]));
  const FullCircles yz = circles_in("G19\nG1 Z10 F600\nG2 K-10\n");
  ASSERT_EQ(yz.circles.size(), 1U);
  EXPECT_EQ(yz.circles[0].plane, CirclePlane::yz);
  EXPECT_FALSE(yz.circles[0].counter_clockwise);
  EXPECT_NEAR(yz.circles[0].start, std::numbers::pi / 2, 1e-12);
}

TEST(FullCircles, TurnsInSequenceAreOneCutAndCutsApartAreSeveral) {
  const FullCircles twice = circles_in("G1 X10 F600\nG3 I-10\nG3 I-10\n");
  ASSERT_EQ(twice.circles.size(), 1U);
  EXPECT_NEAR(twice.circles[0].sweep, 4 * std::numbers::pi, 1e-9);
  EXPECT_EQ(circles_in("G1 X10 F600\nG3 I-10\nG4 P500\nG3 I-10\n").circles.size(), 2U);
  EXPECT_EQ(circles_in("G1 X10 F600\nG3 I-10\nG1 Z-1\nG3 I-10\n").circles.size(), 2U);
}

TEST(FullCircles, WhatIsNoWholeTurnAboutOneCentreIsNone) {
  EXPECT_TRUE(circles_in("G1 X10 F600\nG3 X0 Y-10 I-10\n").circles.empty());
  // A gap that a line closes, and halves about two centres.
  EXPECT_TRUE(circles_in("G1 X10 F600\nG3 X-10 I-10\nG1 Y-1\nG3 X10 Y-1 I10\n").circles.empty());
  EXPECT_TRUE(circles_in("G1 X10 F600\nG3 X-10 I-10\nG3 X12 I11\n").circles.empty());
  // A spiral of halves, and a circle of lines.
  EXPECT_TRUE(circles_in("G1 X10 F600\nG3 X-11 I-10.5\nG3 X12 I11.5\nG3 X-13 I-12.5\n").circles.empty());
  std::string lines = "G1 X10 F600\n";
  for (int i = 1; i <= 360; ++i) {
    const double a = units::from_deg(i);
    lines += "X" + std::to_string(10 * std::cos(a)) + " Y" + std::to_string(10 * std::sin(a)) + "\n";
  }
  EXPECT_TRUE(circles_in(lines).circles.empty());
}

TEST(FullCircles, RoundingsOfTheProgramDoNotPartACircle) {
  // Four decimals of an inch: centres of two quarters differ by up to two roundings.
  const FullCircles found = circles_in(
      "G20\nG1 X0.3937 F20\nG3 X0.2784 Y0.2784 I-0.3937 J0\nG3 X-0.3937 Y0 I-0.2784 J-0.2783\n"
      "G3 X0 Y-0.3937 I0.3937 J0\nG3 X0.3937 Y0 I0 J0.3937\n");
  ASSERT_EQ(found.circles.size(), 1U);
  EXPECT_NEAR(found.circles[0].radius, 10, 0.003);
  EXPECT_NEAR(found.circles[0].center.norm(), 0, 0.003);
}

TEST(FullCircles, HelicesAreCountedNotJudged) {
  const FullCircles found = circles_in("G1 X10 F600\nG3 I-10 Z-1\nG3 I-10 Z-2\nG3 I-10\n");
  EXPECT_EQ(found.helices, 1U);
  ASSERT_EQ(found.circles.size(), 1U);
  EXPECT_EQ(found.circles[0].first_line, 6U);
  EXPECT_NEAR(found.circles[0].center.z(), -2, 1e-12);
}

// By hand, since no control of the readers tilts arcs without a frame.
TEST(FullCircles, TiltedOnesAreCountedNotJudged) {
  Toolpath path;
  Arc arc;
  arc.center = Vec3::Zero();
  arc.x = Vec3::UnitX();
  arc.y = Vec3(0, 1, 1).normalized();
  arc.rise = Vec3::Zero();
  arc.radius = 10;
  arc.sweep = 2 * std::numbers::pi;
  path.arcs.push_back(arc);
  Segment segment;
  segment.kind = SegmentKind::arc;
  segment.index = 0;
  segment.end = 10 * arc.x;
  segment.length = arc.length();
  segment.feed = 10;
  path.segments.push_back(segment);
  const FullCircles found = find_full_circles(path);
  EXPECT_TRUE(found.circles.empty());
  EXPECT_EQ(found.tilted, 1U);
}

TEST(FullCircles, SameCircleNeedsTheSameFeedAndDepth) {
  const FullCircles found = circles_in("G1 X10 F600\nG3 I-10\nG2 I-10\nG2 I-10 F700\nG1 Z-1\nG3 I-10\n");
  ASSERT_EQ(found.circles.size(), 3U);  // both clockwise turns are one cut
  EXPECT_FALSE(is_same_circle(found.circles[0], found.circles[1]));
  EXPECT_FALSE(is_same_circle(found.circles[0], found.circles[2]));
}

}  // namespace
}  // namespace feedscope

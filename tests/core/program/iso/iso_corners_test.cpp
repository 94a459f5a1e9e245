// ",R" and ",C" of Fanuc: corners rounded and chamfered.
#include <gmock/gmock.h>

#include <random>

#include "tests/core/program/iso/iso_text.h"
#include "tests/core/program/motion_text.h"

namespace feedscope {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

ReadProgram clean(const std::string& text) {
  return read_clean_as(Dialect::fanuc, text);
}

void expect_near(const Vec3& actual, const Vec3& expected) {
  EXPECT_LT((actual - expected).norm(), 1e-9) << actual.transpose() << " instead of " << expected.transpose();
}

TEST(IsoCorners, ARightAngleBecomesAQuarterCircle) {
  const ReadProgram program = clean("G0 X0 Y0\nG1 X10 F600 ,R2\nY10 F300\n");
  EXPECT_THAT(text_of(program),
              ElementsAre("rapid 0 0 0 @1", "line 8 0 0 @2", "arc 10 2 0 @2", "line 10 10 0 @3"));
  ASSERT_EQ(program.arcs.size(), 1U);
  expect_near(program.arcs[0].center, {8, 2, 0});
  expect_near(program.arcs[0].axis, Vec3::UnitZ());
  EXPECT_EQ(program.arcs[0].turns, 0);
  EXPECT_NEAR(program.motions[2].feed, 10, 1e-12);
  EXPECT_NEAR(program.motions[3].feed, 5, 1e-12);
}

TEST(IsoCorners, AChamferTakesItsSizeOffBothSides) {
  EXPECT_THAT(
      text_of(clean("G0 X0 Y0\nG1 X10 F600 ,C3\nX20 Y10\n")),
      ElementsAre("rapid 0 0 0 @1", "line 7 0 0 @2", "line 12.12132 2.12132 0 @2", "line 20 10 0 @3"));
}

TEST(IsoCorners, CornersFollowEachOtherAndWordsMayHaveValues) {
  EXPECT_THAT(text_of(clean("#1=2\nG0 X0 Y0\nG1 X10 F600 ,R#1\nY10 ,C[#1+1]\nX0\n")),
              ElementsAre("rapid 0 0 0 @2", "line 8 0 0 @3", "arc 10 2 0 @3", "line 10 7 0 @4",
                          "line 7 10 0 @4", "line 0 10 0 @5"));
}

// The arc about X10 Y0 from X0 to X20 by the top, cut where it meets the line down.
TEST(IsoCorners, LinesAndArcsAreJoinedWithOneTangent) {
  const ReadProgram program = clean("G0 X0 Y0\nG2 X20 I10 F600 ,R1\nG1 X30\n");
  ASSERT_EQ(program.motions.size(), 4U);
  ASSERT_EQ(program.arcs.size(), 2U);
  const ArcWords& given = program.arcs[0];
  const ArcWords& rounding = program.arcs[1];
  // Outside the circle of 10 by 1 and 1 above the line.
  expect_near(rounding.center, {10 + std::sqrt(120.0), 1, 0});
  expect_near(rounding.axis, Vec3::UnitZ());
  const Vec3 from = program.motions[1].target;
  EXPECT_NEAR((from - given.center).norm(), 10, 1e-9);
  EXPECT_NEAR((from - rounding.center).norm(), 1, 1e-9);
  expect_near(program.motions[2].target, {10 + std::sqrt(120.0), 0, 0});
  EXPECT_EQ(given.turns, 0);
}

TEST(IsoCorners, AFullCircleThatLosesItsEndIsNoFullCircleAnyMore) {
  const ReadProgram program = clean("G0 X0 Y0\nG2 I10 F600 ,R1\nG1 Y0 X-10\n");
  ASSERT_EQ(program.arcs.size(), 2U);
  EXPECT_EQ(program.arcs[0].turns, 0);
  EXPECT_GT(program.motions[1].target.y(), -3);
  EXPECT_LT(program.motions[1].target.y(), 0);
}

TEST(IsoCorners, ScaleAndPlaneCount) {
  const ReadProgram scaled = clean("G0 X0 Y0\nG51 X0 Y0 P2000\nG1 X10 F600 ,R2\nY10\n");
  expect_near(scaled.motions.at(1).target, {16, 0, 0});
  const ReadProgram in_zx = clean("G18 G0 X0 Z0\nG1 X10 F600 ,R2\nZ10\n");
  expect_near(in_zx.motions.at(2).target, {10, 0, 2});
  expect_near(in_zx.arcs.at(0).axis, -Vec3::UnitY());
}

TEST(IsoCorners, TheToolsPathIsThatBesideTheRoundedContour) {
  const ReadProgram program =
      clean("G10 L12 P1 R1\nG0 X0 Y-5\nG1 G41 D1 Y0 F600\nY20 ,R4\nX20\nG40 G0 X30\n");
  // Around the outside the tool's radius is added.
  ASSERT_EQ(program.arcs.size(), 1U);
  const Vec3 center = program.arcs[0].center;
  expect_near(center, {4, 16, 0});
  std::size_t arc = 0;
  while (program.motions[arc].motion != Motion::arc) {
    ++arc;
  }
  EXPECT_NEAR((program.motions[arc].target - center).norm(), 5, 1e-9);
  EXPECT_NEAR((program.motions[arc - 1].target - center).norm(), 5, 1e-9);
}

TEST(IsoCorners, RandomContoursHaveNoCornerLeft) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(-100, 100);
  int rounded = 0;
  for (int round = 0; round < 300; ++round) {
    std::string text = "G0 X0 Y0\nF600\n";
    for (int i = 0; i < 12; ++i) {
      text += fmt::format("G1 X{:.6f} Y{:.6f} ,R{:.3f}\n", number(random), number(random), 0.1);
    }
    const ReadProgram program = read_as(Dialect::fanuc, text + "G1 X200\n");
    for (std::size_t i = 2; i + 1 < program.motions.size(); ++i) {
      if (program.motions[i].motion != Motion::arc) {
        continue;
      }
      const ArcWords& arc = program.arcs.at(static_cast<std::size_t>(program.motions[i].arc));
      const auto along = [&](std::size_t line) -> Vec3 {
        return (program.motions[line].target - program.motions[line - 1].target).normalized();
      };
      const auto tangent = [&](const Vec3& at) -> Vec3 {
        return arc.axis.cross(at - arc.center).normalized();
      };
      ASSERT_LT((tangent(program.motions[i - 1].target) - along(i - 1)).norm(), 1e-6) << text;
      ASSERT_LT((tangent(program.motions[i].target) - along(i + 1)).norm(), 1e-6) << text;
      ASSERT_NEAR((program.motions[i].target - arc.center).norm(), 0.1, 1e-9) << text;
      ++rounded;
    }
  }
  EXPECT_GT(rounded, 3000);
}

TEST(IsoCorners, WhatCannotBeCutStaysSharpAndIsSaid) {
  const std::string start = "G0 X0 Y0\nG1 F600 ";
  EXPECT_THAT(said_of(Dialect::fanuc, start + "X10 ,R20\nY10\n"), HasSubstr("does not fit"));
  EXPECT_THAT(said_of(Dialect::fanuc, start + "X10 ,R2\nZ10\n"), HasSubstr("working plane"));
  EXPECT_THAT(said_of(Dialect::fanuc, start + "X10 ,R2\nG0 Y10\n"), HasSubstr("it is adjacent to a rapid"));
  EXPECT_THAT(said_of(Dialect::fanuc, start + "X10 ,R2\nX0\n"), HasSubstr("turns back"));
  EXPECT_THAT(said_of(Dialect::fanuc, start + "X10 ,R2\nM30\n"), HasSubstr("no line or arc follows"));
  EXPECT_THAT(said_of(Dialect::fanuc, start + "X10 ,R0\nY10\n"), HasSubstr("not above zero"));
  EXPECT_THAT(said_of(Dialect::fanuc, start + "X10\nM8 ,R2\nY10\n"), HasSubstr("not a line or an arc"));
  EXPECT_THAT(said_of(Dialect::fanuc, start + "X10 ,C2\nG2 X20 I5\n"), HasSubstr("adjacent to an arc"));
  EXPECT_THAT(said_of(Dialect::fanuc, start + "X10 ,A2\n"), HasSubstr("[unknown-character]"));
  EXPECT_THAT(said_of(Dialect::linuxcnc, start + "X10 ,R2\n"), HasSubstr("[unknown-character]"));
}

}  // namespace
}  // namespace feedscope

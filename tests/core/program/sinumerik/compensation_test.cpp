#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/base/units.h"
#include "tests/core/program/sinumerik/read_sinumerik.h"

namespace feedscope {
namespace {

TEST(SinumerikCompensation, ToolRunsBesideASquareByTheRadiusThatTheProgramSets) {
  const ReadProgram program =
      read_clean("$TC_DP6[3,1]=2\nT3 D1 F100\nG0 X-10 Y0\nG1 G41 X0 Y0\nY20\nX20\nY0\nX0\nG40 X0 Y-10");
  Bounds bounds;
  for (const MotionBlock& block : program.motions) {
    if (block.line >= 5 && block.line <= 8) {
      bounds.add(block.target);
    }
  }
  EXPECT_NEAR(bounds.min.x(), -2, 1e-9);
  EXPECT_NEAR(bounds.max.x(), 22, 1e-9);
  EXPECT_NEAR(bounds.max.y(), 22, 1e-9);
  expect_near(program.motions.back().target, {0, -10, 0});
}

TEST(SinumerikCompensation, CornersAreArcsOrLines) {
  const std::string path = "$TC_DP6[3,1]=2\nT3 D1 F100\nG0 X-10 Y0\nG1 G41 X0 Y0\nY20\nX20\nG40 X30";
  EXPECT_EQ(read_clean(path).arcs.size(), 1U);
  EXPECT_EQ(read_clean("G451\n" + path).arcs.size(), 0U);
  EXPECT_EQ(read_clean("G451\nG450\n" + path).arcs.size(), 1U);
}

/// The way of the centre past a corner at (0, 60) at which the contour, coming up along X = 0, turns right by
/// `turn` [deg]; a tool of radius 5 on its left.
ReadProgram around_corner(double turn) {
  const double angle = units::from_deg(turn);
  return read_clean(fmt::format(
      "$TC_DP6[1,1]=5\nT1 D1 F600\nG0 X-20 Y-20\nG451 G1 G41 X0 Y0\nY60\nX{:.12f} Y{:.12f}\nG40 X90",
      40 * std::sin(angle), 60 + 40 * std::cos(angle)));
}

/// The paths beside two lines meet r tan(turn / 2) beyond the corner.
TEST(SinumerikCompensation, G451GoesOnToWhereThePathsMeetUpToATurnOf100Degrees) {
  for (const double turn : {1.0, 30.0, 89.0, 90.0, 91.0, 95.0, 100.0}) {
    SCOPED_TRACE(turn);
    const ReadProgram program = around_corner(turn);
    EXPECT_TRUE(program.arcs.empty());
    EXPECT_NEAR(program.motions[2].target.x(), -5, 1e-9);
    EXPECT_NEAR(program.motions[2].target.y(), 60 + 5 * std::tan(units::from_deg(turn) / 2), 1e-9);
    EXPECT_EQ(program.motions.size(), 5U);
  }
}

TEST(SinumerikCompensation, G451IsG450AboveATurnOf100Degrees) {
  for (const double turn : {100.1, 135.0, 170.0}) {
    SCOPED_TRACE(turn);
    const ReadProgram program = around_corner(turn);
    ASSERT_EQ(program.arcs.size(), 1U);
    EXPECT_NEAR((program.arcs[0].center - Vec3(0, 60, 0)).norm(), 0, 1e-9);
    EXPECT_NEAR(program.motions[2].target.y(), 60, 1e-9);
  }
}

TEST(SinumerikCompensation, EdgeZeroAndToolsWithoutRadiusShowTheContour) {
  const ReadProgram none = read_clean("$TC_DP6[3,1]=2\nT3 F100\nG1 G42 D0 X10\nY10\nG40 X0");
  expect_near(none.motions[1].target, {10, 10, 0});
  const ReadProgram unknown = read_sinumerik("T3 D2 F100\nG1 G42 X10\nY10\nG40 X0");
  expect_near(unknown.motions[1].target, {10, 10, 0});
  ASSERT_EQ(unknown.diagnostics.size(), 1U);
  EXPECT_EQ(
      format(unknown.diagnostics[0], "f"),
      "f:2:4: error: G42: the radius of T3 D2 is not known [tool-radius] (the path shown is the "
      "programmed contour; give it as an import option (--tool 3,2=RADIUS) or in a tool table, or say that "
      "the path is already compensated (--wear-only), or set it with $TC_DP6[T,D]=)");
}

}  // namespace
}  // namespace feedscope

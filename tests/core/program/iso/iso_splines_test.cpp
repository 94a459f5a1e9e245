#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "tests/core/program/iso/iso_text.h"
#include "tests/core/program/motion_text.h"

namespace feedscope {
namespace {

/// Reads a program of which only "curve-as-lines" is said.
Program curve(const std::string& text) {
  Program program = read_as(Dialect::linuxcnc, text);
  EXPECT_FALSE(program.diagnostics.empty()) << text;
  for (const Diagnostic& diagnostic : program.diagnostics) {
    EXPECT_EQ(diagnostic.code, "curve-as-lines") << format(diagnostic, "f");
  }
  return program;
}

TEST(IsoSplines, ACubicWithItsPointsOnALineIsThatLine) {
  const Program program = curve("G5 I10 J10 P-10 Q-10 X30 Y30 Z3 F60");
  EXPECT_EQ(program.motions.back().target, Vec3(30, 30, 3));
  for (const MotionBlock& block : program.motions) {
    EXPECT_EQ(block.motion, Motion::line);
    EXPECT_EQ(block.feed, 1);
    EXPECT_NEAR(block.target.x(), block.target.y(), 1e-12);
    EXPECT_NEAR(block.target.z(), block.target.x() / 10, 1e-12) << "Z rises evenly";
  }
}

TEST(IsoSplines, ACubicGoesThroughItsMiddle) {
  // At half of the parameter: (P0 + 3 P1 + 3 P2 + P3) / 8.
  const Program program = curve("G0 X10 Y20\nG5 I5 J20 P-5 Q20 X40 Y20 F60");
  double highest = 0;
  for (const MotionBlock& block : program.motions) {
    highest = std::max(highest, block.target.y());
  }
  EXPECT_NEAR(highest, (20 + 3 * 40 + 3 * 40 + 20) / 8.0, 1e-12);
}

TEST(IsoSplines, ACubicGoesOnWhereTheLastOnePointed) {
  const Program program = curve("G5 I0 J10 P-10 Q0 X20 Y20 F60\nP0 Q10 X40 Y0");
  std::size_t second = 0;
  while (program.motions[second].line == 1) {
    ++second;
  }
  const Vec3 first = program.motions[second].target - program.motions[second - 1].target;
  EXPECT_LT(std::abs(first.y()), 0.05 * first.x()) << "on along X";
}

TEST(IsoSplines, AQuadraticIsAParabola) {
  const Program program = curve("G0 X-2 Y4\nG5.1 I2 J-8 X2 Y4 F60");
  EXPECT_GT(program.motions.size(), 20U);
  for (std::size_t i = 1; i < program.motions.size(); ++i) {
    const Vec3& start = program.motions[i - 1].target;
    const Vec3& end = program.motions[i].target;
    EXPECT_NEAR(end.y(), end.x() * end.x(), 1e-12);
    const double sag = (end.x() - start.x()) * (end.x() - start.x()) / 4;
    const double slope = (end.y() - start.y()) / (end.x() - start.x());
    EXPECT_LE(sag / std::hypot(1, slope), 1e-3 + 1e-9) << "the largest distance of a parabola from its chord";
  }
}

TEST(IsoSplines, NurbsMakeAnExactQuarterCircle) {
  const Program program =
      curve("G0 X10 Y0\nG1 F60\nG5.2 X10 Y10 P0.70710678118654752 L3\nX0 Y10 P1\nG5.3\nG0 X0");
  EXPECT_GT(program.motions.size(), 20U);
  for (const MotionBlock& block : program.motions) {
    EXPECT_NEAR(block.target.norm(), 10, 1e-9);
  }
  EXPECT_EQ(program.motions.back().target, Vec3(0, 10, 0));
  EXPECT_EQ(program.motions[1].line, 4U) << "the block of the point that ends the span";
}

TEST(IsoSplines, NurbsOfManyPointsBeginAndEndOnThem) {
  const Program program =
      curve("G1 F60\nG5.2 P1 L4\nX0 Y1 P1\nX2 Y2 P1\nX2 Y0 P1\nX0 Y0 P2\nX-3 Y1 P1\nG5.3");
  EXPECT_EQ(program.motions.back().target, Vec3(-3, 1, 0));
  double longest = 0;
  Vec3 last = Vec3::Zero();
  for (const MotionBlock& block : program.motions) {
    longest = std::max(longest, (block.target - last).norm());
    last = block.target;
  }
  EXPECT_LT(longest, 1) << "no jump between the spans";
}

TEST(IsoSplines, IncrementalPointsAddUp) {
  EXPECT_EQ(curve("G1 X5 F60\nG91 G5.2 X1 Y1 P1\nX1 Y1 P1\nG5.3").motions.back().target, Vec3(7, 2, 0));
}

TEST(IsoSplines, InverseTimeIsThatOfTheWholeCurve) {
  const Program program = curve("G93 G5 I10 J0 P-10 Q0 X30 Y0 F60");
  double time = 0;
  Vec3 last = Vec3::Zero();
  for (const MotionBlock& block : program.motions) {
    time += (block.target - last).norm() / block.feed;
    last = block.target;
  }
  EXPECT_NEAR(time, 1, 1e-9);
}

struct FaultCase {
  const char* text;
  const char* expected;
};

class IsoSplineFault : public testing::TestWithParam<FaultCase> {};

TEST_P(IsoSplineFault, NamesTheWord) {
  const Program program = read_as(Dialect::linuxcnc, GetParam().text);
  ASSERT_FALSE(program.diagnostics.empty());
  EXPECT_EQ(format(program.diagnostics[0], "f"), GetParam().expected);
  EXPECT_EQ(program.motions.back().target, Vec3(9, 0, 0)) << "the position goes on";
}

INSTANTIATE_TEST_SUITE_P(
    All, IsoSplineFault,
    testing::Values(
        FaultCase{
            "G5 I1 J1 X9 F60",
            "f:1:10: error: G5 without P and Q [spline-words] (a straight line to the end is taken instead)"},
        FaultCase{
            "G5 P1 Q1 X9 F60",
            "f:1:10: error: G5 without I and J [spline-words] (a straight line to the end is taken instead)"},
        FaultCase{"G5.1 X9 F60",
                  "f:1:6: error: G5.1 without I and J [spline-words] (a straight line to the end is taken "
                  "instead)"},
        FaultCase{"G0 X9\nG5.3",
                  "f:2:1: error: G5.3 without a G5.2 before it [spline-words] (it is left out)"},
        FaultCase{
            "F60\nG5.2 X1 Y1 P-1\nX9 Y0 P1\nG5.3",
            "f:2:12: error: a control point of G5.2 without a weight above zero [spline-words] (1 is taken; "
            "write P with the weight)"},
        FaultCase{
            "F60\nG5.2 X9 Y0 P1\nG5.3",
            "f:3: error: G5.2 with 2 control points is too short for order 3 [spline-words] (a straight line "
            "to the last one is taken instead)"},
        FaultCase{"F60\nG5.2 X1 Y1 P1 L9\nX9 Y0 P1\nG5.3",
                  "f:2:15: error: order L9 of G5.2 is above 8 [spline-words] (8 is taken)"},
        FaultCase{
            "F60\nG5.2 X1 Y1 P1\nX9 Y0 P1\n",
            "f:3: error: G5.2 in line 2 is not closed by G5.3 [spline-words] (the curve ends at its last "
            "control point)"}));

}  // namespace
}  // namespace feedscope

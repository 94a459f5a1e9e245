#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/toolpath/toolpath.h"
#include "tests/core/program/iso/iso_text.h"
#include "tests/core/program/motion_text.h"

namespace feedscope {
namespace {

/// Reads a program of which only "curve-as-arcs" is said.
ReadProgram curve(const std::string& text) {
  ReadProgram program = read_as(Dialect::linuxcnc, text);
  EXPECT_FALSE(program.diagnostics.empty()) << text;
  for (const Diagnostic& diagnostic : program.diagnostics) {
    EXPECT_EQ(diagnostic.code, "curve-as-arcs") << format(diagnostic, "f");
  }
  return program;
}

/// Unit, at the end of motion `i`.
Vec3 direction_at_end(const ReadProgram& program, std::size_t i) {
  const MotionBlock& block = program.motions[i];
  if (block.motion == Motion::arc) {
    const ArcWords& arc = program.arcs.at(static_cast<std::size_t>(block.arc));
    return arc.axis.cross(block.target - arc.center).normalized();
  }
  return (block.target - (i > 0 ? program.motions[i - 1].target : Vec3(Vec3::Zero()))).normalized();
}

TEST(IsoSplines, ACubicWithItsPointsOnALineIsThatLine) {
  const ReadProgram program = curve("G5 I10 J10 P-10 Q-10 X30 Y30 Z3 F60");
  EXPECT_EQ(text_of(program), (Lines{"line 30 30 3 @1"}));
  EXPECT_EQ(program.motions.back().feed, 1);
}

TEST(IsoSplines, ACubicGoesThroughItsMiddle) {
  // At half of the parameter: (P0 + 3 P1 + 3 P2 + P3) / 8; there it is level, so that an arc is highest
  // there.
  const ReadProgram program = curve("G0 X10 Y20\nG5 I5 J20 P-5 Q20 X40 Y20 F60");
  EXPECT_NEAR(build_toolpath(program).bounds.max.y(), (20 + 3 * 40 + 3 * 40 + 20) / 8.0, 1e-9);
}

TEST(IsoSplines, ACubicGoesOnWhereTheLastOnePointed) {
  const ReadProgram program = curve("G5 I0 J10 P-10 Q0 X20 Y20 F60\nP0 Q10 X40 Y0");
  std::size_t second = 0;
  while (program.motions[second].line == 1) {
    ++second;
  }
  EXPECT_NEAR((direction_at_end(program, second - 1) - Vec3(1, 0, 0)).norm(), 0, 1e-9);
  const ArcWords& arc = program.arcs.at(static_cast<std::size_t>(program.motions[second].arc));
  const Vec3 leaves = arc.axis.cross(program.motions[second - 1].target - arc.center).normalized();
  EXPECT_NEAR((leaves - Vec3(1, 0, 0)).norm(), 0, 1e-9) << "on along X";
}

TEST(IsoSplines, AQuadraticIsAParabola) {
  const ReadProgram program = curve("G0 X-2 Y4\nG5.1 I2 J-8 X2 Y4 F60");
  EXPECT_GT(program.motions.size(), 8U);
  for (const MotionBlock& block : program.motions) {
    const double slope = 2 * block.target.x();
    EXPECT_LE(std::abs(block.target.y() - block.target.x() * block.target.x()) / std::hypot(1, slope), 1e-3);
  }
  EXPECT_NEAR((direction_at_end(program, program.motions.size() - 1) - Vec3(1, 4, 0).normalized()).norm(), 0,
              1e-9);
}

TEST(IsoSplines, NurbsMakeAnExactQuarterCircle) {
  const ReadProgram program =
      curve("G0 X10 Y0\nG1 F60\nG5.2 X10 Y10 P0.70710678118654752 L3\nX0 Y10 P1\nG5.3\nG0 X0");
  ASSERT_EQ(program.arcs.size(), 2U);
  for (const ArcWords& arc : program.arcs) {
    EXPECT_NEAR(arc.center.norm(), 0, 1e-9);
  }
  EXPECT_EQ(program.motions.back().target, Vec3(0, 10, 0));
  EXPECT_EQ(program.motions[1].line, 4U) << "the block of the point that ends the span";
}

TEST(IsoSplines, NurbsOfManyPointsBeginAndEndOnThem) {
  const ReadProgram program =
      curve("G1 F60\nG5.2 P1 L4\nX0 Y1 P1\nX2 Y2 P1\nX2 Y0 P1\nX0 Y0 P2\nX-3 Y1 P1\nG5.3");
  EXPECT_EQ(program.motions.back().target, Vec3(-3, 1, 0));
  const Toolpath path = build_toolpath(program);
  for (std::size_t i = 1; i < path.segments.size(); ++i) {
    EXPECT_LT((path.tangent_at_end(i - 1) - path.tangent_at_start(i)).norm(), 1e-6)
        << "no corner between the spans either";
  }
}

TEST(IsoSplines, AreArcsInATurnedMirroredAndEvenlyScaledFrameAndExactInAnUnevenOne) {
  const std::string g5 = "G5 I5 J20 P-5 Q20 X40 Y10 F60";
  const ReadProgram plain = curve(g5);
  const ReadProgram turned = read_as(Dialect::fanuc, "G68 X0 Y0 R90\nG5.1 X2 Y4 I1 J0 F60");
  EXPECT_GT(turned.arcs.size(), 3U);
  EXPECT_NEAR((turned.motions.back().target - Vec3(-4, 2, 0)).norm(), 0, 1e-12);
  EXPECT_NEAR((direction_at_end(turned, turned.motions.size() - 1) - Vec3(-4, 1, 0).normalized()).norm(), 0,
              1e-9)
      << "turned by a quarter";
  const ReadProgram uneven = read_as(Dialect::fanuc, "G51 X0 Y0 Z0 I1. J3. K1.\nG5.1 X2 Y4 I1 J0 F60");
  EXPECT_GT(uneven.arcs.size(), 3U);
  for (const MotionBlock& block : uneven.motions) {
    const double x = block.target.x();
    EXPECT_LE(std::abs(block.target.y() - 3 * x * x) / std::hypot(1, 6 * x), 1e-3);
  }
  EXPECT_GT(plain.arcs.size(), 3U);
}

TEST(IsoSplines, BecomeLinesUnderCutterCompensation) {
  const ReadProgram program =
      read_as(Dialect::linuxcnc,
              "G10 L1 P1 R2\nT1 M6\nG1 X0 F60\nG41 D1 X10\nG5 I5 J20 P-5 Q20 X40 Y10\nG1 X60\nG40 X70");
  EXPECT_EQ(std::count_if(program.diagnostics.begin(), program.diagnostics.end(),
                          [](const Diagnostic& d) { return d.code == "curve-as-lines"; }),
            1);
  EXPECT_GT(program.motions.size(), 20U);
}

TEST(IsoSplines, IncrementalPointsAddUp) {
  EXPECT_EQ(curve("G1 X5 F60\nG91 G5.2 X1 Y1 P1\nX1 Y1 P1\nG5.3").motions.back().target, Vec3(7, 2, 0));
}

TEST(IsoSplines, InverseTimeIsThatOfTheWholeCurve) {
  const ReadProgram program = curve("G93 G5 I10 J0 P-10 Q0 X30 Y0 F60");
  double time = 0;
  for (const Segment& segment : build_toolpath(program).segments) {
    time += segment.length / segment.feed;
  }
  EXPECT_NEAR(time, 1, 1e-9);
}

TEST(FanucNurbs, MakeAnExactQuarterCircle) {
  const ReadProgram program = read_as(Dialect::fanuc,
                                      "G0 X10 Y0\nG6.2 P3 K0 X10 Y0 R1 F60\nK0 X10 Y10 R0.70710678118654752\n"
                                      "K0 X0 Y10 R1\nK1\nK1\nK1\nG1 X-5");
  ASSERT_EQ(program.diagnostics.size(), 1U);
  EXPECT_EQ(program.diagnostics[0].code, "curve-as-arcs");
  ASSERT_EQ(program.arcs.size(), 2U);
  for (const ArcWords& arc : program.arcs) {
    EXPECT_NEAR(arc.center.norm(), 0, 1e-9);
  }
  EXPECT_EQ(program.motions[2].target, Vec3(0, 10, 0));
  EXPECT_EQ(program.motions.back().target, Vec3(-5, 10, 0));
  EXPECT_EQ(program.motions.back().motion, Motion::line);
}

TEST(FanucNurbs, OfOrderFourIsABezierCurveInSpaceAndMayFollowAnother) {
  const std::string curve =
      "G6.2 P4 K0 X0 Y0 Z0 F60\nK0 X0 Y10 Z1\nK0 X10 Y10 Z2\nK0 X10 Y0 Z3\nK1\nK1\nK1\nK1\n";
  const std::string next = "G6.2 K0 X10 Y0 Z3\nK0 X10 Y-10\nK0 X20 Y-10\nK0 X20 Y0\nK1\nK1\nK1\nK1\nM30";
  const ReadProgram program = read_as(Dialect::fanuc, curve + next);
  EXPECT_FALSE(has_errors(program.diagnostics));
  const Toolpath path = build_toolpath(program);
  double near_middle = 1e9;
  for (const MotionBlock& block : program.motions) {
    near_middle = std::min(near_middle, (block.target - Vec3(5, 7.5, 1.5)).norm());
  }
  EXPECT_LT(near_middle, 1e-6) << "(P0 + 3 P1 + 3 P2 + P3) / 8";
  EXPECT_EQ(program.motions.back().target, Vec3(20, 0, 3));
}

TEST(FanucNurbs, SayWhatDoesNotMakeACurve) {
  const ReadProgram program = read_as(Dialect::fanuc, "G6.2 P4 K0 X0 Y0 F60\nK0 X0 Y10\nK1 X10 Y10\nG0 X9");
  ASSERT_EQ(program.diagnostics.size(), 1U);
  EXPECT_EQ(
      format(program.diagnostics[0], "f"),
      "f:3: error: G6.2 of order 4 with 3 control points and 3 knots K [spline-words] (a straight line to "
      "the last point is used instead; write as many non-decreasing K as points and order together)");
  EXPECT_EQ(text_of(program), (Lines{"line 10 10 0 @3", "rapid 9 10 0 @4"}));
}

TEST(LinuxcncNurbs, OfG62IsSaidNotToBeSupported) {
  const ReadProgram program =
      read_as(Dialect::linuxcnc, "G0 X0 Y0\nG6.2 P1 Q1 X0 Y1 F60\nX2 Y2 P1\nX2 Y0 P1\nG0 X9 Y0");
  ASSERT_EQ(program.diagnostics.size(), 1U);
  EXPECT_EQ(format(program.diagnostics[0], "f"),
            "f:2:1: error: G6.2 as LinuxCNC has it (weights P, no knots K) is not supported [spline-words] "
            "(positions are skipped up to the next G0 to G3; write G5.2 and G5.3)");
  EXPECT_EQ(program.motions.size(), 2U);
  EXPECT_EQ(program.motions.back().target, Vec3(9, 0, 0));
}

struct FaultCase {
  const char* text;
  const char* expected;
};

class IsoSplineFault : public testing::TestWithParam<FaultCase> {};

TEST_P(IsoSplineFault, NamesTheWord) {
  const ReadProgram program = read_as(Dialect::linuxcnc, GetParam().text);
  ASSERT_FALSE(program.diagnostics.empty());
  EXPECT_EQ(format(program.diagnostics[0], "f"), GetParam().expected);
  EXPECT_EQ(program.motions.back().target, Vec3(9, 0, 0)) << "the position goes on";
}

INSTANTIATE_TEST_SUITE_P(
    All, IsoSplineFault,
    testing::Values(
        FaultCase{
            "G5 I1 J1 X9 F60",
            "f:1:10: error: G5 without P and Q [spline-words] (a straight line to its end is used instead)"},
        FaultCase{
            "G5 P1 Q1 X9 F60",
            "f:1:10: error: G5 without I and J [spline-words] (a straight line to its end is used instead)"},
        FaultCase{
            "G5.1 X9 F60",
            "f:1:6: error: G5.1 without I and J [spline-words] (a straight line to its end is used instead)"},
        FaultCase{"G0 X9\nG5.3", "f:2:1: error: G5.3 without G5.2 [spline-words] (it is skipped)"},
        FaultCase{"F60\nG5.2 X1 Y1 P-1\nX9 Y0 P1\nG5.3",
                  "f:2:12: error: a control point of G5.2 without a weight above zero [spline-words] (1 is "
                  "used; write P with the weight)"},
        FaultCase{"F60\nG5.2 X9 Y0 P1\nG5.3",
                  "f:3: error: G5.2 with 2 control points is too short for order 3 [spline-words] (a "
                  "straight line to the last one is used instead)"},
        FaultCase{"F60\nG5.2 X1 Y1 P1 L9\nX9 Y0 P1\nG5.3",
                  "f:2:15: error: order L9 of G5.2 is above 8 [spline-words] (8 is taken)"},
        FaultCase{
            "F60\nG5.2 X1 Y1 P1\nX9 Y0 P1\n",
            "f:3: error: G5.2 in line 2 is not closed by G5.3 [spline-words] (the curve ends at its last "
            "control point)"}));

}  // namespace
}  // namespace feedscope

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "tests/core/program/sinumerik/read_sinumerik.h"

namespace feedscope {
namespace {

/// Reads a program with curves; the one kind of info says that they are arcs now.
ReadProgram read_curve(const std::string& text) {
  ReadProgram program = read_sinumerik(text);
  EXPECT_FALSE(program.diagnostics.empty()) << text;
  for (const Diagnostic& diagnostic : program.diagnostics) {
    EXPECT_EQ(diagnostic.code, "curve-as-arcs") << text;
  }
  return program;
}

/// The greatest of `error` over the ends of lines and their middles.
template <typename Error>
double greatest(const ReadProgram& program, Error error) {
  double most = 0;
  Vec3 before = Vec3::Zero();
  for (const MotionBlock& block : program.motions) {
    most = std::max({most, std::abs(error(block.target)), std::abs(error((before + block.target) / 2))});
    before = block.target;
  }
  return most;
}

TEST(SinumerikSplines, PolynomialIsWithinAMicrometreOfItsFormula) {
  const ReadProgram program = read_curve("POLY PO[X]=(10,0) PO[Y]=(100,10,0) PL=10 F1000");
  EXPECT_GT(program.motions.size(), 10U);
  // X = p; Y = a1 p + 10 p^2, a1 = (100 - 1000) / 10.
  for (const MotionBlock& block : program.motions) {
    const double x = block.target.x();
    EXPECT_LE(std::abs(block.target.y() - 10 * x * x + 90 * x) / std::hypot(1, 20 * x - 90), 1e-3);
  }
  expect_near(program.motions.back().target, {10, 100, 0});
}

TEST(SinumerikSplines, ATangentialCircleGoesOnWhereAPolynomialPoints) {
  // Y = X^2 / 10 has the slope 2 at X10: the circle to a place straight on is a line.
  const ReadProgram program = read_curve("POLY PO[X]=(10) PO[Y]=(10,0.1,0) PL=10 F1000\nCT X12 Y14");
  EXPECT_EQ(program.motions.back().motion, Motion::line);
  expect_near(program.motions.back().target, {12, 14, 0});
}

TEST(SinumerikSplines, RationalBSplineOfThreePointsIsACircle) {
  // Weights 1, cos 45, 1 on a square corner: a quarter circle about (0, 0).
  const ReadProgram program =
      read_curve("G0 X10\nBSPLINE SD=2 X10 Y10 PW=SQRT(2)/2 F1000\nX0 Y10 PW=1\nG1 X-5");
  for (std::size_t i = 0; i + 1 < program.motions.size(); ++i) {
    EXPECT_NEAR(program.motions[i].target.head<2>().norm(), 10, 1e-9);
  }
  expect_near(program.motions[program.motions.size() - 2].target, {0, 10, 0});
}

TEST(SinumerikSplines, CubicBSplineOfFourPointsIsTheBezierCurve) {
  const ReadProgram program = read_curve("BSPLINE X0 Y10 F1000\nX10 Y10\nX10 Y0");
  const auto near_middle = std::min_element(program.motions.begin(), program.motions.end(),
                                            [](const MotionBlock& a, const MotionBlock& b) {
                                              return std::abs(a.target.x() - 5) < std::abs(b.target.x() - 5);
                                            });
  expect_near(near_middle->target, {5, 7.5, 0});
  expect_near(program.motions.back().target, {10, 0, 0});
}

TEST(SinumerikSplines, CubicAndAkimaGoThroughTheirPointsOnTheirLines) {
  for (const char* const kind : {"ASPLINE", "CSPLINE"}) {
    const ReadProgram program =
        read_curve(std::string(kind) + " X10 Y5 F1000\nX20 Y0\nX30 Y5 Z2\nX40 Y0\nG1 X50");
    const std::vector<Vec3> points{{10, 5, 0}, {20, 0, 0}, {30, 5, 2}, {40, 0, 2}};
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto end = std::find_if(program.motions.rbegin(), program.motions.rend(),
                                    [&](const MotionBlock& block) { return block.line == i + 1; });
      ASSERT_NE(end, program.motions.rend());
      expect_near(end->target, points[i]);
    }
    EXPECT_EQ(program.motions.back().line, 5U);
  }
}

TEST(SinumerikSplines, CubicNotAKnotSplineOfACubicIsThatCubic) {
  // Points of y = x^3 / 1000 close to the X axis, so that the chords' lengths are those along X.
  const auto y = [](double x) { return x * x * x / 1e9; };
  std::string text = "G0 X-20 Y=-8000/1EX9\nCSPLINE F1000";
  for (const int x : {-10, 0, 10, 20}) {
    text += " X" + std::to_string(x) + " Y=" + std::to_string(x * x * x) + "/1EX9\n";
  }
  const ReadProgram program = read_curve(text);
  for (const MotionBlock& block : program.motions) {
    EXPECT_NEAR(block.target.y(), y(block.target.x()), 1e-9);
  }
}

TEST(SinumerikSplines, StraightPointsMakeAStraightPath) {
  for (const char* const ends : {"BAUTO EAUTO", "BNAT ENAT", "BTAN ETAN"}) {
    const ReadProgram program =
        read_curve(std::string("G1 X1 F100\n") + ends + "\nCSPLINE X2\nX5\nX7\nG1 X9");
    EXPECT_LT(greatest(program, [](const Vec3& p) { return p.y(); }), 1e-12);
  }
}

TEST(SinumerikSplines, TangentEndsFollowTheNeighbours) {
  const ReadProgram program = read_curve("G1 Y-10 F100\nBTAN ETAN CSPLINE X10 Y0\nX20 Y-10\nG1 X20 Y-30");
  // From the start downwards, then up to the first point.
  EXPECT_LT(program.motions[1].target.y(), -10);
  // Arrives downwards: the last chord but the line is steep.
  const Vec3 last =
      program.motions[program.motions.size() - 2].target - program.motions[program.motions.size() - 3].target;
  EXPECT_LT(last.y(), -std::abs(last.x()));
}

TEST(SinumerikSplines, SplineAtTheProgramsEndIsWritten) {
  EXPECT_GT(read_curve("ASPLINE X10 Y5 F1000\nX20 Y0").motions.size(), 4U);
  EXPECT_GT(read_curve("ASPLINE X10 Y5 F1000\nX20 Y0\nM30").motions.size(), 4U);
}

}  // namespace
}  // namespace feedscope

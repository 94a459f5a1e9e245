#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/base/units.h"
#include "tests/core/program/motion_text.h"
#include "tests/core/program/path/line_writer.h"

namespace feedscope {
namespace {

using units::pi;

/// Once around the square from (0, 0) to (20, 20), counter-clockwise, in from and out to (-10, 0).
LineWriter& around_square(LineWriter& writer, ToolSide side, double radius) {
  writer.rapid({-10, 0, 0}).on(side, radius).line({0, 0, 0}).line({20, 0, 0}).line({20, 20, 0});
  return writer.line({0, 20, 0}).line({0, 0, 0}).off().line({-10, 0, 0});
}

TEST(CutterCompensation, LeavesTheContourAloneForRadiusZero) {
  LineWriter writer;
  EXPECT_EQ(text_of(around_square(writer, ToolSide::left, 0).finish_clean()),
            (Lines{"rapid -10 0 0 @1", "line 0 0 0 @2", "line 20 0 0 @3", "line 20 20 0 @4", "line 0 20 0 @5",
                   "line 0 0 0 @6", "line -10 0 0 @7"}));
}

TEST(CutterCompensation, RunsInsideASquareFromMeetingPointToMeetingPoint) {
  LineWriter writer;
  const ReadProgram program = around_square(writer, ToolSide::left, 3).finish();
  EXPECT_EQ(text_of(program), (Lines{"rapid -10 0 0 @1", "line 0 3 0 @2", "line 17 3 0 @3", "line 17 17 0 @4",
                                     "line 3 17 0 @5", "line 3 0 0 @6", "line -10 0 0 @7"}))
      << "entry and exit are square beside the ends";
  ASSERT_EQ(program.diagnostics.size(), 1U);
  EXPECT_EQ(format(program.diagnostics[0], "f"),
            "f:3: error: at this block a tool of radius 3.0000 mm cuts 3.0000 mm into the contour of line 6 "
            "[compensation-gouge] (use a smaller tool, or do not begin the contour in an inside corner)")
      << "at the corner where it begins";
}

TEST(CutterCompensation, RunsAroundOutsideCornersOnArcsAboutThem) {
  LineWriter writer;
  const ReadProgram program = around_square(writer, ToolSide::right, 3).finish_clean();
  EXPECT_EQ(text_of(program), (Lines{"rapid -10 0 0 @1", "line 0 -3 0 @2", "line 20 -3 0 @3", "arc 23 0 0 @4",
                                     "line 23 20 0 @4", "arc 20 23 0 @5", "line 0 23 0 @5", "arc -3 20 0 @6",
                                     "line -3 0 0 @6", "line -10 0 0 @7"}));
  ASSERT_EQ(program.arcs.size(), 3U);
  EXPECT_EQ(program.arcs[0].center, Vec3(20, 0, 0));
  EXPECT_EQ(program.arcs[0].axis, Vec3(0, 0, 1));
}

TEST(CutterCompensation, RunsAroundOutsideCornersOnLines) {
  LineWriter writer(OutsideCorner::lines);
  EXPECT_EQ(text_of(around_square(writer, ToolSide::right, 3).finish_clean()),
            (Lines{"rapid -10 0 0 @1", "line 0 -3 0 @2", "line 23 -3 0 @3", "line 23 23 0 @4",
                   "line -3 23 0 @5", "line -3 0 0 @6", "line -10 0 0 @7"}));
}

TEST(CutterCompensation, CutsTheTipOffSharpOutsideCorners) {
  // Back along the same line: both paths run on by the radius, and a straight line joins them.
  LineWriter writer(OutsideCorner::lines);
  writer.on(ToolSide::left, 2).line({0, 10, 0}).line({10, 10, 0}).line({0, 10, 0}).off().line({0, 0, 0});
  EXPECT_EQ(text_of(writer.finish_clean()),
            (Lines{"line 0 12 0 @1", "line 12 12 0 @2", "line 12 8 0 @3", "line 0 8 0 @3", "line 0 0 0 @4"}));
}

TEST(CutterCompensation, TurnsAboutTheEndWhereTheContourComesBack) {
  LineWriter writer;
  writer.on(ToolSide::left, 2).line({0, 10, 0}).line({10, 10, 0}).line({0, 10, 0}).off().line({0, 0, 0});
  const ReadProgram program = writer.finish_clean();
  EXPECT_EQ(text_of(program),
            (Lines{"line 0 12 0 @1", "line 10 12 0 @2", "arc 10 8 0 @3", "line 0 8 0 @3", "line 0 0 0 @4"}));
  EXPECT_EQ(program.arcs.at(0).axis, Vec3(0, 0, -1));
}

TEST(CutterCompensation, LinesAroundACornerOfAnArcTouchBothEnds) {
  // A quarter circle that meets a line at a right angle: line from its end, on to the line's path.
  LineWriter writer(OutsideCorner::lines);
  writer.rapid({10, -5, 0}).on(ToolSide::right, 2).line({10, 0, 0});
  writer.arc({0, 10, 0}, {0, 0, 0}, Vec3::UnitZ()).line({0, 0, 0}).off().line({0, -9, 0});
  EXPECT_EQ(text_of(writer.finish_clean()), (Lines{"rapid 10 -5 0 @1", "line 12 0 0 @2", "arc 0 12 0 @3",
                                                   "line -2 12 0 @4", "line -2 0 0 @4", "line 0 -9 0 @5"}));
}

struct CircleCase {
  ToolSide side;
  double axis;      ///< 1: counter-clockwise
  double expected;  ///< radius beside a circle of 10 mm
};

class CompensatedCircle : public testing::TestWithParam<CircleCase> {};

TEST_P(CompensatedCircle, RunsOnTheCircleBeside) {
  for (const double extra : {0.0, 2.0}) {
    LineWriter writer;
    writer.on(GetParam().side, 4).line({10, 0, 0});
    writer.arc({10, 0, -6}, {0, 0, 0}, GetParam().axis * Vec3::UnitZ(), extra).off().line({0, 0, -6});
    const ReadProgram program = writer.finish_clean();
    const double r = GetParam().expected;
    EXPECT_EQ(text_of(program),
              (Lines{fmt::format("line {} 0 0 @1", r), fmt::format("arc {} 0 -6 @2", r), "line 0 0 -6 @3"}));
    EXPECT_EQ(program.arcs.at(0).turns, 1 + extra);
    EXPECT_LT(program.arcs.at(0).center.head<2>().norm(), 1e-12);
  }
}

INSTANTIATE_TEST_SUITE_P(Sides, CompensatedCircle,
                         testing::Values(CircleCase{ToolSide::left, 1, 6}, CircleCase{ToolSide::right, 1, 14},
                                         CircleCase{ToolSide::left, -1, 14},
                                         CircleCase{ToolSide::right, -1, 6}));

TEST(CutterCompensation, TangentElementsStayTangent) {
  // A slot outline: two lines, two half circles; nothing is put in anywhere.
  for (const double out : {3.0, -3.0}) {
    LineWriter writer;
    writer.rapid({0, -20, 0}).on(ToolSide::right, out).line({0, -5, 0}).line({30, -5, 0});
    writer.arc({30, 5, 0}, {30, 0, 0}, Vec3::UnitZ()).line({0, 5, 0});
    writer.arc({0, -5, 0}, {0, 0, 0}, Vec3::UnitZ()).off().line({0, -20, 0});
    const double y = 5 + out;
    EXPECT_EQ(text_of(writer.finish_clean()),
              (Lines{"rapid 0 -20 0 @1", fmt::format("line 0 {} 0 @2", -y),
                     fmt::format("line 30 {} 0 @3", -y), fmt::format("arc 30 {} 0 @4", y),
                     fmt::format("line 0 {} 0 @5", y), fmt::format("arc 0 {} 0 @6", -y), "line 0 -20 0 @7"}));
  }
}

TEST(CutterCompensation, AnArcAsSmallAsTheToolBecomesAPoint) {
  LineWriter writer;
  writer.rapid({0, 5, 0}).on(ToolSide::left, 5).line({0, 0, 0}).line({15, 0, 0});
  writer.arc({20, 5, 0}, {15, 5, 0}, Vec3::UnitZ()).line({20, 30, 0}).off().line({0, 30, 0});
  EXPECT_EQ(text_of(writer.finish_clean()), (Lines{"rapid 0 5 0 @1", "line 0 5 0 @2", "line 15 5 0 @3",
                                                   "line 15 5 0 @4", "line 15 30 0 @5", "line 0 30 0 @6"}));
}

TEST(CutterCompensation, InsideCornersBetweenLineAndArcEndWhereThePathsMeet) {
  // The line runs along a radius into the middle of a circle of 10 mm; the tool meets line + 2 and circle 8.
  LineWriter writer;
  writer.rapid({-20, 0, 0}).on(ToolSide::left, 2).line({0, 0, 0}).line({10, 0, 0});
  writer.arc({-10, 0, 0}, {0, 0, 0}, Vec3::UnitZ()).line({0, 0, 0}).off().line({0, 5, 0});
  const ReadProgram program = writer.finish_clean();
  const double x = std::sqrt(8.0 * 8 - 2 * 2);
  ASSERT_EQ(program.motions.size(), 6U);
  EXPECT_LT((program.motions[2].target - Vec3(x, 2, 0)).norm(), 1e-9);
  EXPECT_LT((program.motions[3].target - Vec3(-x, 2, 0)).norm(), 1e-9);
  EXPECT_LT((program.motions[4].target - Vec3(0, 2, 0)).norm(), 1e-9);
}

TEST(CutterCompensation, MotionsAcrossThePlaneAndDwellsTakePlaceAtTheCorner) {
  LineWriter writer;
  writer.on(ToolSide::left, 1).line({0, 0, -2}).line({10, 0, -2}).line({10, 0, 5}).dwell();
  writer.line({10, 0, -3}).line({10, 10, -3}).off().line({10, 10, 0}).rapid({0, 0, 0});
  EXPECT_EQ(text_of(writer.finish_clean()),
            (Lines{"line 0 0 -2 @1", "line 9 0 -2 @2", "line 9 0 5 @3", "dwell 9 0 5 @4", "line 9 0 -3 @5",
                   "line 9 10 -3 @6", "line 10 10 0 @7", "rapid 0 0 0 @8"}));
}

TEST(CutterCompensation, AnotherRadiusOrSideMakesAnEntryOfTheNextMotion) {
  LineWriter writer;
  writer.on(ToolSide::left, 1).line({10, 0, 0}).line({20, 0, 0}).on(ToolSide::left, 2).line({30, 0, 0});
  writer.line({40, 0, 0}).on(ToolSide::right, 2).line({50, 0, 0}).line({60, 0, 0});
  EXPECT_EQ(text_of(writer.finish_clean()), (Lines{"line 10 1 0 @1", "line 20 1 0 @2", "line 30 2 0 @3",
                                                   "line 40 2 0 @4", "line 50 -2 0 @5", "line 60 -2 0 @6"}))
      << "the program may end with it on";
}

TEST(CutterCompensation, TheSameAgainChangesNothing) {
  LineWriter writer;
  writer.on(ToolSide::left, 1).line({10, 0, 0}).line({20, 0, 0}).on(ToolSide::left, 1).line({20, 9, 0});
  EXPECT_EQ(text_of(writer.finish_clean()), (Lines{"line 10 1 0 @1", "line 19 1 0 @2", "line 19 9 0 @3"}));
}

TEST(CutterCompensation, PositionsStayThoseOfTheContour) {
  LineWriter writer;
  writer.on(ToolSide::left, 1).line({10, 0, 0}).line({20, 0, 0}).line({20, 9, 0});
  EXPECT_EQ(writer.path().position(), Vec3(20, 9, 0));
}

TEST(CutterCompensation, RapidsAreCompensatedAndMeetOnRapids) {
  LineWriter writer;
  writer.on(ToolSide::left, 1).rapid({10, 0, 0}).rapid({20, 0, 0}).rapid({20, -9, 0}).off();
  EXPECT_EQ(text_of(writer.finish_clean()),
            (Lines{"rapid 10 1 0 @1", "rapid 21 1 0 @2", "rapid 21 -9 0 @3"}));
}

/// The motions to four decimals, as rs274 of LinuxCNC prints them.
Lines as_of_rs274(const ReadProgram& program) {
  constexpr const char* names[] = {"STRAIGHT_TRAVERSE", "STRAIGHT_FEED", "ARC_FEED"};
  Lines lines;
  for (const MotionBlock& block : program.motions) {
    lines.push_back(fmt::format("{}({:.4f}, {:.4f})", names[static_cast<int>(block.motion)], block.target.x(),
                                block.target.y()));
  }
  return lines;
}

TEST(CutterCompensation, OnLinuxCncTheEntryMeetsTheContourLikeAnyOtherBlock) {
  LineWriter inside(linuxcnc_compensation);
  inside.on(ToolSide::left, 1).line({10, 0, 0}).line({10, 10, 0}).off().line({0, 10, 0});
  EXPECT_EQ(text_of(inside.finish_clean()), (Lines{"line 9 1 0 @1", "line 9 10 0 @2", "line 0 10 0 @3"}));
  LineWriter outside(linuxcnc_compensation);
  outside.on(ToolSide::right, 1).line({10, 0, 0}).line({10, 10, 0}).off().line({20, 10, 0});
  EXPECT_EQ(text_of(outside.finish_clean()),
            (Lines{"line 10 -1 0 @1", "arc 11 0 0 @2", "line 11 10 0 @2", "line 20 10 0 @3"}));
}

TEST(CutterCompensation, OnLinuxCncTurnsBelowATwentiethOfARadianAreNoCorners) {
  LineWriter lines(linuxcnc_compensation);
  lines.on(ToolSide::right, 10).line({20, 0, 0}).line({30, 0, 0}).line({40, 0.1745, 0});
  lines.line({50, 0.1745, 0}).off().line({60, 10, 0});
  EXPECT_EQ(as_of_rs274(lines.finish_clean()),
            (Lines{"STRAIGHT_FEED(20.0000, -10.0000)", "STRAIGHT_FEED(30.0000, -10.0000)",
                   "STRAIGHT_FEED(40.1745, -9.8240)", "STRAIGHT_FEED(50.0000, -9.8255)",
                   "STRAIGHT_FEED(60.0000, 10.0000)"}));
  for (const double turn : {-0.0499, 0.0499}) {  // an arc that the square end of the line beside is not on
    LineWriter arc(linuxcnc_compensation);
    const Vec3 center(30 - 2 * std::sin(turn), 2 * std::cos(turn), 0);
    const Vec3 end = center + 2 * Vec3(std::sin(turn + 1), -std::cos(turn + 1), 0);
    arc.on(ToolSide::left, 1.5).line({20, 0, 0}).line({30, 0, 0}).arc(end, center, Vec3::UnitZ());
    arc.off().line({60, 40, 0});
    const ReadProgram program = arc.finish_clean();
    EXPECT_EQ(text_of(program).at(1), "line 30 1.5 0 @2");
    EXPECT_EQ(program.motions.at(2).motion, Motion::arc)
        << "not the line that takes the place of a wrong arc";
  }
}

TEST(CutterCompensation, OnLinuxCncARapidCutsOutsideCornersOff) {
  LineWriter writer(linuxcnc_compensation);
  writer.on(ToolSide::left, 1).rapid({10, 0, 0}).line({20, 5, 0}).rapid({30, 0, 0}).rapid({40, -10, 0});
  writer.off().line({-20, 20, 0});
  EXPECT_EQ(as_of_rs274(writer.finish_clean()),
            (Lines{"STRAIGHT_TRAVERSE(9.7639, 1.0000)", "STRAIGHT_FEED(19.5528, 5.8944)",
                   "STRAIGHT_TRAVERSE(20.4472, 5.8944)", "STRAIGHT_TRAVERSE(30.4472, 0.8944)",
                   "STRAIGHT_TRAVERSE(30.7071, 0.7071)", "STRAIGHT_TRAVERSE(40.7071, -9.2929)",
                   "STRAIGHT_FEED(-20.0000, 20.0000)"}));
}

TEST(CutterCompensation, ACutThatLinuxCncDoesNotLookAheadToIsAWarning) {
  LineWriter writer(linuxcnc_compensation);
  const ReadProgram program = around_square(writer, ToolSide::left, 3).finish();
  ASSERT_EQ(program.diagnostics.size(), 1U);
  EXPECT_EQ(program.diagnostics[0].code, "compensation-gouge");
  EXPECT_EQ(program.diagnostics[0].severity, Severity::warning) << "an error elsewhere";
}

/// As rs274 runs it: the line ends where it would without the arc before it, 0.29 mm back.
TEST(CutterCompensation, OnLinuxCncALineWithoutRoomBeforeAnArcRunsBack) {
  LineWriter writer(linuxcnc_compensation);
  writer.on(ToolSide::right, 1.57).line({-1.357762, 6.131467, 0});
  writer.arc({-4.506447, 8.454165, 0}, {-5.257889, 4.139947, 0}, Vec3::UnitZ());
  writer.line({-4.313839, 9.512348, 0});
  writer.arc({-0.723518, 5.101203, 0}, {-2.525854, 7.300935, 0}, Vec3::UnitZ());
  const ReadProgram program = writer.off().line({4.134167, 9.081316, 0}).finish();
  EXPECT_EQ(as_of_rs274(program),
            (Lines{"STRAIGHT_FEED(0.1751, 6.4709)", "ARC_FEED(0.0405, 6.8455)", "ARC_FEED(-2.7168, 9.5191)",
                   "STRAIGHT_FEED(-2.7692, 9.2312)", "ARC_FEED(-5.3009, 10.7332)", "ARC_FEED(0.2715, 3.8868)",
                   "STRAIGHT_FEED(4.1342, 9.0813)"}));
  ASSERT_EQ(program.diagnostics.size(), 1U);
  EXPECT_EQ(program.diagnostics[0].code, "compensation-gouge");
  EXPECT_EQ(program.diagnostics[0].severity, Severity::warning);
}

/// The same of an arc: it goes on to its end, nearly a whole turn. Before a line the control stops.
TEST(CutterCompensation, OnLinuxCncAnArcWithoutRoomBeforeAnArcIsAWholeTurn) {
  const auto contour = [](bool is_arc) {
    LineWriter writer(linuxcnc_compensation);
    writer.on(ToolSide::right, 1).line({3.390594, 2.122232, 0}).line({6.446826, 4.035181, 0});
    writer.arc({6.669794, 4.000515, 0}, {7.410637, 9.499979, 0}, Vec3::UnitZ());
    is_arc ? writer.arc({6.460619, 8.872591, 0}, {3.383733, 6.299961, 0}, Vec3::UnitZ())
           : writer.line({8, 8, 0});
    return writer.off().line({3.894847, 11.941274, 0}).finish();
  };
  const ReadProgram program = contour(true);
  EXPECT_EQ(as_of_rs274(program), (Lines{"STRAIGHT_FEED(3.9212, 1.2746)", "STRAIGHT_FEED(6.6669, 2.9932)",
                                         "ARC_FEED(6.5363, 3.0095)", "ARC_FEED(7.4891, 3.4272)",
                                         "ARC_FEED(7.2278, 9.5140)", "STRAIGHT_FEED(3.8948, 11.9413)"}));
  EXPECT_NEAR(program.bounds.max.y(), 9.5 + 6.549, 1e-3) << "over the top of the circle";
  ASSERT_EQ(program.diagnostics.size(), 1U);
  EXPECT_EQ(program.diagnostics[0].severity, Severity::warning);
  const ReadProgram stopped = contour(false);
  ASSERT_EQ(stopped.diagnostics.size(), 1U);
  EXPECT_EQ(stopped.diagnostics[0].severity, Severity::error);
}

TEST(CutterCompensation, WorksInEveryPlane) {
  LineWriter zx;
  zx.on(ToolSide::left, 1, Plane::zx).line({0, 0, 10}).line({0, 0, 20}).line({9, 0, 20});
  EXPECT_EQ(text_of(zx.finish_clean()), (Lines{"line 1 0 10 @1", "line 1 0 19 @2", "line 9 0 19 @3"}))
      << "Z to the right, X up";
  LineWriter yz;
  yz.on(ToolSide::left, 1, Plane::yz).line({0, 10, 0}).line({0, 20, 0}).line({0, 20, 9});
  EXPECT_EQ(text_of(yz.finish_clean()), (Lines{"line 0 10 1 @1", "line 0 19 1 @2", "line 0 19 9 @3"}));
}

TEST(CutterCompensation, FramesMoveTheContourNotTheRadius) {
  LineWriter turned;
  turned.frame(CoordinateFrame::rotation(Vec3::UnitZ(), pi / 2)).on(ToolSide::left, 1);
  turned.line({10, 0, 0}).line({20, 0, 0}).line({20, 9, 0});
  EXPECT_EQ(text_of(turned.finish_clean()), (Lines{"line -1 10 0 @1", "line -1 19 0 @2", "line -9 19 0 @3"}));
  LineWriter mirrored;
  mirrored.frame(CoordinateFrame::scale({-1, 1, 1})).on(ToolSide::left, 1);
  mirrored.line({10, 0, 0}).line({20, 0, 0}).line({20, 9, 0});
  EXPECT_EQ(text_of(mirrored.finish_clean()),
            (Lines{"line -10 1 0 @1", "line -19 1 0 @2", "line -19 9 0 @3"}))
      << "inside stays inside";
  LineWriter scaled;
  scaled.frame(CoordinateFrame::scale({2, 2, 2})).on(ToolSide::left, 1);
  scaled.line({10, 0, 0}).line({20, 0, 0}).line({20, 9, 0});
  EXPECT_EQ(text_of(scaled.finish_clean()), (Lines{"line 20 1 0 @1", "line 39 1 0 @2", "line 39 18 0 @3"}));
}

TEST(CutterCompensation, BoundsAreThoseOfTheToolsCentre) {
  LineWriter writer;
  const ReadProgram program = around_square(writer, ToolSide::right, 3).finish_clean();
  EXPECT_EQ(program.bounds.min, Vec3(-10, -3, 0));
  EXPECT_EQ(program.bounds.max, Vec3(23, 23, 0));
}

struct FaultCase {
  const char* name;
  void (*write)(LineWriter&);
  const char* expected;
};

class CompensationFault : public testing::TestWithParam<FaultCase> {};

TEST_P(CompensationFault, NamesBlockAndRadius) {
  LineWriter writer;
  GetParam().write(writer);
  const ReadProgram program = writer.finish();
  ASSERT_EQ(program.diagnostics.size(), 1U);
  EXPECT_EQ(format(program.diagnostics[0], "f"), GetParam().expected);
  for (const MotionBlock& block : program.motions) {
    EXPECT_TRUE(block.target.allFinite());
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, CompensationFault,
    testing::Values(
        FaultCase{"arc",
                  [](LineWriter& writer) {
                    writer.on(ToolSide::left, 5).line({10, 0, 0}).line({20, 0, 0});
                    writer.arc({23, 3, 0}, {20, 3, 0}, Vec3::UnitZ()).line({23, 30, 0});
                  },
                  "f:3: error: the arc's radius, 3.0000 mm, is smaller than the tool's, 5.0000 mm "
                  "[compensation-gouge] (a straight line to its end is used instead, which cuts into the "
                  "contour; use a smaller tool)"},
        FaultCase{"circle",
                  [](LineWriter& writer) {
                    writer.on(ToolSide::left, 5).line({10, 0, 0});
                    writer.arc({10, 0, 0}, {13, 0, 0}, Vec3::UnitZ()).line({20, 0, 0});
                  },
                  "f:2: error: the arc's radius, 3.0000 mm, is smaller than the tool's, 5.0000 mm "
                  "[compensation-gouge] (a straight line to its end is used instead, which cuts into the "
                  "contour; use a smaller tool)"},
        FaultCase{"step",
                  [](LineWriter& writer) {
                    writer.on(ToolSide::left, 5).line({10, 0, 0}).line({20, 0, 0}).line({22, 2, 0});
                    writer.line({22, 30, 0});
                  },
                  "f:3: error: a tool of radius 5.0000 mm does not fit between this block and its neighbours "
                  "[compensation-gouge] (the path shown cuts into the contour here; use a smaller tool)"},
        FaultCase{"apart",
                  [](LineWriter& writer) {
                    writer.on(ToolSide::left, 5).line({0, 8, 0});
                    writer.arc({0, -8, 0}, {0, 0, 0}, Vec3::UnitZ()).line({0, 20, 0});
                  },
                  "f:2: error: a tool of radius 5.0000 mm does not fit between this block and its neighbours "
                  "[compensation-gouge] (the path shown cuts into the contour here; use a smaller tool)"},
        FaultCase{"entry",
                  [](LineWriter& writer) {
                    writer.on(ToolSide::left, 1).arc({10, 10, 0}, {10, 0, 0}, -Vec3::UnitZ());
                  },
                  "f:1: error: cutter radius compensation begins on an arc [compensation-entry] (a straight "
                  "line leads to the start of the offset arc; begin it on a line)"},
        FaultCase{
            "exit",
            [](LineWriter& writer) {
              writer.on(ToolSide::left, 1).line({10, 0, 0}).line({20, 0, 0}).off();
              writer.arc({30, 10, 0}, {20, 10, 0}, Vec3::UnitZ());
            },
            "f:3: error: cutter radius compensation ends on an arc [compensation-exit] (a straight line "
            "leads to its end instead; end it on a line)"},
        FaultCase{"plane",
                  [](LineWriter& writer) {
                    writer.on(ToolSide::left, 1).line({10, 0, 0}).line({20, 0, 0});
                    writer.on(ToolSide::left, 1, Plane::zx).line({20, 0, 10});
                  },
                  "f:2:1: error: the plane changes while cutter radius compensation is on "
                  "[compensation-plane] (it begins again in the other plane; end it before)"}),
    [](const auto& tested) { return std::string(tested.param.name); });

}  // namespace
}  // namespace feedscope

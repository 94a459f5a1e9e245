#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/base/units.h"
#include "tests/core/program/sinumerik/read_sinumerik.h"

namespace feedscope {
namespace {

using units::pi;

struct EndCase {
  const char* text;
  Vec3 end;
};

class SinumerikEnds : public testing::TestWithParam<EndCase> {};

TEST_P(SinumerikEnds, LastMotionEndsWhereItsWordsSay) {
  expect_near(end_of(GetParam().text), GetParam().end);
}

INSTANTIATE_TEST_SUITE_P(
    Coordinates, SinumerikEnds,
    testing::Values(EndCase{"G0 X1 Y2 Z3", {1, 2, 3}}, EndCase{"G0 X1 Y2\nG91 X1 Z-1", {2, 2, -1}},
                    EndCase{"N10G0X1Y-2.5Z.5", {1, -2.5, 0.5}},
                    EndCase{"G0 X=2+3 Y = -(4 - 1) Z=10/4", {5, -3, 2.5}},
                    EndCase{"G0 X5\nX=IC(2) Y=AC(4)", {7, 4, 0}},
                    EndCase{"G91 G0 X5\nX=AC(2) Y=IC(3) Z4", {2, 3, 4}},
                    EndCase{"G0 X=-1.5 Y=+.5 Z=2.", {-1.5, 0.5, 2}}, EndCase{"G0 X=5Y=6Z7", {5, 6, 7}},
                    EndCase{"G0 X=5 DIV 2 Y=7MOD 4", {2, 3, 0}}, EndCase{"G0 X=5 -2 Y=6 *2", {3, 12, 0}},
                    EndCase{"G0 X=3 B_OR 4 Y1", {7, 1, 0}}, EndCase{"G0 X1.5EX2 Y2EX-1", {150, 0.2, 0}},
                    EndCase{"G0 X=1.5EX2", {150, 0, 0}}, EndCase{"G70 G0 X1 Y2", {25.4, 50.8, 0}},
                    EndCase{"G700 G0 X1\nG71 Y2", {25.4, 2, 0}}, EndCase{"G710 G0 X1", {1, 0, 0}},
                    EndCase{"G0 X1 ; X2 (three) \"four\"", {1, 0, 0}},
                    EndCase{"G0 MSG(\"a;b\") X1", {1, 0, 0}}, EndCase{":10 G0 X1", {1, 0, 0}},
                    EndCase{"/0 G0 X1\n/7 X2", {2, 0, 0}}, EndCase{"G0 START_1: X4", {4, 0, 0}}));

INSTANTIATE_TEST_SUITE_P(Polar, SinumerikEnds,
                         testing::Values(EndCase{"G111 X10 Y20\nG0 AP=90 RP=5", {10, 25, 0}},
                                         EndCase{"G0 X10 Y20\nG110\nG0 RP=5 AP=0", {15, 20, 0}},
                                         EndCase{"G111 X10 Y20\nG112 X1 Y1\nG0 AP=180 RP=1", {10, 21, 0}},
                                         EndCase{"G111\nG0 AP=30 RP=10\nAP=IC(60)", {0, 10, 0}},
                                         EndCase{"G18 G111\nG0 AP=90 RP=10 Y3", {10, 3, 0}},
                                         // Both stay in force, the angle up to a new pole or plane.
                                         EndCase{"G111\nG0 AP=0 RP=10\nX0\nAP=90", {0, 10, 0}},
                                         EndCase{"G111\nG0 AP=90 RP=10\nX7\nRP=5", {0, 5, 0}},
                                         EndCase{"G111\nG0 AP=90 RP=10\nX7 Y0\nAP=IC(90)", {-10, 0, 0}},
                                         EndCase{"G111\nG0 AP=90 RP=10\nG111 X10 Y10\nRP=3", {7, 10, 0}},
                                         EndCase{"G1 F100 X10 ANG=45", {10, 10, 0}},
                                         EndCase{"G1 F100 Y10 ANG=135", {-10, 10, 0}}));

TEST(SinumerikMotion, FeedIsPerMinuteInverseTimeOrPerRevolution) {
  const ReadProgram program =
      read_clean("G1 X10 F600\nG93 X20 F2\nG95 S600 X30 F0.1\nG94 X40 F120\nX50 FB=60\nX60\nG700 X3 F1");
  const std::vector<double> feeds{10, 10 * 2 / 60.0, 1, 2, 1, 2, 25.4 / 60};
  ASSERT_EQ(program.motions.size(), feeds.size());
  for (std::size_t i = 0; i < feeds.size(); ++i) {
    EXPECT_NEAR(program.motions[i].feed, feeds[i], 1e-12) << i;
  }
}

TEST(SinumerikMotion, DwellsInSecondsOrRevolutionsLeaveTheFeedAlone) {
  const ReadProgram program = read_clean("G1 X1 F600 S120\nG4 F1.5\nG4 S3\nX2");
  ASSERT_EQ(program.motions.size(), 4U);
  EXPECT_DOUBLE_EQ(program.motions[1].dwell, 1.5);
  EXPECT_DOUBLE_EQ(program.motions[2].dwell, 1.5);
  EXPECT_DOUBLE_EQ(program.motions[3].feed, 10);
}

/// A whole turn of a helix needs no coordinate of its plane.
TEST(SinumerikMotion, AHelixMayNameItsCentreAndItsRiseAlone) {
  const ReadProgram program = read_clean("G0 X13 Y10\nG91 G3 I-3 Z-1 F100");
  ASSERT_EQ(program.arcs.size(), 1U);
  expect_near(program.arcs[0].center, {10, 10, 0});
  EXPECT_EQ(program.arcs[0].turns, 1);
  expect_near(program.motions.back().target, {13, 10, -1});
}

TEST(SinumerikMotion, MacrosStandForTheirWords) {
  const ReadProgram program = read_clean(
      "DEFINE SAFE_Z AS G0 Z100 M5\nDEFINE STEP AS X=IC(R1) F600\nR1=5\nG1 X1 F100\nSAFE_Z\nN10 step G1 Y1 "
      ";STEP\nMSG(\"STEP\") X1");
  ASSERT_EQ(program.motions.size(), 4U);
  EXPECT_EQ(program.motions[1].motion, Motion::rapid);
  expect_near(program.motions[1].target, {1, 0, 100});
  expect_near(program.motions[2].target, {6, 1, 100});
  EXPECT_DOUBLE_EQ(program.motions[2].feed, 10);
  expect_near(program.motions[3].target, {1, 1, 100});
}

TEST(SinumerikMotion, APositioningAxisRunsAtItsOwnFeed) {
  const ReadProgram program = read_clean("G1 X1 F60\nFA[Z]=600\nPOS[Z]=10\nX2\nG91 POSA[Z]=AC(4)\nPOS[Z]=1");
  ASSERT_EQ(program.motions.size(), 5U);
  const std::vector<Vec3> ends{{1, 0, 0}, {1, 0, 10}, {2, 0, 10}, {2, 0, 4}, {2, 0, 5}};
  const std::vector<double> feeds{1, 10, 1, 10, 10};
  for (std::size_t i = 0; i < ends.size(); ++i) {
    expect_near(program.motions[i].target, ends[i]);
    EXPECT_DOUBLE_EQ(program.motions[i].feed, feeds[i]);
  }
}

TEST(SinumerikMotion, LimitsAndSurfaceSpeedsAreNoSpindleSpeed) {
  const ReadProgram program =
      read_sinumerik("S600 M3\nG26 S9000\nG95 G1 X10 F1\nG96 S200\nX20\nG97 S1200\nX30");
  ASSERT_EQ(program.motions.size(), 3U);
  EXPECT_NEAR(program.motions[0].feed, 10, 1e-12);
  EXPECT_NEAR(program.motions[1].feed, 10, 1e-12);
  EXPECT_NEAR(program.motions[2].feed, 20, 1e-12);
}

TEST(SinumerikMotion, DiametersAndRadiiMayBeSaidOfOneCoordinate) {
  EXPECT_EQ(xs_of("G0 X=DAC(10)\nX=DIC(4)\nDIAMON\nX10\nX=RAC(10)\nX=RIC(1)"),
            (std::vector<double>{5, 7, 5, 10, 11}));
}

/// Quarter of the circle about (10, 0) from the origin to (10, 10): clockwise about Z.
class SinumerikQuarter : public testing::TestWithParam<const char*> {};

TEST_P(SinumerikQuarter, EveryWayToWriteItGivesTheSameArc) {
  const ReadProgram program = read_clean(GetParam());
  ASSERT_EQ(program.arcs.size(), 1U) << GetParam();
  expect_near(program.motions.back().target, {10, 10, 0});
  expect_near(program.arcs[0].center, {10, 0, 0});
  expect_near(program.arcs[0].axis, -Vec3::UnitZ());
  EXPECT_EQ(program.arcs[0].turns, 0);
}

INSTANTIATE_TEST_SUITE_P(Words, SinumerikQuarter,
                         testing::Values("G2 X10 Y10 I10 J0 F100", "G2 X10 Y10 I=AC(10) J=AC(0) F100",
                                         "G2 X10 Y10 CR=10 F100", "G2 X10 Y10 AR=90 F100",
                                         "G2 I10 AR=90 F100", "G91 G2 X10 Y10 I10 F100",
                                         "CIP X10 Y10 I1=10-10*COS(45) J1=10*SIN(45) F100",
                                         "G91 CIP X10 Y10 I1=AC(10-10*COS(45)) J1=10*SIN(45) F100",
                                         "G111 X10\nG2 AP=90 RP=10 F100"));

TEST(SinumerikArcs, TangentArcLeavesTheLineAlongItAndTheArcAlongItsEnd) {
  const ReadProgram program = read_clean("G1 X10 F100\nCT X20 Y10\nCT X10 Y20\nCT X30 Y20");
  ASSERT_EQ(program.arcs.size(), 2U);
  expect_near(program.arcs[0].center, {10, 10, 0});
  expect_near(program.arcs[1].center, {10, 10, 0});
  // It leaves (10, 20) along X, and the end lies on that line: no circle does that, a line does.
  ASSERT_EQ(program.motions.size(), 4U);
  EXPECT_EQ(program.motions[3].motion, Motion::line);
}

TEST(SinumerikArcs, RadiusWithSignChoosesTheLargerArcAndTurnAddsCircles) {
  const ReadProgram program = read_clean("G3 X10 Y10 CR=-10 F100\nG3 X0 Y0 I-10 Z5 TURN=2");
  ASSERT_EQ(program.arcs.size(), 2U);
  expect_near(program.arcs[0].center, {10, 0, 0});
  EXPECT_EQ(program.arcs[1].turns, 2);
  EXPECT_DOUBLE_EQ(program.motions[1].target.z(), 5);
}

TEST(SinumerikArcs, PlanesAreRightHandedWithTheirNormal) {
  const ReadProgram program = read_clean("G18 G3 X10 Z10 I10 F100\nG19 G2 Y10 Z20 J10");
  ASSERT_EQ(program.arcs.size(), 2U);
  expect_near(program.arcs[0].axis, Vec3::UnitY());
  expect_near(program.arcs[1].axis, -Vec3::UnitX());
}

TEST(SinumerikArcs, IntermediatePointMayLieInAnyPlane) {
  const ReadProgram program = read_clean("G0 X10\nCIP X-10 Y0 Z0 I1=0 J1=6 K1=8 F100");
  ASSERT_EQ(program.arcs.size(), 1U);
  expect_near(program.arcs[0].center, {0, 0, 0});
  expect_near(program.arcs[0].axis, Vec3(0, -0.8, 0.6));
}

TEST(SinumerikMotion, ThreadRunsAtLeadTimesSpindleSpeed) {
  const ReadProgram program = read_sinumerik("G0 X0 S300 F50\nG33 Z-10 K2\nG1 X5");
  ASSERT_EQ(program.motions.size(), 3U);
  EXPECT_DOUBLE_EQ(program.motions[1].feed, 10);
  EXPECT_DOUBLE_EQ(program.motions[2].feed, 50.0 / 60);
  ASSERT_EQ(program.diagnostics.size(), 1U);
  EXPECT_EQ(program.diagnostics[0].code, "thread");
}

TEST(SinumerikMotion, ProgramEndsWithM30AndWhatFollowsIsNotRun) {
  const ReadProgram program = read_sinumerik("G0 X1\nX2 M30\nX3");
  EXPECT_EQ(program.motions.size(), 2U);
  ASSERT_EQ(program.diagnostics.size(), 1U);
  EXPECT_EQ(program.diagnostics[0].code, "text-after-end");
}

TEST(SinumerikMotion, DeletedBlocksAreLeftOutWhenAsked) {
  const auto source = std::make_shared<const SourceText>("t.mpf", "G0 X1\n/1 X2\nN3 / X3\nX4");
  const ReadProgram program =
      read_program(source, nullptr, {.dialect = Dialect::sinumerik, .skip_deleted_blocks = true});
  EXPECT_EQ(program.motions.size(), 2U);
}

TEST(SinumerikMotion, WordsWithoutEffectOnThePathAreAccepted) {
  EXPECT_EQ(xs_of("WORKPIECE(,\"\",,\"BOX\",112,0,-51,-80,0,0,100,100)\nT=\"MILL D10\" M6\nT1 D1 H5 M=QU(8)\n"
                  "S1=500 M1=3 S[2]=100\nSTOPRE\nFGROUP(X,Y,Z)\nSPOS=90 SPOS[2]=AC(30)\nCFTCP G450 NORM\n"
                  "EXTERN SUB(REAL,INT)\nSETMS(1) TRAFOOF ORIWKS\nG601 FNORM\nCOUPON(S1,S2)\nG0 X7 M8"),
            std::vector<double>{7});
}

}  // namespace
}  // namespace feedscope

#include <gtest/gtest.h>

#include <string>

#include "core/base/units.h"
#include "core/program/program.h"
#include "tests/core/program/read_text.h"

namespace feedscope {
namespace {

/// Reads a program that must be free of diagnostics.
ReadProgram read_clean(std::string text, const ReadOptions& options = {}) {
  ReadProgram program = read_text(std::move(text), options);
  for (const Diagnostic& diagnostic : program.diagnostics) {
    ADD_FAILURE() << format(diagnostic, "test.nc");
  }
  return program;
}

Vec3 end_of(const ReadProgram& program) {
  return program.motions.back().target;
}

TEST(IsoReader, MotionAndFeedAreModal) {
  const ReadProgram program = read_clean("G0 X1 Y2 Z3\nG1 X4 F600\nY5\nZ6 F1200\nG0 X0\n");
  ASSERT_EQ(program.motions.size(), 5U);
  EXPECT_EQ(program.motions[0].motion, Motion::rapid);
  EXPECT_EQ(program.motions[0].feed, 0);
  EXPECT_EQ(program.motions[1].target, Vec3(4, 2, 3));
  EXPECT_EQ(program.motions[2].motion, Motion::line);
  EXPECT_EQ(program.motions[2].target, Vec3(4, 5, 3));
  EXPECT_EQ(program.motions[2].feed, 10);
  EXPECT_EQ(program.motions[3].feed, 20);
  EXPECT_EQ(program.motions[3].line, 4U);
  EXPECT_EQ(program.motions[4].motion, Motion::rapid);
}

TEST(IsoReader, CaseAndBlanksDoNotMatter) {
  EXPECT_EQ(end_of(read_clean("g1x1.5y-2f100")), Vec3(1.5, -2, 0));
  EXPECT_EQ(end_of(read_clean("N5  G 01  X 1.5\tY - 2  F 100")), Vec3(1.5, -2, 0));
}

TEST(IsoReader, OrderOfWordsInABlockDoesNotMatter) {
  EXPECT_EQ(end_of(read_clean("X1 F100 G1 Y1 G20")), Vec3(25.4, 25.4, 0));
}

TEST(IsoReader, IncrementalWordsAddUp) {
  EXPECT_EQ(end_of(read_clean("G0 X10 Y10\nG91 X1 Y-2\nX1\nG90 Z5\n")), Vec3(12, 8, 5));
}

TEST(IsoReader, InchesAndMetricAlternate) {
  const ReadProgram program = read_clean("G20 G1 X1 F10\nG21 Y1 F600\n");
  EXPECT_EQ(end_of(program), Vec3(25.4, 1, 0));
  EXPECT_NEAR(program.motions[0].feed, 254.0 / 60, 1e-12);
  EXPECT_EQ(program.motions[1].feed, 10);
}

TEST(IsoReader, SeveralGWordsStandInOneBlock) {
  const ReadProgram program = read_clean("G0 G17 G21 G40 G49 G80 G90 G94 G54 G64 G69 G15 G50 X5\n");
  EXPECT_EQ(program.block_count, 1U);
  EXPECT_EQ(end_of(program), Vec3(5, 0, 0));
}

TEST(IsoReader, CountsBlocksNotCommentsOrBlankLines) {
  EXPECT_EQ(read_clean("%\nO1000 (PART)\n\n; note\nG0 X1\nM3 S500\n(end)\nM30\n%\n").block_count, 4U);
}

TEST(IsoReader, StopsAtTheProgramsEnd) {
  for (const char* const end : {"M2", "M30", "M99", "%", "G0 X1 M30"}) {
    const ReadProgram program = read_text(std::string("%\nG0 X1\n") + end + "\nG0 X99\n");
    EXPECT_EQ(end_of(program), Vec3(1, 0, 0)) << end;
  }
}

TEST(IsoReader, PercentBeforeTheFirstWordIsTheStart) {
  EXPECT_EQ(end_of(read_clean("%\n%PART1\nG0 X1\n%\n")).x(), 1);
  EXPECT_EQ(end_of(read_text("tape leader\n%\nG0 X1\n%\n")).x(), 1);
}

TEST(IsoReader, DeletedBlocksRunUnlessTheSwitchIsOn) {
  const std::string text = "G0 X1\n/ X2\n/2 X3\nN7 / X4\n";
  EXPECT_EQ(end_of(read_clean(text)).x(), 4);
  EXPECT_EQ(end_of(read_clean(text, {.skip_deleted_blocks = true})).x(), 1);
}

TEST(IsoReader, DwellsInSecondsAndMilliseconds) {
  const ReadProgram program =
      read_clean("G0 X5\nG4 P1.5\nG4 P500\nG4 X2\nG04 U0.25\nG4 F3\nG4 P0\nG1 Y1 F60\n");
  ASSERT_EQ(program.motions.size(), 7U);
  EXPECT_EQ(program.motions[1].motion, Motion::dwell);
  EXPECT_EQ(program.motions[1].dwell, 1.5);
  EXPECT_EQ(program.motions[1].target, Vec3(5, 0, 0));
  EXPECT_EQ(program.motions[2].dwell, 0.5);
  EXPECT_EQ(program.motions[3].dwell, 2);
  EXPECT_EQ(program.motions[4].dwell, 0.25);
  EXPECT_EQ(program.motions[5].dwell, 3);
  EXPECT_EQ(program.motions[6].feed, 1);
}

TEST(IsoReader, DwellDoesNotChangeTheMotionInForce) {
  EXPECT_EQ(read_clean("G1 X1 F100\nG4 P0.5\nX2\n").motions.back().motion, Motion::line);
}

struct PlaneCase {
  const char* text;  ///< quarter turn of radius 10 about the origin, G3
  Vec3 axis;
};

class ArcPlane : public testing::TestWithParam<PlaneCase> {};

// Counter-clockwise seen from the plane's positive normal turns the first axis into the second: X to Y in
// G17, Z to X in G18, Y to Z in G19.
TEST_P(ArcPlane, CounterClockwiseTurnsTheFirstAxisIntoTheSecond) {
  const ReadProgram program = read_clean(GetParam().text);
  ASSERT_EQ(program.arcs.size(), 1U);
  EXPECT_LT(program.arcs[0].center.norm(), 1e-12);
  EXPECT_EQ(program.arcs[0].axis, GetParam().axis);
  const Vec3 start = program.motions[0].target;
  const Vec3 end = program.motions[1].target;
  EXPECT_LT((GetParam().axis.cross(start) - end).norm(), 1e-12) << "a quarter turn, not three";
}

INSTANTIATE_TEST_SUITE_P(Planes, ArcPlane,
                         testing::Values(PlaneCase{"G17 G0 X10\nG3 X0 Y10 I-10 J0 F100", Vec3::UnitZ()},
                                         PlaneCase{"G18 G0 Z10\nG3 X10 Z0 I0 K-10 F100", Vec3::UnitY()},
                                         PlaneCase{"G19 G0 Y10\nG3 Y0 Z10 J-10 K0 F100", Vec3::UnitX()},
                                         PlaneCase{"G17 G0 X10\nG3 X0 Y10 R10 F100", Vec3::UnitZ()},
                                         PlaneCase{"G18 G0 Z10\nG3 X10 Z0 R10 F100", Vec3::UnitY()},
                                         PlaneCase{"G19 G0 Y10\nG3 Y0 Z10 R10 F100", Vec3::UnitX()},
                                         PlaneCase{"G17 G0 Y10\nG2 X10 Y0 J-10 F100", -Vec3::UnitZ()},
                                         PlaneCase{"G18 G0 X10\nG2 Z10 X0 I-10 F100", -Vec3::UnitY()},
                                         PlaneCase{"G19 G0 Z10\nG2 Y10 Z0 K-10 F100", -Vec3::UnitX()}));

TEST(IsoReader, CentresAreOffsetsOrPositions) {
  for (const char* const text : {"G0 X10 Y5\nG3 X5 Y10 I-5 F100", "G0 X10 Y5\nG90.1 G3 X5 Y10 I5 J5 F100",
                                 "G90.1\nG91.1\nG0 X10 Y5\nG3 X5 Y10 I-5 F100"}) {
    EXPECT_LT((read_clean(text).arcs.at(0).center - Vec3(5, 5, 0)).norm(), 1e-12) << text;
  }
}

TEST(IsoReader, FullCirclesNeedNoEnd) {
  const ReadProgram program = read_clean("G0 X10\nG2 I-10 F100\nX10 I-10\n");
  ASSERT_EQ(program.arcs.size(), 2U);
  EXPECT_EQ(program.arcs[0].turns, 1);
  EXPECT_EQ(program.arcs[1].turns, 1);
  EXPECT_EQ(end_of(program), Vec3(10, 0, 0));
}

TEST(IsoReader, TurnsOfAHelixComeFromP) {
  EXPECT_EQ(read_clean("G0 X10\nG3 X10 Y0 Z-6 I-10 P3 F100").arcs.at(0).turns, 3);
  EXPECT_EQ(read_clean("G0 X10\nG3 X0 Y10 Z-6 I-10 P3 F100").arcs.at(0).turns, 2);
}

TEST(IsoReader, BoundsLeaveOutTheAssumedStart) {
  const ReadProgram rapid = read_clean("G0 Z50\nG0 X10 Y20\nZ1\nG1 Z-5 F100\nX30\n");
  EXPECT_EQ(rapid.bounds.min, Vec3(10, 20, -5));
  EXPECT_EQ(rapid.bounds.max, Vec3(30, 20, 50));
  const ReadProgram feed = read_clean("G1 X10 F100\n");
  EXPECT_EQ(feed.bounds.min, Vec3(0, 0, 0)) << "a cut from the start counts";
  EXPECT_EQ(feed.bounds.max, Vec3(10, 0, 0));
  EXPECT_TRUE(read_clean("M3\nG4 P1.0\n").bounds.empty());
}

TEST(IsoReader, HarmlessWordsAreTakenWithoutAWord) {
  const ReadProgram program = read_clean(
      "G0 T1 M6 D1 H1 S5000 M3 A0. X1\nG5.1 Q1\nG5 P10000\nG92 E0\nG54.1 P3 X2\nG64 P0.01\nA0 X3\n");
  EXPECT_EQ(end_of(program), Vec3(3, 0, 0));
}

TEST(IsoReader, LeavesOutOnlyTheMotionOfAWrongBlock) {
  const ReadProgram program = read_text("G1 X1 F100\nG91 X1..2 F200\nX1\n");
  ASSERT_EQ(program.motions.size(), 2U);
  EXPECT_EQ(end_of(program), Vec3(2, 0, 0));
  EXPECT_NEAR(program.motions[1].feed, units::from_mm_min(200), 1e-12);
}

TEST(IsoReader, ArcsThatCannotBeBecomeLinesSoThatThePositionGoesOn) {
  const ReadProgram program = read_text("G1 X10 F100\nG2 X20 I3\nX30 R1\nX40\nI0\n");
  ASSERT_EQ(program.motions.size(), 5U);
  for (const MotionBlock& block : program.motions) {
    EXPECT_EQ(block.motion, Motion::line);
  }
  EXPECT_EQ(end_of(program), Vec3(40, 0, 0));
}

TEST(IsoReader, UnreadMotionLeavesPositionsOutUpToTheNextMotionWord) {
  const ReadProgram program = read_text("G0 X1\nG33 X2 Z-5 K1\nX3\nG80\nG0 X4\n");
  ASSERT_EQ(program.motions.size(), 2U);
  EXPECT_EQ(program.motions[1].target, Vec3(4, 0, 0));
}

TEST(IsoReader, BehindMachineMotionsNothingMovesUntilTheAxisIsProgrammed) {
  const ReadProgram program = read_text("G0 X1 Z5\nG53 Z0\nG91 G28 Z0\nG90 X2\nZ7\nX3\n");
  ASSERT_EQ(program.motions.size(), 6U);
  for (std::size_t i = 1; i < 5; ++i) {
    EXPECT_EQ(program.motions[i].pause, Pause::machine_move) << i;
  }
  EXPECT_EQ(program.motions[4].target, Vec3(2, 0, 7));
  EXPECT_EQ(end_of(program), Vec3(3, 0, 7));
}

TEST(IsoReader, WithoutAFeedMovesRunAtFeedZeroUntilOneComes) {
  const ReadProgram program = read_text("G1 X1\nX2 F0\nX3 F60\nX4 F-5\n");
  EXPECT_EQ(program.motions[0].feed, 0);
  EXPECT_EQ(program.motions[1].feed, 0);
  EXPECT_EQ(program.motions[2].feed, 1);
  EXPECT_EQ(program.motions[3].feed, 1);
}

// A circle about X10 Y10 in quarters, its centre written as a position.
TEST(IsoReader, CentresThatFitAsPositionsOnlyAreTakenSo) {
  const std::string quarters = "G0 X20 Y10\nG3 X10 Y20 I10 J10 F100\nX0 Y10 I10 J10\nX10 Y0 I10 J10\n";
  const ReadProgram program = read_text(quarters);
  ASSERT_EQ(program.diagnostics.size(), 1U);
  EXPECT_EQ(program.diagnostics[0].code, "arc-centers");
  EXPECT_EQ(program.diagnostics[0].line, 2U);
  ASSERT_EQ(program.arcs.size(), 3U);
  EXPECT_EQ(program.arcs[1].center, Vec3(10, 10, 0));
  const std::string two_quarters = quarters.substr(0, quarters.find("X10 Y0"));
  EXPECT_TRUE(has_errors(read_text(two_quarters).diagnostics)) << "too few to judge by";
  EXPECT_TRUE(has_errors(read_text("G91.1\n" + quarters).diagnostics)) << "the program says otherwise";
  EXPECT_TRUE(has_errors(read_text(quarters + "G0 X50 Y50\nG3 X60 Y60 J10\n").diagnostics))
      << "one fits as an offset only";
  EXPECT_TRUE(has_errors(read_text(quarters, {.dialect = Dialect::linuxcnc}).diagnostics));
}

TEST(IsoReader, StopsWhenCancelled) {
  std::string text;
  for (int i = 0; i < 20000; ++i) {
    text += "G0X1\n";
  }
  Progress progress;
  progress.cancel();
  EXPECT_THROW(read_program(std::make_shared<const SourceText>("test.nc", text), &progress), Cancelled);
}

TEST(IsoReader, AMillionWrongLinesStayAFewDiagnostics) {
  std::string text;
  for (int i = 0; i < 1000000; ++i) {
    text += "X1..2\n";
  }
  EXPECT_LT(read_text(text).diagnostics.size(), 20U);
}

}  // namespace
}  // namespace feedscope

#include <gtest/gtest.h>

#include <string>

#include "tests/core/program/iso/iso_text.h"
#include "tests/core/program/motion_text.h"

namespace feedscope {
namespace {

struct CoordinateCase {
  const char* name;
  Dialect dialect;
  const char* text;
  const char* last;  ///< motion
};

class ProgrammedPosition : public testing::TestWithParam<CoordinateCase> {};

TEST_P(ProgrammedPosition, ShowTheLastMotionWhereItIs) {
  EXPECT_EQ(text_of(read_clean_as(GetParam().dialect, GetParam().text)).back(), GetParam().last);
}

constexpr Dialect fanuc = Dialect::fanuc;
constexpr Dialect linuxcnc = Dialect::linuxcnc;

INSTANTIATE_TEST_SUITE_P(
    Shifts, ProgrammedPosition,
    testing::Values(
        CoordinateCase{"local", fanuc, "G52 X10 Y5\nG0 X1 Y1", "rapid 11 6 0 @2"},
        CoordinateCase{"localOff", fanuc, "G52 X10 Y5\nG52 X0 Y0\nG0 X1 Y1", "rapid 1 1 0 @3"},
        CoordinateCase{"localOneAxis", fanuc, "G52 X10 Y5\nG52 X3\nG0 X1 Y1", "rapid 4 6 0 @3"},
        CoordinateCase{"localInch", fanuc, "G20 G52 X1\nG21 G0 X1", "rapid 26.4 0 0 @2"},
        CoordinateCase{"preset", linuxcnc, "G0 X10 Y5\nG92 X0\nG0 X1 Y1", "rapid 11 1 0 @3"},
        CoordinateCase{"presetAgain", linuxcnc, "G0 X10\nG92 X0\nG92 X100\nG0 X99", "rapid 9 0 0 @4"},
        CoordinateCase{"presetCleared", linuxcnc, "G0 X10\nG92 X0\nG92.1\nG92.3\nG0 X1", "rapid 1 0 0 @5"},
        CoordinateCase{"presetHeld", linuxcnc, "G0 X10\nG92 X0\nG92.2\nG0 X1", "rapid 1 0 0 @4"},
        CoordinateCase{"presetRestored", linuxcnc, "G0 X10\nG92 X0\nG92.2\nG92.3\nG0 X1", "rapid 11 0 0 @5"},
        CoordinateCase{"presetOfTheExtruder", linuxcnc, "G0 X10\nG92 E0\nG0 X1", "rapid 1 0 0 @3"},
        CoordinateCase{"work", fanuc, "G90 G10 L2 P2 X100 Y50\nG55 G0 X1 Y1 Z1", "rapid 101 51 1 @2"},
        CoordinateCase{"workAdds", fanuc, "G10 L2 P1 X100\nG91 G10 L2 P1 X1\nG90 G0 X1", "rapid 102 0 0 @3"},
        CoordinateCase{"workInForce", fanuc, "G54\nG10 L2 P0 X100\nG0 X1", "rapid 101 0 0 @3"},
        CoordinateCase{"workBothSet", fanuc, "G10 L2 P1 X0\nG10 L2 P6 X100\nG54 G0 X1\nG59 X1",
                       "rapid 101 0 0 @4"},
        CoordinateCase{"workNine", linuxcnc, "G10 L2 P9 Z-100\nG59.3 G0 X1 Z1", "rapid 1 0 -99 @2"},
        CoordinateCase{"further", fanuc, "G10 L20 P48 X100\nG54.1 P48 G0 X1", "rapid 101 0 0 @2"},
        CoordinateCase{"workFromPosition", linuxcnc, "G0 X30\nG10 L20 P1 X10\nG0 X11", "rapid 31 0 0 @3"},
        CoordinateCase{"otherWorkFromPosition", linuxcnc, "G10 L2 P1 X0\nG0 X30\nG10 L20 P2 X10\nG55 X11",
                       "rapid 31 0 0 @4"},
        CoordinateCase{"workTurned", linuxcnc, "G10 L2 P1 X100 R90\nG0 X10 Y0", "rapid 100 10 0 @2"},
        CoordinateCase{"incrementalIsNotShifted", fanuc, "G0 X1\nG52 X10\nG91 X1", "rapid 2 0 0 @3"}),
    [](const auto& tested) { return std::string(tested.param.name); });

INSTANTIATE_TEST_SUITE_P(
    Transforms, ProgrammedPosition,
    testing::Values(
        CoordinateCase{"rotated", fanuc, "G68 X0 Y0 R90\nG0 X10 Y0 Z1", "rapid 0 10 1 @2"},
        CoordinateCase{"rotatedAboutACentre", fanuc, "G68 X10 Y0 R90\nG0 X20 Y0", "rapid 10 10 0 @2"},
        CoordinateCase{"rotatedAboutTheTool", fanuc, "G0 X10\nG68 R90\nG0 X20 Y0", "rapid 10 10 0 @3"},
        CoordinateCase{"rotatedFurther", fanuc, "G68 X0 Y0 R30\nG91 G68 X0 Y0 R60\nG90 G0 X10 Y0",
                       "rapid 0 10 0 @3"},
        CoordinateCase{"rotationEnds", fanuc, "G68 X0 Y0 R90\nG69\nG0 X10 Y0", "rapid 10 0 0 @3"},
        CoordinateCase{"rotatedInZx", fanuc, "G18 G68 X0 Z0 R90\nG0 Z10 X0", "rapid 10 0 0 @2"},
        CoordinateCase{"rotationAfterTheOffset", fanuc, "G10 L2 P1 X100\nG68 X0 Y0 R90\nG0 X10 Y0",
                       "rapid 100 10 0 @3"},
        CoordinateCase{"scaled", fanuc, "G51 X0 Y0 Z0 P2.\nG0 X10 Y5", "rapid 20 10 0 @2"},
        CoordinateCase{"scaledInThousandths", fanuc, "G51 X10 Y0 Z0 P500\nG0 X20 Y10", "rapid 15 5 0 @2"},
        CoordinateCase{"scaledAboutTheTool", fanuc, "G0 X10\nG51 P2.\nG0 X11", "rapid 12 0 0 @3"},
        CoordinateCase{"scaledByAxis", fanuc, "G51 X0 Y0 Z0 I2. J-1. K1.\nG0 X10 Y5 Z3", "rapid 20 -5 3 @2"},
        CoordinateCase{"scaleEnds", fanuc, "G51 X0 Y0 Z0 P2.\nG50\nG0 X10", "rapid 10 0 0 @3"},
        CoordinateCase{"mirrored", fanuc, "G51.1 X20\nG0 X15 Y5", "rapid 25 5 0 @2"},
        CoordinateCase{"mirrorEnds", fanuc, "G51.1 X20 Y0\nG50.1 X0\nG0 X15 Y5", "rapid 15 -5 0 @3"},
        CoordinateCase{"allMirrorsEnd", fanuc, "G51.1 X20 Y0\nG50.1\nG0 X15 Y5", "rapid 15 5 0 @3"},
        CoordinateCase{"mirrorBeforeRotation", fanuc, "G51.1 X0\nG68 X0 Y0 R90\nG0 X10 Y0",
                       "rapid 0 -10 0 @3"},
        CoordinateCase{"polar", fanuc, "G16 G0 X10 Y90 Z1", "rapid 0 10 1 @1"},
        CoordinateCase{"polarAngle", fanuc, "G16 G0 X10 Y90\nY180", "rapid -10 0 0 @2"},
        CoordinateCase{"polarAngleOn", fanuc, "G16 G0 X10 Y90\nG91 Y90", "rapid -10 0 0 @2"},
        CoordinateCase{"polarAboutTheTool", fanuc, "G0 X50\nG16 G91 X10 Y90", "rapid 50 10 0 @2"},
        CoordinateCase{"polarInYz", fanuc, "G19 G16 G0 Y10 Z90", "rapid 0 0 10 @1"},
        CoordinateCase{"polarEnds", fanuc, "G16 G0 X10 Y90\nG15 X1 Y1", "rapid 1 1 0 @2"}),
    [](const auto& tested) { return std::string(tested.param.name); });

TEST(IsoTransforms, ArcsTurnAlongAndMirrorTheirDirection) {
  const ReadProgram turned = read_clean_as(fanuc, "G68 X0 Y0 R90\nG0 X10 Y0\nG3 X0 Y10 I-10 F100");
  EXPECT_EQ(text_of(turned).back(), "arc -10 0 0 @3");
  EXPECT_LT((turned.arcs.at(0).axis - Vec3::UnitZ()).norm(), 1e-12);
  const ReadProgram mirrored = read_clean_as(fanuc, "G51.1 X0\nG0 X10 Y0\nG3 X0 Y10 I-10 F100");
  EXPECT_EQ(text_of(mirrored).back(), "arc 0 10 0 @3");
  EXPECT_LT((mirrored.arcs.at(0).axis + Vec3::UnitZ()).norm(), 1e-12);
}

TEST(IsoTransforms, ReferencePointsAreReachedAsFarAsTheyAreKnown) {
  const ReadProgram program =
      read_as(fanuc, "G0 X1 Z5\nG28 X10 Y10\nG91 G28 Z0\nG90 G0 X0\nG29 X3\nG30 P2 Y7");
  EXPECT_EQ(text_of(program),
            (Lines{"rapid 1 0 5 @1", "rapid 10 10 5 @2", "machine move 10 10 5 @2", "machine move 10 10 5 @3",
                   "machine move 0 10 5 @4", "machine move 10 10 5 @5", "machine move 3 10 5 @5",
                   "machine move 3 7 5 @6", "machine move 3 7 5 @6"}));
  ASSERT_EQ(program.diagnostics.size(), 3U);
  EXPECT_EQ(format(program.diagnostics[0], "f"),
            "f:2:1: warning: G28 moves to a machine position, which the program does not contain "
            "[reference-point] (neither drawn nor timed unless the machine gives positions (home_z_mm, "
            "part_zero_z_mm, ...); the path continues where every axis is programmed again)");
}

/// G10 L2 gives the zero point in coordinates of the machine, so that G53 is where the program says it.
TEST(IsoTransforms, MachineCoordinatesAreShownWhereTheProgramSetsItsZeroPoint) {
  for (const Dialect dialect : {fanuc, linuxcnc, Dialect::grbl}) {
    EXPECT_EQ(
        text_of(read_clean_as(dialect,
                              "G21 G10 L2 P1 X-290 Y-175 Z-20\nG54\nG0 X0 Y0 Z5\nG1 X10 F600\nG53 G0 Z0\n"
                              "G53 X-300 Y-180\nG53 G1 Z-1\nG0 X0 Y0")),
        (Lines{"rapid -290 -175 -15 @3", "line -280 -175 -15 @4", "rapid -280 -175 0 @5",
               "rapid -300 -180 0 @6", "line -300 -180 -1 @7", "rapid -290 -175 -1 @8"}));
  }
}

TEST(IsoTransforms, AnAxisWhoseZeroPointIsNotSetIsNotKnown) {
  const ReadProgram program =
      read_as(linuxcnc, "G21 G10 L2 P1 Z-20\nG0 X1 Y2 Z3\nG53 G0 Z0\nG53 G0 X0\nG55\nG53 Z1");
  EXPECT_EQ(text_of(program),
            (Lines{"rapid 1 2 -17 @2", "rapid 1 2 0 @3", "machine move 1 2 0 @4", "machine move 1 2 0 @6"}));
  EXPECT_EQ(program.machine_moves[0].end[0], (AxisPlace{AxisPlace::Kind::machine, 0}));
}

TEST(IsoTransforms, AZeroPointThatIsMeasuredFromTheToolIsKnownWhereTheToolIs) {
  EXPECT_EQ(text_of(read_clean_as(linuxcnc,
                                  "G21 G10 L2 P1 X100 Y0 Z0\nG0 X5\nG10 L20 P2 X1 Y0 Z0\nG55\nG53 G0 X7")),
            (Lines{"rapid 105 0 0 @2", "rapid 7 0 0 @5"}));
  EXPECT_EQ(read_as(linuxcnc, "G21 G0 X5\nG10 L20 P1 X1\nG53 G0 X7").diagnostics.size(), 1U);
}

TEST(IsoTransforms, G28ReturnsToWhereG281WasProgrammed) {
  for (const Dialect dialect : {linuxcnc, Dialect::grbl}) {
    EXPECT_EQ(text_of(read_clean_as(
                  dialect, "G21 G0 X10 Y20 Z5\nG28.1\nG0 X30 Y0 Z9\nG30.1\nG1 Z0 F600\nG28 Z7\nG28\nG30")),
              (Lines{"rapid 10 20 5 @1", "rapid 30 0 9 @3", "line 30 0 0 @5", "rapid 30 0 7 @6",
                     "rapid 30 0 5 @6", "rapid 10 20 5 @7", "rapid 30 0 9 @8"}));
  }
}

TEST(IsoTransforms, G92NamesAPositionOfTheMachine) {
  const std::string after = "G92 X0 Y0 Z0\nG91 G1 X1 F100\nG90 X5";
  const ReadProgram start = read_as(linuxcnc, "G21 G28\n" + after);
  EXPECT_EQ(text_of(start),
            (Lines{"machine move 0 0 0 @1", "machine move 0 0 0 @2", "line 1 0 0 @3", "line 5 0 0 @4"}));
  EXPECT_EQ(start.diagnostics.size(), 1U) << "G28 alone: nothing was moved before it";
  const ReadProgram later = read_as(linuxcnc, "G21 G0 X8\nG28\n" + after);
  EXPECT_EQ(text_of(later).back(), "line 13 0 0 @5");
  ASSERT_EQ(later.diagnostics.size(), 2U);
  EXPECT_EQ(
      format(later.diagnostics[1], "f"),
      "f:3:1: warning: G92 gives coordinates to a position that is not known [unknown-position] (the path "
      "continues where the axis was before the move to the machine position)");
}

struct FaultCase {
  const char* text;
  const char* expected;
};

class IsoCoordinateFault : public testing::TestWithParam<FaultCase> {};

TEST_P(IsoCoordinateFault, NamesWordAndWhatToDo) {
  const ReadProgram program = read_as(fanuc, GetParam().text);
  ASSERT_EQ(program.diagnostics.size(), 1U);
  EXPECT_EQ(format(program.diagnostics[0], "f"), GetParam().expected);
}

INSTANTIATE_TEST_SUITE_P(
    All, IsoCoordinateFault,
    testing::Values(
        FaultCase{"G0 X1\nG10 L2 P12 X5",
                  "f:2:8: error: P12 is not a work offset number from 0 to 9 [offset-number] (the block has "
                  "no effect on the path)"},
        FaultCase{"G54 G0 X1\nG54.1 P3 X1",
                  "f:2:1: warning: G54.1 P3 is selected after motion in G54 [work-offset] (offsets without a "
                  "value are assumed as zero, so parts of the path overlap; give them as an import option, "
                  "--offset G54.1P3=X,Y,Z)"},
        FaultCase{"G0 X1\nG10 L50\nG11",
                  "f:2:1: warning: G10 L50 (data setting) is not supported [unread-g] (the path is shown "
                  "without it)"},
        FaultCase{
            "G0 X1\nG68 X0 Y0",
            "f:2:1: error: G68 without R [rotation-angle] (the path is shown without it; write R with the "
            "angle)"},
        FaultCase{"G0 X1\nG68 X0 Y0 Z0 I0 J0 K0 R30",
                  "f:2:1: error: G68 with I0 J0 K0 has no rotation axis [rotation-angle] (the path is shown "
                  "without it)"},
        FaultCase{"G0 X1\nG68.2 P2 X0 Y0 Z0",
                  "f:2:7: error: G68.2 P2 (tilted working plane by points, vectors or projection angles) is "
                  "not supported [unread-g] (the path is shown without it)"},
        FaultCase{
            "G0 X1\nG51 X0 Y0",
            "f:2:1: error: G51 without P [scale-factor] (the path is shown without it; write P with the "
            "factor)"},
        FaultCase{"G0 X1\nG51 X0 Y0 P0",
                  "f:2:11: error: scale factor P0 is zero [scale-factor] (1 is used; write a factor other "
                  "than zero)"},
        FaultCase{
            "G0 X1\nG53 Z0",
            "f:2:1: warning: G53 moves to a machine position, which the program does not contain "
            "[machine-position] (neither drawn nor timed unless the machine gives positions (home_z_mm, "
            "part_zero_z_mm, ...); the path continues where every axis is programmed again)"},
        FaultCase{"G93 G1 X1 F2\nX2",
                  "f:2:1: error: a feed move without F under G93 [feed-missing] (the last F is used; write F "
                  "in every such block)"},
        FaultCase{"G0 X1\nG15 G69 G50 G98 G92.1 G92.2 G92.3 G50.1 G16",
                  "f:2:41: error: G16 exceeds the 8 G words of coordinates that a block can have "
                  "[too-many-g] (it is skipped; write it in a block of its own)"}));

TEST(IsoTransforms, FeedIsInverseTimeOrPerRevolution) {
  EXPECT_EQ(read_clean_as(linuxcnc, "G93 G1 X10 F6").motions.at(0).feed, 1) << "10 mm in a sixth of a minute";
  EXPECT_EQ(read_clean_as(fanuc, "G95 S1200 G1 X10 F0.5").motions.at(0).feed, 10);
  EXPECT_EQ(read_clean_as(fanuc, "G95 S1200 G1 X10 F0.5\nG94 X20 F60").motions.at(1).feed, 1);
}

/// What a program with a tilted plane moves; that it is tilted is all that may be said.
Lines tilted(const std::string& text) {
  const ReadProgram program = read_as(Dialect::fanuc, text);
  EXPECT_FALSE(program.diagnostics.empty()) << text;
  for (const Diagnostic& diagnostic : program.diagnostics) {
    EXPECT_EQ(diagnostic.code, "tilted-plane");
  }
  return text_of(program);
}

TEST(IsoTiltedPlane, StandsOnTheFacesOfACube) {
  // A cube of 50: the plane's X runs along the lower edge, its Y up, its Z out of the face.
  EXPECT_EQ(tilted("G68.2 X0 Y0 Z-50 I0 J90 K0\nG0 X10 Y20 Z5"), (Lines{"rapid 10 -5 -30 @2"})) << "front";
  EXPECT_EQ(tilted("G68.2 X50 Y0 Z-50 I90 J90 K0\nG0 X10 Y20 Z5"), (Lines{"rapid 55 10 -30 @2"})) << "right";
  EXPECT_EQ(tilted("G68.2 X50 Y50 Z-50 I180 J90 K0\nG0 X10 Y20 Z5"), (Lines{"rapid 40 55 -30 @2"})) << "back";
  EXPECT_EQ(tilted("G68.2 X0 Y50 Z-50 I-90 J90 K0\nG0 X10 Y20 Z5"), (Lines{"rapid -5 40 -30 @2"})) << "left";
}

TEST(IsoTiltedPlane, TurnsLastAboutItsOwnZAndEnds) {
  EXPECT_EQ(tilted("G68.2 X0 Y0 Z0 I0 J90 K90\nG0 X10 Y0 Z0\nG69\nX1 Y2 Z3"),
            (Lines{"rapid 0 0 10 @2", "rapid 1 2 3 @4"}));
}

TEST(IsoTiltedPlane, LiesOnTheWorkOffsetAndReplacesTheOneBefore) {
  EXPECT_EQ(tilted("G10 L2 P1 X100\nG54\nG68.2 X0 Y0 Z0 I0 J0 K90\nG68.2 X1 Y0 Z0 I0 J90 K0\nG0 X10 Y20 Z5"),
            (Lines{"rapid 111 -5 20 @5"}));
}

TEST(IsoTiltedPlane, RollPitchYawMakesTheSamePlane) {
  // One plane in two ways, as in the tests of a LinuxCNC with G68.2.
  const auto end = [](const std::string& words) {
    return read_as(Dialect::fanuc, "G68.2 " + words + "\nG0 X1 Y2 Z3").motions.back().target;
  };
  const Vec3 euler = end("X10 Y20 Z30 I25 J40 K-15");
  EXPECT_NEAR((end("P1 Q123 X10 Y20 Z30 I39.025043525 J9.576578516 K13.400523974") - euler).norm(), 0, 1e-7);
  // First about Z, then about X: what lay on X goes to Y, and from there to Z.
  EXPECT_NEAR((end("P1 Q321 X0 Y0 Z0 I90 J0 K90") - Vec3(-2, -3, 1)).norm(), 0, 1e-12);
  EXPECT_NEAR((end("X0 Y0 Z0 I0 J0 K0 R90") - Vec3(-2, 1, 3)).norm(), 0, 1e-12);
}

TEST(IsoLocalShift, OfLinuxcncIsThatOfG92) {
  EXPECT_EQ(text_of(read_clean_as(Dialect::linuxcnc, "G92 X1 Y2\nG52 X5\nG0 X0 Y0\nG92.1\nX0 Y0")),
            (Lines{"rapid 5 -2 0 @3", "rapid 0 0 0 @5"}));
}

TEST(IsoTiltedPlane, ArcsTiltToo) {
  const ReadProgram program =
      read_as(Dialect::fanuc, "G68.2 X0 Y0 Z0 I0 J90 K0\nG0 X10 Y0 Z0\nG3 X0 Y10 I-10 F100");
  ASSERT_EQ(program.arcs.size(), 1U);
  EXPECT_NEAR((program.arcs[0].axis - Vec3(0, -1, 0)).norm(), 0, 1e-12);
  EXPECT_NEAR((program.motions.back().target - Vec3(0, 0, 10)).norm(), 0, 1e-12);
}

TEST(IsoTiltedPlane, RotationsInSpaceFollowEachOther) {
  EXPECT_EQ(tilted("G68 X0 Y0 Z0 I1 J0 K0 R90\nG0 X1 Y2 Z3"), (Lines{"rapid 1 -3 2 @2"}));
  EXPECT_EQ(tilted("G68 X10 Y0 Z0 I0 J1 K0 R90\nG0 X11 Y0 Z0"), (Lines{"rapid 10 0 -1 @2"}));
  // The second one turns about the X that the first one has turned to Y.
  const ReadProgram twice =
      read_as(Dialect::fanuc, "G68 X0 Y0 Z0 I0 J0 K1 R90\nG68 X0 Y0 Z0 I1 J0 K0 R90\nG0 X0 Y10 Z0");
  EXPECT_EQ(text_of(twice), (Lines{"rapid 0 0 10 @3"}));
}

}  // namespace
}  // namespace feedscope

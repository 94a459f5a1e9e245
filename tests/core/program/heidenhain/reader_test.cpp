#include <gtest/gtest.h>

#include "core/base/units.h"
#include "tests/core/program/heidenhain/read_heidenhain.h"

namespace feedscope {
namespace {

TEST(HeidenhainReader, LinesRapidsAndFeedsOfAWholeProgram) {
  const ReadProgram program = read_clean_heidenhain(
      "0  BEGIN PGM PLATE MM\n"
      "1  BLK FORM 0.1 Z X+0 Y+0 Z-20\n"
      "2  BLK FORM 0.2 X+100 Y+80 Z+0\n"
      "3  ; the first tool\n"
      "4  * - Roughing\n"
      "5  TOOL CALL 5 Z S3000 F400\n"
      "6  L X+10 Y-5,5 R0 FMAX M3\n"
      "7  L Z-2 F300\n"
      "8  L IX+20\n"
      "9  L IY-1.5 IZ+1 F AUTO\n"
      "10 L Z+50 FMAX M2\n"
      "11 END PGM PLATE MM\n");
  EXPECT_EQ(path_of(program), "r10,-5.5,0 10,-5.5,-2 30,-5.5,-2 30,-7,-1 r30,-7,50");
  EXPECT_EQ(program.motions[1].feed, 5);
  EXPECT_EQ(program.motions[2].feed, 5);
  EXPECT_NEAR(program.motions[3].feed, 400.0 / 60, 1e-12);
  EXPECT_EQ(program.motions[3].line, 10U);
  EXPECT_EQ(program.block_count, 9U);
  EXPECT_EQ(program.dialect, Dialect::heidenhain);
  ASSERT_EQ(program.tools.size(), 1U);
  EXPECT_EQ(program.tools[0].name, "5");
}

TEST(HeidenhainReader, RapidHoldsForItsBlockOnly) {
  const ReadProgram program = read_clean_heidenhain("L X+1 F600\nL X+2 FMAX\nL X+3\nL X+4 F MAX\nL X+5\n");
  EXPECT_EQ(path_of(program), "1,0,0 r2,0,0 3,0,0 r4,0,0 5,0,0");
  EXPECT_EQ(program.motions[2].feed, 10);
}

TEST(HeidenhainReader, InchProgramsCountLengthsInInchesAndFeedsInTenths) {
  const ReadProgram program = read_clean_heidenhain("BEGIN PGM A INCH\nL X+1 Y-0.5 F100\nEND PGM A INCH\n");
  EXPECT_EQ(path_of(program), "25.4,-12.7,0");
  EXPECT_NEAR(program.motions[0].feed, 254.0 / 60, 1e-12);
}

TEST(HeidenhainReader, FeedsPerRevolutionAndTooth) {
  EXPECT_NEAR(read_clean_heidenhain("TOOL CALL 1 Z S600\nL X+1 FU0.5\n").motions[0].feed, 5, 1e-12);
  EXPECT_NEAR(
      read_clean_heidenhain("TOOL CALL 1 Z S600\nL M136\nL X+1 F0.3\nL M137\nL X+2 F60\n").motions[0].feed, 3,
      1e-12);
  EXPECT_NEAR(read_heidenhain("TOOL CALL 1 Z S600\nL X+1 FZ0.1\n").motions[0].feed, 1, 1e-12);
  EXPECT_NEAR(read_clean_heidenhain("TOOL CALL 1 Z S600 FU0.5\nL X+1\n").motions[0].feed, 5, 1e-12);
}

TEST(HeidenhainReader, FeedOfTheToolCallHoldsUntilAnother) {
  const ReadProgram program = read_clean_heidenhain(
      "TOOL CALL 1 Z S600 F300\nL X+1\nL X+2 F600\nL X+3 F AUTO\nL X+4 F60\nTOOL CALL 2 Z F120\nL X+5\n");
  std::vector<double> feeds;
  for (const MotionBlock& block : program.motions) {
    feeds.push_back(block.feed);
  }
  EXPECT_EQ(feeds, (std::vector<double>{5, 10, 5, 1, 2}));
}

TEST(HeidenhainReader, ARemarkMayGoOn) {
  EXPECT_EQ(
      path_of(read_clean_heidenhain("1 ;a long remark that goes~\n L X+5 FMAX on~\n and ends\n2 L X+1 FMAX\n"
                                    "CYCL DEF 9.0 DWELL ;no remark goes on\nCYCL DEF 9.1 ;time~\n 0.5\n")),
      "r1,0,0 0.5s");
}

TEST(HeidenhainReader, NumbersWithNAndSetupSheetsOfCamSystems) {
  EXPECT_EQ(path_of(read_clean_heidenhain(
                "( sheet\n(   machine: \"DMU 50\"\nBEGIN PGM 02 MM\nN1 L X+5 FMAX\nN2 CALL LBL 1\n"
                "N3 L M30\nN4 LBL 1\n/N5 L X+6 FMAX\nN6 LBL 0\n")),
            "r5,0,0 r6,0,0");
}

TEST(HeidenhainReader, WordsWithoutAValueOfOlderControls) {
  EXPECT_EQ(path_of(read_clean_heidenhain("L X+10,000 Y+20,000 R F150 M\nL Z-5 R0 F M3\n")),
            "10,20,0 10,20,-5");
}

TEST(HeidenhainReader, ArcsTakeAnAxisAlongByLin) {
  EXPECT_EQ(
      path_of(read_clean_heidenhain("L X+10 F60\nCC X+0 Y+0\nC X+0 Y+10 LIN_Z-5 DR+\nCT X-10 Y+0 LIN_Z-6\n")),
      "10,0,0 0,10,-5(+Z) -10,0,-6(+Z)");
}

TEST(HeidenhainReader, OnThePoleTheAngleIsTheLastOne) {
  EXPECT_EQ(path_of(read_clean_heidenhain("CC X+10 Y+0\nLP PR+5 PA+90 F60\nLP PR+0\nLP PR+7\n")),
            "10,5,0 10,0,0 10,7,0");
}

TEST(HeidenhainReader, DwellsOfFunctionDwell) {
  EXPECT_EQ(path_of(read_clean_heidenhain("Q1=2\nL X+1 FMAX\nFUNCTION DWELL TIME+Q1\nTOOL CALL 1 Z S120\n"
                                          "FUNCTION DWELL REV5\nFUNCTION RESET TCPM\nFUNCTION MODE MILL\n")),
            "r1,0,0 2s 2.5s");
}

TEST(HeidenhainReader, UpperCornerOfTheBlankMayBeIncremental) {
  read_clean_heidenhain("BLK FORM 0.1 Z X-5 Y-5 Z-30\nBLK FORM 0.2 IX+10 IY+10 IZ+30\nL X+1 FMAX\n");
}

TEST(HeidenhainReader, PositionsOfSingleAxesStandWithoutAName) {
  EXPECT_EQ(path_of(read_clean_heidenhain("X+5 F100\nIY-2\nZ 3.5 FMAX\n")), "5,0,0 5,-2,0 r5,-2,3.5");
}

TEST(HeidenhainReader, SmallLettersAndHiddenBlocks) {
  const std::string text = "l x+1 f100\n/2 L X+2\n3 / L X+3\n";
  EXPECT_EQ(path_of(read_clean_heidenhain(text)), "1,0,0 2,0,0 3,0,0");
  EXPECT_EQ(path_of(read_clean_heidenhain(text, {.skip_deleted_blocks = true})), "1,0,0");
}

TEST(HeidenhainReader, WordsOfMFunctionsAreNotPositions) {
  EXPECT_EQ(path_of(read_clean_heidenhain("L X+1 F100 M118 X2 Y3 Z1\nL Y+1 M120 LA10\nL Z+1 M138 C\n")),
            "1,0,0 1,1,0 1,1,1");
}

TEST(HeidenhainReader, LookAheadOfM120IsAPathControl) {
  const ReadProgram program = read_clean_heidenhain("L X+1 F100\nL X+2 M120 LA10\n");
  EXPECT_EQ(program.path_controls.at(program.motions[0].path_control).look_ahead, Switch::machine);
  EXPECT_EQ(program.path_controls.at(program.motions[1].path_control).look_ahead, Switch::on);
}

TEST(HeidenhainReader, RetractsAlongTheToolAxis) {
  EXPECT_EQ(path_of(read_clean_heidenhain("L X+1 F100\nL M140 MB50\n")), "1,0,0 r1,0,50");
  EXPECT_EQ(path_of(read_clean_heidenhain("TOOL CALL 1 X S100\nL X+1 F100\nL M140 MB20 F300\n")),
            "1,0,0 21,0,0");
}

TEST(HeidenhainReader, AToleranceOfZeroIsTheMachines) {
  const ReadProgram program =
      read_clean_heidenhain("CYCL DEF 32.1 T0.05\nL X+1 F100\nCYCL DEF 32.1 T0\nL X+2\n");
  EXPECT_EQ(program.path_controls.at(program.motions[0].path_control).contour_tolerance, 0.05);
  EXPECT_EQ(program.path_controls.at(program.motions[1].path_control), PathControl());
}

struct ArcCase {
  const char* text;
  const char* path;
  Vec3 center;
};
void PrintTo(const ArcCase& c, std::ostream* out) {
  *out << c.text;
}
class HeidenhainArc : public testing::TestWithParam<ArcCase> {};

TEST_P(HeidenhainArc, HasTheCentreAndTurnOfItsWords) {
  const ReadProgram program = read_clean_heidenhain(GetParam().text);
  EXPECT_EQ(path_of(program), GetParam().path);
  ASSERT_FALSE(program.arcs.empty());
  EXPECT_LT((program.arcs.back().center - GetParam().center).norm(), 1e-9);
}

INSTANTIATE_TEST_SUITE_P(
    Words, HeidenhainArc,
    testing::Values(
        ArcCase{"L X+10 F60\nCC X+0 Y+0\nC X+0 Y+10 DR+\n", "10,0,0 0,10,0(+Z)", {0, 0, 0}},
        ArcCase{"L X+10 F60\nCC X+0 Y+0\nC X+0 Y-10 DR-\n", "10,0,0 0,-10,0(-Z)", {0, 0, 0}},
        // The other coordinate stays.
        ArcCase{"L X+10 F60\nCC X+0 Y+0\nC X-10 DR+\n", "10,0,0 -10,0,0(+Z)", {0, 0, 0}},
        ArcCase{"L X+10 F60\nCC IX-10 IY+0\nC DR-\n", "10,0,0 10,0,0(-Z+1)", {0, 0, 0}},
        // The pole is the last position.
        ArcCase{"L X+5 Y+5 F60\nCC\nL X+10\nC X+5 Y+10 DR+\n", "5,5,0 10,5,0 5,10,0(+Z)", {5, 5, 0}},
        ArcCase{"L X+10 F60\nCR X+0 Y+10 R+10 DR+\n", "10,0,0 0,10,0(+Z)", {0, 0, 0}},
        ArcCase{"L X+10 F60\nCR X+0 Y+10 R-10 DR+\n", "10,0,0 0,10,0(+Z)", {10, 10, 0}},
        ArcCase{"L X+10 F60\nCR X+0 Y+10 R10 DR-\n", "10,0,0 0,10,0(-Z)", {10, 10, 0}},
        // A quarter circle that goes on along X.
        ArcCase{"L X+10 F60\nCT X+15 Y+5\n", "10,0,0 15,5,0(+Z)", {10, 5, 0}},
        ArcCase{"L X+10 F60\nCT X+15 Y-5\n", "10,0,0 15,-5,0(-Z)", {10, -5, 0}},
        ArcCase{"L X+10 F60\nCC X+0 Y+0\nCP PA+90 DR+\n", "10,0,0 0,10,0(+Z)", {0, 0, 0}},
        ArcCase{"L X+10 F60\nCC X+0 Y+0\nCP IPA+90\n", "10,0,0 0,10,0(+Z)", {0, 0, 0}},
        ArcCase{"L X+10 F60\nCC X+0 Y+0\nCP IPA-90 DR-\n", "10,0,0 0,-10,0(-Z)", {0, 0, 0}},
        // Two and a half turns down.
        ArcCase{"L X+10 F60\nCC X+0 Y+0\nCP IPA+900 IZ-5 DR+\n", "10,0,0 -10,0,-5(+Z+2)", {0, 0, 0}},
        ArcCase{"L X+10 F60\nCC X+0 Y+0\nCP IPA-1080 Z-3 DR-\n", "10,0,0 10,0,-3(-Z+3)", {0, 0, 0}},
        ArcCase{"L X+10 F60\nCC X+0 Y+0\nLP PR+9 PA+0\nLP PR+10\nCTP PR+10 PA+90\n",
                "10,0,0 9,0,0 10,0,0 0,10,0(+Z)",
                {10, 10, 0}},
        // Tool axis Y: the plane is ZX; tool axis X: YZ.
        ArcCase{"TOOL CALL 1 Y S1\nL Z+10 F60\nCC Z+0 X+0\nC Z+0 X+10 DR+\n", "0,0,10 10,0,0(+Y)", {0, 0, 0}},
        ArcCase{"TOOL CALL 1 X S1\nL Y+10 F60\nCR Y+0 Z+10 R+10 DR+\n", "0,10,0 0,0,10(+X)", {0, 0, 0}},
        // A circle that is not in the working plane: its pole names the plane.
        ArcCase{
            "TOOL CALL 1 Z S1\nL X+10 F60\nCC X+0 Z+0\nC X+0 Z+10 DR-\n", "10,0,0 0,0,10(-Y)", {0, 0, 0}}));

TEST(HeidenhainReader, PolarLinesStartFromThePole) {
  EXPECT_EQ(
      path_of(read_clean_heidenhain("CC X+45 Y+25\nLP PR+30 PA+0 F100\nLP PA+90\nLP IPA+90\nLP IPR-10 PA+180 "
                                    "FMAX\nLP PR+5 PA-90 Z+7\n")),
      "75,25,0 45,55,0 15,25,0 r25,25,0 45,20,7");
}

TEST(HeidenhainReader, ParametersStandForNumbers) {
  EXPECT_EQ(path_of(read_clean_heidenhain("Q1 = 5\nQL2=-3\nQR3 = +1,5\nQ4 = 600\nL X+Q1 Y-QL2 Z+QR3 FQ4\n")),
            "5,3,1.5");
}

TEST(HeidenhainReader, ToleranceOfCycle32IsAPathControl) {
  const ReadProgram program = read_clean_heidenhain(
      "L X+1 F100\nCYCL DEF 32.0 TOLERANCE\nCYCL DEF 32.1 T0.05\nL X+2\nCYCL DEF 32.1 T0.02\nCYCL DEF 32.2 "
      "TA5\nL X+3\nCYCL DEF 32.0 TOLERANCE\nCYCL DEF 32.1\nL X+4\n");
  const auto control = [&](std::size_t i) {
    return program.path_controls.at(program.motions.at(i).path_control);
  };
  EXPECT_EQ(control(0), PathControl{});
  EXPECT_EQ(control(1).contour_tolerance, 0.05);
  EXPECT_EQ(control(1).mode, PathMode::continuous);
  EXPECT_EQ(control(2).contour_tolerance, 0.02);
  EXPECT_NEAR(control(2).orientation_tolerance.value(), units::from_deg(5), 1e-15);
  EXPECT_EQ(control(3), PathControl{});
}

TEST(HeidenhainReader, HscModeChangesNothingAndSaysSo) {
  const ReadProgram program = read_heidenhain(
      "L X+1 F100\nCYCL DEF 32.0 TOLERANCE\nCYCL DEF 32.1 T0.05\nCYCL DEF 32.2 HSC-MODE:1 TA5\nL X+2\n");
  ASSERT_EQ(program.diagnostics.size(), 1U);
  EXPECT_EQ(format(program.diagnostics.front(), "f"),
            "f:4:1: info: HSC-MODE 1 changes nothing in the simulation [machining-mode] (its parameters "
            "exist only in "
            "the control; set acceleration and jerk of the machine instead)");
  const PathControl& control = program.path_controls.at(program.motions.back().path_control);
  EXPECT_NEAR(control.orientation_tolerance.value(), units::from_deg(5), 1e-15) << "what follows it is read";
}

TEST(HeidenhainReader, DwellsAreCycle9) {
  const ReadProgram program = read_clean_heidenhain(
      "L X+5 F100\nCYCL DEF 9.0 DWELL TIME\nCYCL DEF 9.1 DWELL 1.5\nCYCLE DEF 9.1 5\nCYCL DEF 9.1 "
      "V.ZEIT0,5\n");
  EXPECT_EQ(path_of(program), "5,0,0 1.5s 5s 0.5s");
}

struct FrameCase {
  const char* cycles;
  Vec3 shown;  ///< of X+10 Y+2 Z+1
};
void PrintTo(const FrameCase& c, std::ostream* out) {
  *out << c.cycles;
}
class HeidenhainFrame : public testing::TestWithParam<FrameCase> {};

TEST_P(HeidenhainFrame, MovesWhatIsProgrammed) {
  const ReadProgram program = read_clean_heidenhain(std::string(GetParam().cycles) + "L X+10 Y+2 Z+1 F100\n");
  EXPECT_LT((end_of(program) - GetParam().shown).norm(), 1e-12) << end_of(program).transpose();
}

INSTANTIATE_TEST_SUITE_P(
    Cycles, HeidenhainFrame,
    testing::Values(
        FrameCase{"CYCL DEF 7.0 DATUM SHIFT\nCYCL DEF 7.1 X+100\nCYCL DEF 7.2 Y-5\n", {110, -3, 1}},
        FrameCase{"CYCL DEF 7.1 X+100\nCYCL DEF 7.1 IX+10\nCYCL DEF 7.3 Z+5\n", {120, 2, 6}},
        FrameCase{"CYCL DEF 7.1 X+100\nCYCL DEF 7.1 X+0\n", {10, 2, 1}},
        FrameCase{"CYCL DEF 8.0 MIRROR IMAGE\nCYCL DEF 8.1 X\n", {-10, 2, 1}},
        FrameCase{"CYCL DEF 8.1 X Y\nCYCL DEF 8.1\n", {10, 2, 1}},
        FrameCase{"CYCL DEF 10.0 ROTATION\nCYCL DEF 10.1 ROT+90\n", {-2, 10, 1}},
        FrameCase{"CYCL DEF 10.1 ROT+45\nCYCL DEF 10.1 IROT+45\n", {-2, 10, 1}},
        FrameCase{"CYCL DEF 11.0 SCALING\nCYCL DEF 11.1 SCL 0.5\n", {5, 1, 0.5}},
        FrameCase{"CYCL DEF 26.0 AXIS-SPEC. SCALING\nCYCL DEF 26.1 X 1.5 Y 0,5 CCX+4 CCY+0\n", {13, 1, 1}},
        // Each in the coordinates that those before it have made.
        FrameCase{"CYCL DEF 7.1 X+100\nCYCL DEF 10.1 ROT+90\n", {98, 10, 1}},
        FrameCase{"CYCL DEF 10.1 ROT+90\nCYCL DEF 7.1 X+100\n", {-2, 110, 1}},
        FrameCase{"CYCL DEF 7.1 X+100\nCYCL DEF 10.1 ROT+90\nCYCL DEF 7.1 X+50\n", {48, 10, 1}},
        FrameCase{"TRANS DATUM AXIS X+100 Y+1\nTRANS MIRROR AXIS Y\n", {110, -1, 1}},
        FrameCase{"TRANS ROTATION ROT+90\nTRANS ROTATION RESET\nTRANS SCALE SCL2\n", {20, 4, 2}},
        FrameCase{"TRANS DATUM AXIS X+9\nTRANS DATUM RESET\nTRANS MIRROR AXIS X\nTRANS MIRROR RESET\n"
                  "TRANS SCALE SCL2\nTRANS SCALE RESET\n",
                  {10, 2, 1}}));

TEST(HeidenhainReader, StatementsGoOnBehindATilde) {
  const ReadProgram program = read_clean_heidenhain("L X+1 ~\n  Y+2 ; half way ~\n  F100\nL X+5\n");
  EXPECT_EQ(path_of(program), "1,2,0 5,2,0");
  EXPECT_EQ(program.block_count, 2U);
}

}  // namespace
}  // namespace feedscope

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/base/units.h"
#include "tests/core/program/heidenhain/read_heidenhain.h"

namespace feedscope {
namespace {

ReadProgram read_din(std::string text) {
  return read_heidenhain(std::move(text), {.dialect = Dialect::heidenhain_iso});
}
ReadProgram read_clean_din(std::string text) {
  return read_clean_heidenhain(std::move(text), {.dialect = Dialect::heidenhain_iso});
}

TEST(HeidenhainIso, AWholeProgramIsRecognisedAndRead) {
  const ReadProgram program = read_clean_heidenhain(
      "%PLATE G71 *\n"
      "N10 G30 G17 X+0 Y+0 Z-20*\n"
      "N20 G31 G90 X+100 Y+80 Z+0*\n"
      "N30 * - Roughing *\n"
      "N40 G99 T5 L+0 R+3 *\n"
      "N50 T5 G17 S3000 F400 *\n"
      "N60 G00 G40 G90 X+10 Y-5,5 M3 *\n"
      "N70 G01 Z-2 F300 *\n"
      "N80 G91 X+20 *\n"
      "N90 Y-1.5 Z+1 ; down *\n"
      "N100 G00 G90 Z+50 M2 *\n"
      "N99999999 %PLATE G71 *\n",
      {.dialect = Dialect::heidenhain_iso});
  EXPECT_EQ(path_of(program), "r10,-5.5,0 10,-5.5,-2 30,-5.5,-2 30,-7,-1 r30,-7,50");
  EXPECT_EQ(program.motions[1].feed, 5);
  EXPECT_EQ(program.tools.at(0).name, "5");
  EXPECT_EQ(recognise(SourceText("plate.i", "%PLATE G71 *\nN10 G00 X+1 *\nN99 %PLATE G71 *\n")),
            Dialect::heidenhain_iso);
}

TEST(HeidenhainIso, ABlockNumberIsNoValue) {
  const ReadProgram program =
      read_din("%A G71 *\nN6464646464646464 G01 X+1 F100 *\nN20 M2 *\nN99999999999 G01 X+2 *\n");
  EXPECT_EQ(path_of(program), "1,0,0");
  ASSERT_EQ(program.diagnostics.size(), 1U);
  EXPECT_EQ(program.diagnostics[0].code, "text-after-end");
}

struct DinCase {
  const char* text;
  const char* path;
};
void PrintTo(const DinCase& c, std::ostream* out) {
  *out << c.text;
}
class HeidenhainIsoWords : public testing::TestWithParam<DinCase> {};

TEST_P(HeidenhainIsoWords, MoveAsWritten) {
  EXPECT_EQ(path_of(read_clean_din(GetParam().text)), GetParam().path);
}

INSTANTIATE_TEST_SUITE_P(
    Words, HeidenhainIsoWords,
    testing::Values(
        DinCase{"%A G70 *\nN1 G01 X+1 F100 *\n", "25.4,0,0"},
        DinCase{"G01 X+10 F60*\nG03 X+0 Y+10 I+0 J+0*\nG02 X-10 Y0 R+10*\n", "10,0,0 0,10,0(+Z) -10,0,0(-Z)"},
        DinCase{"I+0 J+0*\nG01 X+10 F60*\nG02*\nG05 X+0 Y-10*\n", "10,0,0 10,0,0(-Z+1) 0,-10,0(-Z)"},
        DinCase{"G01 X+10 F60*\nG06 X+15 Y+5*\nG07 Z+1*\n", "10,0,0 15,5,0(+Z) 15,5,1"},
        DinCase{"G29*\nG11 R+10 H+0 F60*\nG13 H+90*\nG91 G12 H-450 Z-5*\n",
                "10,0,0 0,10,0(+Z) 10,0,-5(-Z+1)"},
        DinCase{"I+0 J+0*\nG10 R+10 H+90*\nG01 X+0 Y+11 F60*\nG16 R+21 H+90*\n", "r0,10,0 0,11,0 0,21,0"},
        DinCase{"G01 X+10 F60*\nG25 R3*\nY+10*\nG24 R2*\nX+0*\n", "7,0,0 10,3,0(+Z) 10,8,0 8,10,0 0,10,0"},
        DinCase{"G99 T1 L+0 R+2*\nT1 G17 S100*\nG00 X-20 Y0*\nG01 G41 X+0 Y+0 F60*\nY+20*\nG40 X-20*\n",
                "r-20,0,0 -2,0,0 -2,20,0 -20,20,0"},
        // Onto the contour and off it on quarter circles: the lines touch them.
        DinCase{"G99 T1 L+0 R+0*\nT1 G17*\nG00 X-5 Y-20*\nG01 G42 X+0 Y+0 F60*\nG26 R5*\nX+30*\nG27 R5*\n"
                "G00 G40 X+35 Y-20*\n",
                "r-5,-20,0 -5,-5,0 0,0,0(-Z) 30,0,0 35,-5,0(-Z) r35,-20,0"},
        DinCase{"G01 X+1 F60*\nL7,0*\nX+2*\nL7*\nM30*\nG98 L7*\nG91 Y+1*\nG90*\nG98 L0*\n",
                "1,0,0 1,1,0 2,1,0 2,2,0"},
        DinCase{"G98 L1*\nG91 G01 X+1 F60*\nL1,2*\n", "1,0,0 2,0,0 3,0,0"},
        DinCase{"D00 Q1 P01 +0*\nG98 L1*\nD01 Q1 P01 +Q1 P02 +2*\nG01 X+Q1 F60*\nD12 P01 +Q1 P02 +5 P03 1*\n",
                "2,0,0 4,0,0 6,0,0"},
        DinCase{"Q2 = SQRT 16*\nG01 X+Q2 F60*\nD18: SYSREAD Q3 = ID270 NR1 IDX1*\nY+Q3*\n", "4,0,0 4,4,0"},
        DinCase{
            "G54 X+10*\nG28 Y*\nG73 G90 H+0*\nG72 F2*\nG01 X+1 Y+1 F60*\nG28*\nG72 F1*\nG54 X+0*\nX+2 Y+1*\n",
            "12,-2,0 2,1,0"},
        DinCase{"G73 H+90*\nG01 X+1 F60*\n", "0,1,0"}, DinCase{"G01 X+1 F60*\nG04 F1,5*\n", "1,0,0 1.5s"},
        DinCase{"T1 G17 S100*\nG00 Z+5*\nG83 P01 -2 P02 -10 P03 -6 P04 0 P05 100*\nX+1 M99*\n",
                "r0,0,5 r1,0,5 1,0,-3 r1,0,5 r1,0,-2.4 1,0,-7 r1,0,5"},
        DinCase{
            "T1 G17 S100*\nG00 Z+5*\nG200 DRILLING ~\nQ200=2 ;CLEARANCE ~\nQ201=-4 ~\nQ206=100 ~\nQ202=5 ~\n"
            "Q210=0 ~\nQ203=0 ~\nQ204=10 ~\nQ211=0*\nG79 M3*\n",
            "r0,0,5 r0,0,2 0,0,-4 r0,0,2 r0,0,10"}));

TEST(HeidenhainIso, ToleranceIsAPathControl) {
  const ReadProgram program = read_clean_din("G62 T0.05 P01 0 P02 5*\nG01 X+1 F60*\nG62*\nX+2*\n");
  EXPECT_EQ(program.path_controls.at(program.motions[0].path_control).contour_tolerance, 0.05);
  EXPECT_NEAR(program.path_controls.at(program.motions[0].path_control).orientation_tolerance.value(),
              units::from_deg(5), 1e-15);
  EXPECT_EQ(program.path_controls.at(program.motions[1].path_control), PathControl{});
}

struct DinDiagnostic {
  const char* text;
  const char* said;
};
void PrintTo(const DinDiagnostic& c, std::ostream* out) {
  *out << c.text;
}
class HeidenhainIsoDiagnostic : public testing::TestWithParam<DinDiagnostic> {};

TEST_P(HeidenhainIsoDiagnostic, SaysPlaceThingAndValue) {
  std::vector<std::string> said;
  for (const Diagnostic& d : read_din(GetParam().text).diagnostics) {
    said.push_back(fmt::format("{}:{}: {}: {} [{}]", d.line, d.column, to_string(d.severity),
                               d.message.english(), d.code));
  }
  EXPECT_THAT(said, testing::Contains(GetParam().said));
}

INSTANTIATE_TEST_SUITE_P(
    Words, HeidenhainIsoDiagnostic,
    testing::Values(
        DinDiagnostic{"N1 X+1*\n", "1:4: warning: coordinates before the first of G0 to G16 [motion-mode]"},
        DinDiagnostic{"G01 G08 X+1 F9*\n", "1:1: error: G8 is not supported in this dialect [unknown-g]"},
        DinDiagnostic{"G75 P01 2*\n", "1:1: error: cycle 75 is not supported [unread-cycle]"},
        DinDiagnostic{"G251 POCKET Q218=5*\n",
                      "1:1: error: cycle 251 (POCKET ) is not supported [unread-cycle]"},
        DinDiagnostic{"G01 E5*\n", "1:5: error: \"E5\" is not valid in a block [unread-word]"},
        DinDiagnostic{"G X5*\n", "1:1: error: G without a number [malformed-number]"},
        DinDiagnostic{"G25 X5*\n", "1:1: error: G25 without R [corner]"},
        DinDiagnostic{
            "G26 R5*\n",
            "1:1: error: the preceding block is not a line to the first point of the contour [approach]"},
        DinDiagnostic{"G62 T-1*\n", "1:1: error: the tolerance T-1 is below zero [tolerance]"},
        DinDiagnostic{"G72 F0*\n",
                      "1:1: error: scaling factor 0 is not from 0.000001 to 99.999999 [scale-factor]"},
        DinDiagnostic{"D00 Q5 X5*\n", "1:8: error: \"X5\" is not valid in D [unread-word]"},
        DinDiagnostic{"%SUB *\n",
                      "1:1: error: program \"SUB\" was not found in the same folder [subprogram]"},
        DinDiagnostic{
            "G00 X1*\nG53 P01 3*\n",
            "2:1: warning: a line of the datum table changes the datum after a motion [work-offset]"}));

TEST(HeidenhainIso, SoftApproachAndDepartureHaveTheirOwnFeeds) {
  const ReadProgram program = read_din(
      "%A G71 *\nN10 G99 T1 L+0 R+10 *\nN20 T1 G17 S9 *\nN30 G00 G40 G90 X-10 Y-10 *\nN40 G01 Z-5 F1000 *\n"
      "N50 G01 G41 X+5 Y+5 F300 *\nN60 G26 R5 F150 *\nN70 Y+95 *\nN80 G27 R5 F500 *\nN90 G40 X-20 Y+120 "
      "F1200 *\n"
      "N99 %A G71 *\n");
  EXPECT_TRUE(program.diagnostics.empty());
  std::vector<double> feeds;
  for (const MotionBlock& block : program.motions) {
    feeds.push_back(std::round(block.feed * 60));
  }
  EXPECT_EQ(feeds, (std::vector<double>{0, 1000, 300, 150, 300, 500, 1200}));
}

TEST(HeidenhainIso, ACallWithCoordinatesMovesAsTheModeSays) {
  EXPECT_EQ(
      path_of(read_din("%A G71 *\nN10 T1 G17 S9 *\nN20 G83 P01 -2 P02 -5 P03 -5 P04 0 P05 150 *\nN30 G00 G90 "
                       "Z+2 *\nN40 X+10 G79 *\nN99 %A G71 *\n")),
      "r0,0,2 r10,0,2 10,0,-5 r10,0,2");
}

}  // namespace
}  // namespace feedscope

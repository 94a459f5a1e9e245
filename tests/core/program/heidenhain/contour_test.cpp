#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/program/heidenhain/read_heidenhain.h"

namespace feedscope {
namespace {

TEST(HeidenhainContour, RoundingTakesThePlaceOfTheCorner) {
  const ReadProgram program = read_clean_heidenhain("L X+10 F600\nRND R3 F60\nL Y+10\nL X+0\n");
  EXPECT_EQ(path_of(program), "7,0,0 10,3,0(+Z) 10,10,0 0,10,0");
  EXPECT_EQ(program.motions[0].feed, 10);
  EXPECT_EQ(program.motions[1].feed, 1) << "its own feed";
  EXPECT_EQ(program.motions[2].feed, 10) << "which holds for it alone";
  EXPECT_EQ(program.motions[1].line, 2U);
  EXPECT_EQ(program.motions[2].line, 3U);
  EXPECT_LT((program.arcs[0].center - Vec3(7, 3, 0)).norm(), 1e-12);
}

TEST(HeidenhainContour, EveryCornerOfASquareIsRounded) {
  EXPECT_EQ(
      path_of(read_clean_heidenhain("L X+10 F600\nRND R2\nL Y+10\nRND R2\nL X+0\nRND R2\nL Y+0\nL X+1\n")),
      "8,0,0 10,2,0(+Z) 10,8,0 8,10,0(+Z) 2,10,0 0,8,0(+Z) 0,0,0 1,0,0");
}

TEST(HeidenhainContour, ChamferCutsBothLines) {
  EXPECT_EQ(path_of(read_clean_heidenhain("L X+10 F600\nCHF 2 F60\nL Y+10\n")), "8,0,0 10,2,0 10,10,0");
}

TEST(HeidenhainContour, CornersStandBeforeOrBehindCommentsParametersAndLabels) {
  EXPECT_EQ(path_of(read_clean_heidenhain("L X+10 F600\n; corner\nRND R3\nQ1 = 10\nLBL 1\nL Y+Q1\n")),
            "7,0,0 10,3,0(+Z) 10,10,0");
}

TEST(HeidenhainContour, ACornerBetweenLineAndArc) {
  const ReadProgram program = read_clean_heidenhain("CC X+0 Y+0\nL X+10 F600\nRND R2\nC X+0 Y+10 DR+\n");
  EXPECT_EQ(program.motions.size(), 3U);
  EXPECT_NEAR(program.motions[0].target.x(), std::sqrt(60), 1e-12);
  EXPECT_EQ(program.arcs[1].center, Vec3(0, 0, 0));
}

TEST(HeidenhainContour, ApproachAndDepartureOnTangentLines) {
  const ReadProgram program = read_clean_heidenhain(
      "L X-20 Y-20 Z+5 R0 FMAX\nL Z-5 F100\nAPPR LT X+0 Y+0 LEN5 R0 F200\nL X+30\nDEP LT LEN8 F300\nL Z+50 "
      "FMAX\n");
  EXPECT_EQ(path_of(program), "r-20,-20,5 -20,-20,-5 -5,0,-5 0,0,-5 30,0,-5 38,0,-5 r38,0,50");
  EXPECT_NEAR(program.motions[2].feed, 100.0 / 60, 1e-12) << "the last feed leads to the auxiliary point";
  EXPECT_NEAR(program.motions[3].feed, 200.0 / 60, 1e-12);
  EXPECT_NEAR(program.motions[5].feed, 5, 1e-12);
}

TEST(HeidenhainContour, RapidsLeadToTheAuxiliaryPointBehindARapid) {
  EXPECT_EQ(path_of(read_clean_heidenhain("L X-20 Y-20 FMAX\nAPPR LT X+0 Y+0 Z-3 LEN5 R0 F200\nL X+30\n")),
            "r-20,-20,0 r-5,0,0 r-5,0,-3 0,0,-3 30,0,-3");
}

TEST(HeidenhainContour, ApproachIsDirectedByTheElementBehindIt) {
  EXPECT_EQ(path_of(read_clean_heidenhain(
                "L X-20 Y+0 F100\nAPPR LT X+10 Y+0 LEN5 R0 F200\nCC X+0 Y+0\nC X+0 Y+10 DR+\n")),
            "-20,0,0 10,-5,0 10,0,0 0,10,0(+Z)");
}

constexpr const char* tool = "TOOL DEF 1 L+0 R+2\nTOOL CALL 1 Z S100 F600\nL X-20 Y-20 FMAX\n";

TEST(HeidenhainContour, TheToolsCentreRunsBesideTheContour) {
  EXPECT_EQ(
      path_of(read_clean_heidenhain(
          std::string(tool) +
          "L X+0 Y+0 RL F AUTO\nL Y+20\nRND R5\nL X+30\nCHF 3\nL Y+0\nL X+0\nL X-20 Y-20 R0 FMAX\n")),
      "r-20,-20,0 -2,0,0 -2,15,0 5,22,0(-Z) 27,22,0 28.414,21.414,0(-Z) 31.414,18.414,0 32,17,0(-Z) 32,0,0 "
      "30,-2,0(-Z) 0,-2,0 r-20,-20,0");
}

TEST(HeidenhainContour, DeltaRadiusOfTheToolCallCounts) {
  EXPECT_EQ(path_of(read_clean_heidenhain("TOOL DEF 1 L+0 R+2\nTOOL CALL 1 Z S100 F600 DR+0.5\nL X-20 FMAX\n"
                                          "L X+0 Y+0 RR F AUTO\nL Y+20\nL X-20 R0\n")),
            "r-20,0,0 2.5,0,0 2.5,20,0 -20,20,0");
}

TEST(HeidenhainContour, ApproachesBesideTheContour) {
  // Along it from the auxiliary point on.
  EXPECT_EQ(path_of(read_clean_heidenhain(
                std::string(tool) + "APPR LT X+0 Y+0 LEN5 RR F600\nL X+30\nDEP LT LEN5\nL X+50 Y+50 FMAX\n")),
            "r-20,-20,0 r-5,-2,0 0,-2,0 30,-2,0 35,-2,0 r50,50,0");
  // Square to it, the length from the tool's edge.
  EXPECT_EQ(
      path_of(read_clean_heidenhain(
          std::string(tool) + "APPR LN X+0 Y+0 LEN5 RR F600\nL X+30\nDEP LN LEN+5\nL X+50 Y+50 FMAX\n")),
      "r-20,-20,0 r0,-7,0 0,-2,0 30,-2,0 30,-7,0 r50,50,0");
  // Half a circle of 10, of the tool's centre.
  EXPECT_EQ(path_of(read_clean_heidenhain(
                std::string(tool) + "APPR CT X+0 Y+0 CCA180 R+10 RR F600\nL X+30\nDEP CT CCA90 R+10\nL X+50 "
                                    "Y-50 FMAX\n")),
            "r-20,-20,0 r0,-22,0 0,-2,0(-Z) 30,-2,0 40,-12,0(-Z) r50,-50,0");
}

TEST(HeidenhainContour, LinesOfApproachAndDepartureTouchTheArcOfTheToolsCentre) {
  const ReadProgram program = read_clean_heidenhain(
      "TOOL DEF 1 L+0 R+2\nTOOL CALL 1 Z S100 F600\nL X-20 Y-9 FMAX\nAPPR LCT X+0 Y+0 R+10 RR\nL X+30\n"
      "DEP LCT X+60 Y-20 R+10\n");
  ASSERT_EQ(program.motions.size(), 6U);
  const auto touches = [&](std::size_t line_start, std::size_t line_end, const ArcWords& arc) {
    const Vec3 line = program.motions[line_end].target - program.motions[line_start].target;
    const Vec3 touching = program.motions[line_end == 1 ? 1 : line_start].target;
    EXPECT_NEAR((touching - arc.center).norm(), 10, 1e-9);
    EXPECT_NEAR(line.normalized().dot((touching - arc.center).normalized()), 0, 1e-9);
  };
  touches(0, 1, program.arcs[0]);
  touches(4, 5, program.arcs[1]);
}

/// Of Heidenhain's manuals: the tool is larger than the R of its approach.
TEST(HeidenhainContour, ExamplesOfTheManuals) {
  EXPECT_EQ(
      path_of(read_clean_heidenhain(
          "TOOL DEF 1 L+0 R+12.5\nTOOL CALL 1 Z S3150\nCC X+50 Y+50\nL Z+250 R0 F MAX\nL X-40 Y+50 R0 F MAX\n"
          "L Z-5 R0 F1000 M3\nAPPR LCT X+0 Y+50 R5 RL F300\nC X+0 DR-\nDEP LCT X-40 Y+50 R5 F1000\n"
          "L Z+250 R0 F MAX M2\n")),
      "r0,0,250 r-40,50,250 -40,50,-5 -18.611,45.125,-5 -12.5,50,-5(+Z) -12.5,50,-5(-Z+1) "
      "-18.611,54.875,-5(+Z) "
      "-40,50,-5 r-40,50,250");
  const ReadProgram helix = read_clean_heidenhain(
      "TOOL DEF 1 L+0 R+5\nTOOL CALL 1 Z S1400\nL Z+250 R0 FMAX\nL X+50 Y+50 R0 FMAX\nCC\nL Z-12.75 R0 F1000 "
      "M3\n"
      "APPR PCT PR+32 PA-182 CCA180 R+2 RL F100\nCP IPA+3240 IZ+13.5 DR+ F200\nDEP CT CCA180 R+2\n"
      "L Z+250 R0 FMAX M2\n");
  ASSERT_EQ(helix.arcs.size(), 3U);
  EXPECT_NEAR((helix.motions[4].target - Vec3(50, 50, -12.75)).norm(), 27, 1e-9) << "beside a radius of 32";
  EXPECT_NEAR((helix.motions[3].target - Vec3(50, 50, -12.75)).norm(), 23, 1e-9)
      << "half a circle of 2 before it";
  EXPECT_EQ(helix.motions[5].target.z(), 0.75);
  EXPECT_EQ(helix.arcs[1].turns, 9);
}

TEST(HeidenhainContour, AnApproachWithoutAContourGoesStraight) {
  const ReadProgram program = read_heidenhain("L X-20 F100\nAPPR LT X+0 Y+5 LEN5 R0 F200\n");
  EXPECT_EQ(path_of(program), "-20,0,0 0,5,0");
  ASSERT_EQ(program.diagnostics.size(), 1U);
  EXPECT_EQ(program.diagnostics[0].code, "approach");
  EXPECT_EQ(program.diagnostics[0].line, 2U);
}

TEST(HeidenhainContour, PolarApproachAndDeparture) {
  EXPECT_EQ(path_of(read_clean_heidenhain(
                "L X-20 Y-20 F100\nCC X+0 Y+0\nAPPR PLT PR+10 PA+180 LEN5 R0 F200\nL X+30\nDEP LT LEN1\n")),
            "-20,-20,0 -15,0,0 -10,0,0 30,0,0 31,0,0");
}

}  // namespace
}  // namespace feedscope

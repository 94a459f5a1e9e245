#include <gtest/gtest.h>

#include "tests/core/program/heidenhain/read_heidenhain.h"

namespace feedscope {
namespace {

constexpr const char* drilling =
    "CYCL DEF 200 DRILLING ~\n Q200=+2 ;SET-UP CLEARANCE ~\n Q201=-15 ;DEPTH ~\n Q206=+150 ;FEED ~\n"
    " Q202=+10 ;PLUNGING DEPTH ~\n Q210=+0 ;DWELL AT TOP ~\n Q203=+5 ;SURFACE ~\n Q204=+20 ;2ND CLEARANCE ~\n"
    " Q211=+0.5 ;DWELL AT DEPTH\n";

TEST(HeidenhainCycle, DrillingPecksDownToItsDepth) {
  const ReadProgram program = read_clean_heidenhain(std::string("TOOL CALL 1 Z S1000\nL Z+50 FMAX\n") +
                                                    drilling + "L X+10 Y+20 FMAX M99\n");
  EXPECT_EQ(path_of(program),
            "r0,0,50 r10,20,50 r10,20,7 10,20,-5 r10,20,7 r10,20,-3 10,20,-10 0.5s r10,20,7 r10,20,25");
  EXPECT_EQ(program.motions[3].feed, 2.5);
  EXPECT_EQ(program.motions[3].line, 12U);
}

TEST(HeidenhainCycle, IsCalledByM99M89AndCyclCall) {
  const std::string start = std::string("L Z+50 FMAX\n") + drilling;
  const auto holes = [&](const std::string& text) {
    int count = 0;
    for (const MotionBlock& block : read_clean_heidenhain(start + text).motions) {
      count += block.motion == Motion::dwell ? 1 : 0;
    }
    return count;
  };
  EXPECT_EQ(holes("L X+1 FMAX M99\nL X+2 FMAX\n"), 1);
  EXPECT_EQ(holes("L X+1 FMAX\nCYCL CALL\nL X+2 FMAX\nCYCL CALL M3\n"), 2);
  EXPECT_EQ(holes("L X+1 FMAX M89\nL X+2 FMAX\nL X+3 FMAX M99\nL X+4 FMAX\n"), 3);
  // Another cycle, and a call at a place, end M89.
  EXPECT_EQ(holes("L X+1 FMAX M89\n" + std::string(drilling) + "L X+2 FMAX\n"), 1);
  EXPECT_EQ(holes("L X+1 FMAX M89\nCYCL CALL POS X+2 Y+0 Z+0 FMAX\nL X+3 FMAX\n"), 2);
}

TEST(HeidenhainCycle, CallAtAPlaceRaisesTheSurface) {
  EXPECT_EQ(path_of(read_clean_heidenhain(std::string("L Z+50 FMAX\n") + drilling +
                                          "Q202 = 15\nCYCL CALL POS X+1 Y+2 Z+10 FMAX\n")),
            "r0,0,50 r1,2,50 r1,2,17 1,2,0 0.5s r1,2,17 r1,2,35");
}

struct CycleCase {
  const char* cycle;
  const char* path;  ///< from Z+50 at X0 Y0, S600
};
void PrintTo(const CycleCase& c, std::ostream* out) {
  *out << c.cycle;
}
class HeidenhainHole : public testing::TestWithParam<CycleCase> {};

TEST_P(HeidenhainHole, MovesAlongTheToolAxis) {
  const ReadProgram program = read_clean_heidenhain("TOOL DEF 1 L+0 R+3\nTOOL CALL 1 Z S600\nL Z+50 FMAX\n" +
                                                    std::string(GetParam().cycle) + "\nCYCL CALL\n");
  EXPECT_EQ(path_of(program), "r0,0,50 " + std::string(GetParam().path));
}

INSTANTIATE_TEST_SUITE_P(
    Cycles, HeidenhainHole,
    testing::Values(
        CycleCase{"CYCL DEF 201 REAMING Q200=2 Q201=-10 Q206=100 Q211=1 Q208=300 Q203=0 Q204=2",
                  "r0,0,2 0,0,-10 1s 0,0,2"},
        CycleCase{"CYCL DEF 202 BORING Q200=2 Q201=-10 Q206=100 Q211=0 Q208=300 Q203=0 Q204=9 Q214=1",
                  "r0,0,2 0,0,-10 r-0.2,0,-10 -0.2,0,2 r-0.2,0,9 r0,0,9"},
        // The tool passes the hole 3 mm beside it; its edge, 5 above its end, goes from 2 below to 4 above
        // the underside at Z-20.
        CycleCase{
            "CYCL DEF 204 BACK BORING Q200=2 Q249=4 Q250=20 Q251=3 Q252=5 Q253=750 Q254=200 Q255=0.5 Q203=0 "
            "Q204=9 Q214=3 Q336=0",
            "r0,0,2 r3,0,2 3,0,-27 r0,0,-27 0,0,-21 0.5s 0,0,-27 r3,0,-27 3,0,2 r3,0,9 r0,0,9"},
        CycleCase{"CYCL DEF 241 SINGLE-LIP Q200=2 Q201=-30 Q206=100 Q211=1 Q203=0 Q204=9 Q379=10 Q253=500 "
                  "Q208=MAX Q435=25",
                  "r0,0,2 0,0,-8 0,0,-25 1s 0,0,-30 1s r0,0,2 r0,0,9"},
        // Steps of 5, 4, 3, then the rest; each second step the tool comes out.
        CycleCase{
            "CYCL DEF 203 UNIVERSAL DRILLING Q200=2 Q201=-15 Q206=100 Q202=5 Q210=0 Q203=0 Q204=2 Q212=1 "
            "Q213=1 Q205=1 Q211=0 Q208=0 Q256=0.5",
            "r0,0,2 0,0,-5 0,0,-4.5 0,0,-9 0,0,2 r0,0,-7 0,0,-12 0,0,-11.5 0,0,-14 0,0,2 r0,0,-12 0,0,-15 "
            "0,0,2"},
        CycleCase{
            "CYCL DEF 205 UNIVERSAL PECKING Q200=2 Q201=-10 Q206=100 Q202=5 Q203=0 Q204=2 Q212=0 Q205=0 "
            "Q258=0.5 Q259=1.5 Q257=0 Q256=0.2 Q211=0 Q379=0 Q253=500",
            "r0,0,2 0,0,-5 r0,0,2 r0,0,-4 0,0,-10 0,0,2"},
        CycleCase{
            "CYCL DEF 205 UNIVERSAL PECKING Q200=2 Q201=-10 Q206=100 Q202=10 Q203=0 Q204=2 Q257=4 Q256=0.5",
            "r0,0,2 0,0,-4 0,0,-3.5 0,0,-8 0,0,-7.5 0,0,-10 0,0,2"},
        CycleCase{"CYCL DEF 206 TAPPING Q200=5 Q201=-20 Q206=150 Q211=0.25 Q203=0 Q204=5",
                  "r0,0,5 0,0,-20 0.25s 0,0,5"},
        CycleCase{"CYCL DEF 207 RIGID TAPPING Q200=5 Q201=-20 Q239=+1.5 Q203=0 Q204=8",
                  "r0,0,5 0,0,-20 0,0,5 r0,0,8"},
        CycleCase{"CYCL DEF 209 TAPPING W/ CHIP BRKG Q200=2 Q201=-20 Q239=1 Q203=0 Q204=2 Q257=15 Q256=1",
                  "r0,0,2 0,0,-15 0,0,-14 0,0,-20 0,0,2"},
        // A bore of 20 with a tool of 6: circles of 7.
        CycleCase{
            "CYCL DEF 208 BORE MILLING Q200=1 Q201=-8 Q206=100 Q334=3 Q203=0 Q204=1 Q335=20 Q342=0 Q351=1",
            "r0,0,1 7,0,1(+Z) 7,0,-8(+Z+3) 7,0,-8(+Z+1) 0,0,-8(+Z) r0,0,1"},
        CycleCase{"CYCL DEF 240 CENTERING Q200=1 Q343=0 Q201=-2 Q344=0 Q206=100 Q211=0 Q203=0 Q204=1",
                  "r0,0,1 0,0,-2 r0,0,1"},
        CycleCase{"CYCL DEF 1.0 PECKING\nCYCL DEF 1.1 DIST 2\nCYCL DEF 1.2 DEPTH -10\nCYCL DEF 1.3 PECKG "
                  "6\nCYCL DEF "
                  "1.4 DWELL 0.5\nCYCL DEF 1.5 F100",
                  "0,0,42 r0,0,50 r0,0,42.6 0,0,38 0.5s r0,0,50"},
        CycleCase{"CYCL DEF 2.0 TAPPING\nCYCL DEF 2.1 DIST2\nCYCL DEF 2.2 DEPTH-10\nCYCL DEF 2.3 "
                  "DWELL0\nCYCL DEF 2.4 "
                  "F100",
                  "0,0,38 0,0,50"},
        CycleCase{"CYCL DEF 17.0 RIGID TAPPING\nCYCL DEF 17.1 DIST2\nCYCL DEF 17.2 DEPTH-10\nCYCL DEF 17.3 "
                  "PITCH +1",
                  "0,0,38 0,0,50"}));

TEST(HeidenhainCycle, RigidTappingFeedsItsPitchEveryTurn) {
  const ReadProgram program = read_clean_heidenhain(
      "TOOL CALL 1 Z S600\nL Z+5 FMAX\nCYCL DEF 207 RIGID TAPPING Q200=5 Q201=-20 Q239=-1.5 Q203=0 "
      "Q204=5\nCYCL CALL\n");
  EXPECT_EQ(program.motions[1].feed, 15);
}

TEST(HeidenhainCycle, FeedOfACallAtAPlaceHoldsForTheWayThere) {
  const ReadProgram program = read_clean_heidenhain(std::string("L Z+50 F600\n") + drilling +
                                                    "Q202 = 15\nCYCL CALL POS X+1 Y+2 Z+0 F1200\nL Z+60\n");
  EXPECT_EQ(program.motions[1].feed, 20);
  EXPECT_EQ(program.motions.back().feed, 10);
}

TEST(HeidenhainCycle, GlobalDefinitionsStandForPredef) {
  EXPECT_EQ(
      path_of(read_clean_heidenhain(
          "L Z+50 FMAX\nGLOBAL DEF 100 GENERAL ~\n Q200=3 ;CLEARANCE ~\n Q204=7\nCYCL DEF 240 CENTERING "
          "Q200=PREDEF Q343=0 Q201=-2 Q206=100 Q211=0 Q203=0 Q204=PREDEF\nCYCL CALL\n")),
      "r0,0,50 r0,0,3 0,0,-2 r0,0,3 r0,0,7");
}

TEST(HeidenhainCycle, TappingMayComeOutFaster) {
  const ReadProgram program = read_clean_heidenhain(
      "TOOL CALL 1 Z S600\nL Z+2 FMAX\nCYCL DEF 209 TAPPING Q200=2 Q201=-20 Q239=1 Q203=0 Q204=2 Q257=0 "
      "Q256=0 "
      "Q403=2.5\nCYCL CALL\n");
  ASSERT_EQ(program.motions.size(), 3U);
  EXPECT_EQ(program.motions[1].feed, 10);
  EXPECT_EQ(program.motions[2].feed, 25);
}

constexpr const char* shallow =
    "L Z+50 FMAX\nCYCL DEF 200 DRILLING Q200=1 Q201=-2 Q206=150 Q202=2 Q210=0 Q203=0 Q204=10 Q211=0\n";

TEST(HeidenhainCycle, HolesOnACircle) {
  EXPECT_EQ(
      path_of(read_clean_heidenhain(std::string(shallow) +
                                    "CYCL DEF 220 POLAR PATTERN Q216=50 Q217=0 Q244=20 Q245=0 Q246=360 "
                                    "Q247=0 Q241=4 Q200=1 Q203=0 Q204=10 "
                                    "Q301=0\n")),
      "r0,0,50 r0,0,10 r60,0,10 r60,0,1 60,0,-2 r60,0,1 r50,10,1 50,10,-2 r50,10,1 r40,0,1 40,0,-2 r40,0,1 "
      "r50,-10,1 50,-10,-2 r50,-10,1 r50,-10,10");
}

TEST(HeidenhainCycle, PatternsRepeatCyclesOfOlderProgramsToo) {
  EXPECT_EQ(
      path_of(read_clean_heidenhain("L Z+50 FMAX\nCYCL DEF 2.0 TAPPING\nCYCL DEF 2.1 DIST 1\nCYCL DEF 2.2 "
                                    "DEPTH -18\nCYCL DEF 2.3 DWELL 0\n"
                                    "CYCL DEF 2.4 F100\nCYCL DEF 220 PATTERN Q216=0 Q217=0 Q244=20 Q245=0 "
                                    "Q246=180 Q247=180 Q241=2 Q200=1 "
                                    "Q203=0 Q204=9 Q301=1\n")),
      "r0,0,50 r0,0,9 r10,0,9 r10,0,1 10,0,-18 10,0,1 r10,0,9 r-10,0,9 r-10,0,1 -10,0,-18 -10,0,1 r-10,0,9");
}

TEST(HeidenhainCycle, ARemarkMayStandBehindTheSignThatGoesOn) {
  EXPECT_EQ(path_of(read_clean_heidenhain(
                "L Z+50 FMAX\nCYCL DEF 240 C ~  ;;--- centres\n  Q200=1 ;A ~\n Q343=0 ~\n"
                " Q201=-2 ~\n Q206=100 ~\n Q203=0 ~ ; surface\n Q204=1 ;END\nCYCL CALL\n")),
            "r0,0,50 r0,0,1 0,0,-2 r0,0,1");
}

TEST(HeidenhainCycle, HolesInRowsThereAndBack) {
  EXPECT_EQ(
      path_of(read_clean_heidenhain(
          std::string(shallow) + "CYCL DEF 221 CARTESIAN PATTERN Q225=5 Q226=6 Q237=10 Q238=20 Q242=2 Q243=2 "
                                 "Q224=0 Q200=1 Q203=0 Q204=3 Q301=1\n")),
      "r0,0,50 r0,0,3 r5,6,3 r5,6,1 5,6,-2 r5,6,1 r5,6,3 r15,6,3 r15,6,1 15,6,-2 r15,6,1 r15,6,3 r15,26,3 "
      "r15,26,1 15,26,-2 r15,26,1 r15,26,3 r5,26,3 r5,26,1 5,26,-2 r5,26,1 r5,26,3");
}

}  // namespace
}  // namespace feedscope

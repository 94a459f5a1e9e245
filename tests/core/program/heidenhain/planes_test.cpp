#include <gtest/gtest.h>

#include <algorithm>

#include "tests/core/program/heidenhain/read_heidenhain.h"

namespace feedscope {
namespace {

struct PlaneCase {
  const char* plane;
  Vec3 shown;  ///< of X1 Y2 Z3
};
void PrintTo(const PlaneCase& c, std::ostream* out) {
  *out << c.plane;
}
class HeidenhainPlane : public testing::TestWithParam<PlaneCase> {};

TEST_P(HeidenhainPlane, TurnsWhatFollows) {
  const ReadProgram program = read_clean_heidenhain(std::string(GetParam().plane) + "\nL X+1 Y+2 Z+3 F100\n");
  EXPECT_LT((end_of(program) - GetParam().shown).norm(), 1e-12) << path_of(program);
}

INSTANTIATE_TEST_SUITE_P(
    Forms, HeidenhainPlane,
    testing::Values(
        PlaneCase{"PLANE SPATIAL SPA+90 SPB+0 SPC+0 STAY", {1, -3, 2}},
        PlaneCase{"PLANE SPATIAL SPA+0 SPB+90 SPC+0 TURN FMAX SEQ- TABLE ROT", {3, 2, -1}},
        // About the fixed axes, X first.
        PlaneCase{"PLANE SPATIAL SPA90 SPB0 SPC180 MOVE DIST50 F2000 SYM+ COORD ROT", {-1, 3, 2}},
        PlaneCase{"Q5=90\nPLANE SPATIAL SPA+Q5 SPB+90 SPC+0 STAY", {2, -3, -1}},
        PlaneCase{"PLANE SPATIAL SPA+90 SPB+0 SPC+0 STAY\nPLANE RELATIV SPC+90 STAY", {-2, -3, 1}},
        PlaneCase{"PLANE EULER EULPR+90 EULNU+90 EULROT+0 STAY", {3, 1, 2}},
        PlaneCase{"PLANE VECTOR BX+1 BY+0 BZ+0 NX+0 NY-2 NZ+0 STAY", {1, -3, 2}},
        PlaneCase{"PLANE POINTS P1X+5 P1Y+0 P1Z+0 P2X+9 P2Y+0 P2Z+0 P3X+7 P3Y+0 P3Z+4 MOVE DIST9 FMAX",
                  {1, -3, 2}},
        PlaneCase{"PLANE SPATIAL SPA+90 SPB+0 SPC+0 STAY\nPLANE RESET TURN FMAX", {1, 2, 3}},
        PlaneCase{"PLANE SPATIAL SPA+0 SPB+45 SPC+0 STAY\nPLANE SPATIAL SPA+90 SPB+0 SPC+0 STAY", {1, -3, 2}},
        // A shift before it moves the tilted plane, one behind it moves within.
        PlaneCase{"CYCL DEF 7.1 X+10\nCYCL DEF 7.2 Y+20\nPLANE SPATIAL SPA+90 SPB+0 SPC+0 STAY", {11, 17, 2}},
        PlaneCase{"PLANE SPATIAL SPA+90 SPB+0 SPC+0 STAY\nCYCL DEF 7.1 X+10\nCYCL DEF 7.2 Y+20",
                  {11, -3, 22}},
        PlaneCase{"CYCL DEF 7.1 X+10\nCYCL DEF 7.2 Y+9\nPLANE SPATIAL SPA+90 SPB+0 SPC+0 STAY\nCYCL DEF 7.1 "
                  "X+0\nCYCL DEF 7.2 Y+0\nPLANE RESET STAY",
                  {1, 2, 3}},
        PlaneCase{"PLANE AXIAL A+90 TURN FMAX", {1, -3, 2}},
        PlaneCase{"CYCL DEF 19.0 WORKING PLANE\nCYCL DEF 19.1 A+90 B+0 C+0 F500 ABST50", {1, -3, 2}},
        PlaneCase{"CYCL DEF 19.1 A+90 SETUP50\nCYCL DEF 19.0 WORKING PLANE\nCYCL DEF 19.1", {1, 2, 3}}));

TEST(HeidenhainPlanes, ADatumOfTheMachineEndsTheTransformationsButTheTilt) {
  const std::string set = "CYCL DEF 7.1 X+10\nCYCL DEF 10.1 ROT+90\nCYCL DEF 8.1 Y\nCYCL DEF 11.1 SCL 2\n";
  const std::string to = "L X+1 Y+2 Z+3 FMAX\n";
  EXPECT_EQ(path_of(read_clean_heidenhain(set + "CYCL DEF 247 DATUM SETTING Q339=1\n" + to)), "r1,2,3");
  EXPECT_EQ(path_of(read_clean_heidenhain(set + "PRESET SELECT #3\n" + to)), "r1,2,3");
  EXPECT_EQ(path_of(read_clean_heidenhain("CYCL DEF 7.1 X+10\nPRESET SELECT #3 KEEP TRANS WP\n" + to)),
            "r11,2,3");
  EXPECT_EQ(path_of(read_clean_heidenhain(
                "CYCL DEF 7.1 X+10\nPLANE SPATIAL SPA+90 SPB+0 SPC+0 STAY\nCYCL DEF 247 D "
                "Q339=1\n" +
                to)),
            "r1,-3,2");
}

TEST(HeidenhainPlanes, RetractAlongTheToolBeforeTheAxesTurn) {
  const std::string to = "L X+1 Y+2 Z+3 FMAX\n";
  EXPECT_EQ(path_of(read_clean_heidenhain(to + "PLANE SPATIAL SPA+90 SPB+0 SPC+0 TURN MB50 FMAX\n")),
            "r1,2,3 r1,2,53");
  // In the plane that is in force: its Z is -Y of the part.
  EXPECT_EQ(path_of(read_clean_heidenhain("PLANE SPATIAL SPA+90 SPB+0 SPC+0 STAY\n" + to +
                                          "PLANE RESET TURN MB10 FMAX\n")),
            "r1,-3,2 r1,-13,2");
  EXPECT_EQ(path_of(read_clean_heidenhain(to + "PLANE SPATIAL SPA+90 SPB+0 SPC+0 STAY MB50\n")), "r1,2,3");
}

TEST(HeidenhainPlanes, SayThatXYAndZFollowAMoveOfTheMachine) {
  const auto reported = [](const char* axes) {
    ReadOptions options{.dialect = Dialect::heidenhain};
    options.rotary_axes = axes;
    const ReadProgram program =
        read_heidenhain("PLANE SPATIAL SPA+30 SPB+0 SPC+0 MOVE DIST50 F2000\n", options);
    return std::ranges::count(program.diagnostics, "swivel-retract", &Diagnostic::code);
  };
  EXPECT_EQ(reported("AC"), 1);
  EXPECT_EQ(reported(""), 0);
}

TEST(HeidenhainPlanes, ArcsAndHolesLieInTheTiltedPlane) {
  const ReadProgram arc = read_clean_heidenhain(
      "PLANE SPATIAL SPA+90 SPB+0 SPC+0 STAY\nL X+10 Y+0 Z+0 F100\nCC X+0 Y+0\nC X+0 Y+10 DR+\n");
  EXPECT_EQ(path_of(arc), "10,0,0 0,0,10(-Y)");
  const ReadProgram hole = read_clean_heidenhain(
      "PLANE SPATIAL SPA+90 SPB+0 SPC+0 STAY\nL X+1 Y+2 Z+9 FMAX\nCYCL DEF 240 CENTERING Q200=1 Q343=0 "
      "Q201=-2 "
      "Q206=100 Q203=0 Q204=1\nCYCL CALL\n");
  EXPECT_EQ(path_of(hole), "r1,-9,2 r1,-1,2 1,2,2 r1,-1,2");
}

}  // namespace
}  // namespace feedscope

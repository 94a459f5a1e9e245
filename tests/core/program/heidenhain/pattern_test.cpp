#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/program/heidenhain/read_heidenhain.h"

namespace feedscope {
namespace {

struct PatternCase {
  const char* pattern;
  const char* places;  ///< X,Y of the bottoms
};
void PrintTo(const PatternCase& c, std::ostream* out) {
  *out << c.pattern;
}
class HeidenhainPattern : public testing::TestWithParam<PatternCase> {};

constexpr const char* centering =
    "L Z+50 FMAX\nCYCL DEF 240 CENTERING Q200=1 Q343=0 Q201=-2 Q206=100 Q211=0 Q203=0 Q204=5\n";

TEST_P(HeidenhainPattern, HasItsPlaces) {
  const ReadProgram program = read_clean_heidenhain(centering + std::string("PATTERN DEF ") +
                                                    GetParam().pattern + "\nCYCL CALL PAT FMAX M3\n");
  std::string places;
  for (const MotionBlock& block : program.motions) {
    if (block.motion == Motion::line) {
      EXPECT_EQ(block.target.z(), -2);
      places +=
          fmt::format("{}{:g},{:g}", places.empty() ? "" : " ", std::round(block.target.x() * 1e6) / 1e6,
                      std::round(block.target.y() * 1e6) / 1e6 + 0.0);
    }
  }
  EXPECT_EQ(places, GetParam().places);
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, HeidenhainPattern,
    testing::Values(
        PatternCase{"POS1 (X+25 Y+33.5 Z+0) POS2 (X+50 Y+75 Z+0)", "25,33.5 50,75"},
        PatternCase{"ROW1 (X+25 Y+33,5 D+8 NUM3 ROT+90 Z+0)", "25,33.5 25,41.5 25,49.5"},
        PatternCase{"PAT1 (X+1 Y+2 DX+8 DY+10 NUMX3 NUMY2 ROT+0 ROTX+0 ROTY+0 Z+0)",
                    "1,2 9,2 17,2 17,12 9,12 1,12"},
        PatternCase{"PAT1 (X+0 Y+0 DX+8 DY+10 NUMX2 NUMY2 ROT+90 ROTX+0 ROTY-90 Z+0)", "0,0 0,8 0,18 0,10"},
        PatternCase{"FRAME1 (X+0 Y+0 DX+1 DY+1 NUMX3 NUMY3 ROT+0 ROTX+0 ROTY+0 Z+0)",
                    "0,0 1,0 2,0 2,1 2,2 1,2 0,2 0,1"},
        PatternCase{"FRAME1 (X+0 Y+0 DX+1 DY+1 NUMX1 NUMY3 ROT+0 ROTX+0 ROTY+0 Z+0)", "0,0 0,1 0,2"},
        PatternCase{"CIRC1 (X+25 Y+33 D80 START+90 NUM4 Z+0)", "25,73 -15,33 25,-7 65,33"},
        PatternCase{"PITCHCIRC1 (X+0 Y+0 D20 START+0 STEP+90 NUM3 Z+0) ~\n POS1 (X+1 Y+1 Z+0)",
                    "10,0 0,10 -10,0 1,1"}));

TEST(HeidenhainPatterns, PlacesRaiseTheSurfaceAndTheWayStaysHigh) {
  EXPECT_EQ(
      path_of(
          read_clean_heidenhain(centering + std::string("PATTERN DEF POS1 (X+5 Y+0 Z+0) POS2 (X+9 Y+0 Z+10)\n"
                                                        "L Z+3 FMAX\nCYCL CALL PAT F500 M3\n"))),
      "r0,0,50 r0,0,3 r0,0,5 5,0,5 r5,0,1 5,0,-2 r5,0,1 r5,0,5 r5,0,15 9,0,15 r9,0,11 9,0,8 r9,0,11 r9,0,15");
}

}  // namespace
}  // namespace feedscope

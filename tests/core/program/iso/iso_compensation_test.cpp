#include <gtest/gtest.h>

#include <string>

#include "tests/core/program/iso/iso_text.h"
#include "tests/core/program/motion_text.h"

namespace feedscope {
namespace {

constexpr Dialect fanuc = Dialect::fanuc;
constexpr Dialect linuxcnc = Dialect::linuxcnc;
constexpr const char* corner = "\nX20\nY-20\nG40 X0\n";

Lines compensated(Dialect dialect, const std::string& switched) {
  return text_of(read_clean_as(dialect, switched + corner));
}

TEST(IsoCompensation, TakesTheRadiusOfTheOffset) {
  const Lines expected{"line 10 2 0 @2", "line 22 2 0 @3", "line 22 -20 0 @4", "line 0 -20 0 @5"};
  EXPECT_EQ(compensated(fanuc, "G10 L12 P7 R2\nG1 G41 D7 X10 F100"), expected);
  EXPECT_EQ(
      compensated(linuxcnc, "G10 L1 P7 R2\nG1 G41 D7 X10 F100"),
      (Lines{"line 10 2 0 @2", "line 20 2 0 @3", "arc 22 0 0 @4", "line 22 -20 0 @4", "line 0 -20 0 @5"}))
      << "on an arc about the corner";
}

TEST(IsoCompensation, WearAddsToTheRadius) {
  EXPECT_EQ(compensated(fanuc, "G10 L12 P7 R2\nG10 L13 P7 R-0.5\nG1 G41 D7 X10 F100").at(0),
            "line 10 1.5 0 @3");
}

TEST(IsoCompensation, TakesTheToolInTheSpindleWithoutD) {
  EXPECT_EQ(compensated(linuxcnc, "G10 L1 P7 R2\nT7 M6\nG1 G42 X10 F100").at(0), "line 10 -2 0 @3");
}

TEST(IsoCompensation, TakesADiameter) {
  EXPECT_EQ(compensated(linuxcnc, "G1 G41.1 D4 X10 F100").at(0), "line 10 2 0 @1");
  EXPECT_EQ(compensated(linuxcnc, "G20\nG1 G42.1 D2 X10 F100").at(0), "line 254 -25.4 0 @2");
}

TEST(IsoCompensation, OffsetZeroIsTheContour) {
  EXPECT_EQ(compensated(fanuc, "G1 G41 D0 X10 F100"),
            (Lines{"line 10 0 0 @1", "line 20 0 0 @2", "line 20 -20 0 @3", "line 0 -20 0 @4"}));
}

TEST(IsoCompensation, AnotherDChangesTheRadiusOnTheWay) {
  EXPECT_EQ(
      text_of(read_clean_as(fanuc, "G10 L12 P1 R1\nG10 L12 P2 R2\nG1 G41 D1 X10 F100\nX20\nD2 X30\nX40")),
      (Lines{"line 10 1 0 @3", "line 20 1 0 @4", "line 30 2 0 @5", "line 40 2 0 @6"}));
}

TEST(IsoCompensation, WorksOnIncrementalPositions) {
  EXPECT_EQ(text_of(read_clean_as(linuxcnc, "G91 G1 G41.1 D2 X10 F100\nX10\nY10\nG40 X-20")),
            (Lines{"line 10 1 0 @1", "line 19 1 0 @2", "line 19 10 0 @3", "line 0 10 0 @4"}));
}

struct FaultCase {
  const char* text;
  const char* expected;
};

class IsoCompensationFault : public testing::TestWithParam<FaultCase> {};

TEST_P(IsoCompensationFault, ShowsTheContourOrSaysWhereItCuts) {
  const ReadProgram program = read_as(fanuc, GetParam().text);
  ASSERT_EQ(program.diagnostics.size(), 1U);
  EXPECT_EQ(format(program.diagnostics[0], "f"), GetParam().expected);
}

INSTANTIATE_TEST_SUITE_P(
    All, IsoCompensationFault,
    testing::Values(
        FaultCase{"G1 G41 D7 X10 F100\nX20\nG40 Y10",
                  "f:1:8: error: the radius of offset D7 is not known [tool-radius] (the path shown is the "
                  "programmed contour; give it as an import option (--tool 7=RADIUS) or in a tool table, or "
                  "say that "
                  "the path is already compensated (--wear-only), or set it with G10 L12 P7 R)"},
        FaultCase{
            "G1 G41 X10 F100\nX20\nG40 Y10",
            "f:1:4: error: G41 without D: the radius of the tool is not known [tool-radius] (the path shown "
            "is the programmed contour; write D with the tool's offset)"},
        FaultCase{
            "G1 G42.1 X10 F100\nX20\nG40 Y10",
            "f:1:4: error: G42.1 without D [tool-radius] (the path shown is the programmed contour; write D "
            "with the tool's diameter)"},
        FaultCase{"G1 G41.1 D4 X10 F100\nX20\nG3 X21 Y1 R1\nG1 Y20\nG40 Y30",
                  "f:3:4: error: the arc's radius, 1.0000 mm, is smaller than the tool's, 2.0000 mm "
                  "[compensation-gouge] (a straight line to its end is used instead, which cuts into the "
                  "contour; use a smaller tool)"},
        FaultCase{"G1 G41.1 D4 X10 F100\nX20\nG18 X30",
                  "f:3: error: the plane changes while cutter radius compensation is on [compensation-plane] "
                  "(it begins again in the other plane; end it before)"}));

}  // namespace
}  // namespace feedscope

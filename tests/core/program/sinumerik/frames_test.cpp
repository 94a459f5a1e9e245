#include <gtest/gtest.h>

#include "tests/core/program/motion_text.h"
#include "tests/core/program/sinumerik/read_sinumerik.h"

namespace feedscope {
namespace {

struct FrameCase {
  const char* text;
  Vec3 end;
};

class SinumerikFrames : public testing::TestWithParam<FrameCase> {};

TEST_P(SinumerikFrames, ProgrammedPointLiesInTheFrame) {
  expect_near(end_of(GetParam().text), GetParam().end);
}

INSTANTIATE_TEST_SUITE_P(
    Words, SinumerikFrames,
    testing::Values(
        FrameCase{"TRANS X10 Y5\nG0 X1 Y1", {11, 6, 0}},
        FrameCase{"TRANS X10\nATRANS X5 Z1\nG0 X1 Z0", {16, 0, 1}},
        FrameCase{"TRANS X10\nTRANS Y2\nG0 X1 Y0", {1, 2, 0}},
        FrameCase{"TRANS X10\nTRANS\nG0 X1", {1, 0, 0}}, FrameCase{"ROT Z90\nG0 X1", {0, 1, 0}},
        FrameCase{"ROT RPL=90\nG0 X1", {0, 1, 0}}, FrameCase{"G18 ROT RPL=90\nG0 Z1 X0", {1, 0, 0}},
        FrameCase{"TRANS X10\nAROT Z90\nG0 X1 Y0", {10, 1, 0}},
        // About Z first, then about the turned Y, then about the turned X.
        FrameCase{"ROT X90 Y90\nG0 Y1", {1, 0, 0}}, FrameCase{"SCALE X2 Y3\nG0 X1 Y1 Z1", {2, 3, 1}},
        FrameCase{"TRANS X10\nASCALE X2\nG0 X1", {12, 0, 0}}, FrameCase{"MIRROR X0\nG0 X1 Y1", {-1, 1, 0}},
        FrameCase{"TRANS X10\nAMIRROR X0\nG0 X1 Y1", {9, 1, 0}},
        FrameCase{"TRANS X10 Y10\nG58 X5\nG59 X1\nG0 X0 Y0", {6, 10, 0}},
        FrameCase{"G70 TRANS X1\nG0 X0", {25.4, 0, 0}},
        FrameCase{"CYCLE800(0,\"T\",0,57,0,0,10,0,90,0,0,0,0,-1)\nG0 Z1 X0", {1, 0, 10}},
        FrameCase{"G0 Z3\nCYCLE800(5,\"T\",0,57,0,0,0,90,0,0,0,0,0,-1,20)", {0, 0, 23}},
        FrameCase{"CYCLE800(0,\"T\",0,57,0,0,0,90,0,0,0,0,0)\nCYCLE800()\nG0 Z1", {0, 0, 1}}));

INSTANTIATE_TEST_SUITE_P(
    Variables, SinumerikFrames,
    testing::Values(
        FrameCase{"$P_PFRAME=CTRANS(X,10,Y,5)\nG0 X1 Y0", {11, 5, 0}},
        FrameCase{"TRANS Z3\n$P_PFRAME=CTRANS(X,10):CROT(Z,90)\nG0 X1 Y0", {10, 1, 0}},
        FrameCase{"$P_PFRAME=CROT(Z,90):CTRANS(X,10)\nG0 X1 Y0", {0, 11, 0}},
        FrameCase{"R1=4\n$P_PFRAME=CTRANS(X,R1*2)\n$P_PFRAME=$P_PFRAME:CMIRROR(X)\nG0 X1", {7, 0, 0}},
        FrameCase{"$P_PFRAME=CSCALE(X,2,Y,3)\nG0 X1 Y1", {2, 3, 0}},
        FrameCase{"TRANS X1\n$P_PFRAME[Y,TR]=2\n$P_PFRAME[X,FI]=0.5\nG0 X0 Y0", {1.5, 2, 0}},
        FrameCase{"$P_PFRAME=CTRANS(X,10)\n$P_PFRAME=CTRANS()\nG0 X1", {1, 0, 0}},
        // Settable ones take effect with their G word, the one in force at once.
        FrameCase{"$P_UIFR[1]=CTRANS(X,100)\nG0 X1", {1, 0, 0}},
        FrameCase{"$P_UIFR[1]=CTRANS(X,100)\nG54 G0 X1", {101, 0, 0}},
        FrameCase{"$P_UIFR[5,X,TR]=7\n$P_UIFR[5,X,FI]=1\n$P_UIFR[5,Z,RT]=90\nG505 G0 X1 Y0", {8, 1, 0}},
        FrameCase{"$P_UIFR[2,Y,SC]=2 $P_UIFR[2,X,MI]=1\nG55 G0 X1 Y1", {-1, 2, 0}},
        FrameCase{"$P_UIFR[1]=CTRANS(X,9)\n$P_UIFR[2]=$P_UIFR[1]\nG54 G0 X1\nG55 X2\nTRANS X5\nX0",
                  {14, 0, 0}},
        FrameCase{"$P_IFRAME=CTRANS(X,9)\nG0 X1", {10, 0, 0}},
        FrameCase{"DEF FRAME BASE, TURNED=CROT(Z,90)\nBASE=CTRANS(X,10):TURNED\nBASE=BASE\n$P_PFRAME=BASE\n"
                  "G0 X1 Y0",
                  {10, 1, 0}},
        FrameCase{"DEF FRAME BASE\nBASE[X,TR]=3\n$P_PFRAME=BASE\nG0 X1", {4, 0, 0}},
        FrameCase{"G70\n$P_PFRAME=CTRANS(X,1)\nG0 X0", {25.4, 0, 0}}));

TEST(SinumerikFrames, ArcsTurnAndMirrorWithTheFrame) {
  const ReadProgram program = read_clean("AMIRROR X0\nG2 X10 Y10 I10 J0 F100");
  ASSERT_EQ(program.arcs.size(), 1U);
  expect_near(program.arcs[0].center, {-10, 0, 0});
  expect_near(program.arcs[0].axis, Vec3::UnitZ());
}

TEST(SinumerikFrames, TheToolStaysWhereItIsWhenTheFrameChanges) {
  expect_near(end_of("G0 X10 Y1\nTRANS X4\nY2"), {10, 2, 0});
}

/// Function Manual K2, frames with G91: setting data 42440 is 1 by default, so that the change of the frame
/// is traversed along with the increment.
TEST(SinumerikFrames, AnIncrementAfterAChangeOfFrameTraversesTheChangeOnce) {
  const ReadProgram program = read_sinumerik(
      "G0 X10 Y10\nTRANS X4 Y3\nG91 X1\nX1\nTRANS\nX=IC(1)\nG90 Y0\nATRANS Y5\nG90 Y1\nY=IC(1)");
  const std::vector<Vec3> ends{{10, 10, 0}, {15, 10, 0}, {16, 10, 0}, {13, 10, 0},
                               {13, 0, 0},  {13, 6, 0},  {13, 7, 0}};
  ASSERT_EQ(program.motions.size(), ends.size());
  for (std::size_t i = 0; i < ends.size(); ++i) {
    expect_near(program.motions[i].target, ends[i]);
  }
  ASSERT_EQ(program.diagnostics.size(), 2U) << "one for X, one for Y";
  EXPECT_EQ(program.diagnostics[0].code, "frame-increment");
}

/// $P_UIFR gives the zero point in coordinates of the machine, so that SUPA is where the program says it.
TEST(SinumerikFrames, MachineCoordinatesAreShownWhereTheProgramSetsItsZeroPoint) {
  const ReadProgram program =
      read_clean("$P_UIFR[1]=CTRANS(X,-290,Y,-175,Z,-20)\nG54\nG0 X0 Y0 Z5\nG0 SUPA Z0\nSUPA X-300\nX0 Y0");
  EXPECT_EQ(text_of(program), (Lines{"rapid -290 -175 -15 @3", "rapid -290 -175 0 @4", "rapid -300 -175 0 @5",
                                     "rapid -290 -175 0 @6"}));
  const ReadProgram part = read_sinumerik("$P_UIFR[1,Z,TR]=-20\nG54\nG0 X1 Y2 Z3\nSUPA Z0\nSUPA X0");
  EXPECT_EQ(text_of(part), (Lines{"rapid 1 2 -17 @3", "rapid 1 2 0 @4", "machine move 1 2 0 @5"}));
}

}  // namespace
}  // namespace feedscope

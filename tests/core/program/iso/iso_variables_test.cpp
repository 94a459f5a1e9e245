#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/core/program/iso/iso_text.h"

namespace feedscope {
namespace {

using Way = std::vector<double>;

TEST(IsoVariables, HoldWhatTheyAreGiven) {
  for (const Dialect dialect : {Dialect::iso, Dialect::fanuc, Dialect::linuxcnc}) {
    EXPECT_EQ(way(dialect, "#100=5\n#101 = [#100*2]\nG0 X#100\nX#101\nX-#101\n"), (Way{5, 10, -10}));
  }
}

TEST(IsoVariables, AreFoundByTheValueOfOthers) {
  EXPECT_EQ(way(Dialect::fanuc, "#1=2\n#2=7\nG0 X##1\n#[#1+1]=9\nX#3\nX#[1+2]\n"), (Way{7, 9, 9}));
}

TEST(IsoVariables, NamesForgetBlanksAndCase) {
  EXPECT_EQ(way(Dialect::linuxcnc, "#<Depth of cut>=3\nG0 X#<depthofcut>\nX#<DEPTH OF CUT>"), (Way{3, 3}));
}

TEST(IsoVariables, RuleGWordsFeedsAndDwells) {
  const ReadProgram program = read_clean_as(Dialect::linuxcnc, "#1=1 #2=600\nG#1 X1 F#2\nG4 P[#1/2]\n");
  ASSERT_EQ(program.motions.size(), 2U);
  EXPECT_EQ(program.motions[0].motion, Motion::line);
  EXPECT_EQ(program.motions[0].feed, 10);
  EXPECT_EQ(program.motions[1].dwell, 0.5);
}

TEST(IsoVariables, LinuxCncReadsAllOfABlockBeforeItAssigns) {
  EXPECT_EQ(way(Dialect::linuxcnc, "#3=15\n#3=6 G0 X#3\nX#3\n#4=#3 #3=1\nX#4"), (Way{15, 6, 6}));
}

TEST(IsoVariables, FanucAssignsInOrder) {
  EXPECT_EQ(way(Dialect::fanuc, "#3=15\n#3=6 #4=#3\nG0 X#4\n"), (Way{6}));
}

TEST(IsoVariables, AFanucWordWithoutAValueIsLeftOut) {
  const ReadProgram program = read_clean_as(Dialect::fanuc, "G0 X1 Y1\nG0 X#5 Y-#6 Z2\n#7=#0\nX#7 Z3\n");
  ASSERT_EQ(program.motions.size(), 3U);
  EXPECT_EQ(program.motions[2].target, Vec3(1, 1, 3));
}

TEST(IsoVariables, PositionsAreThoseOfTheToolInTheUnitInForce) {
  EXPECT_EQ(way(Dialect::linuxcnc, "G0 X5 Y7\nX#5421\nG91 X[#5420-6]"), (Way{5, 7, 8}));
  EXPECT_NEAR(way(Dialect::linuxcnc, "G20\nG0 X2\nX[#5420*2]").at(1), 4 * 25.4, 1e-12);
  EXPECT_EQ(way(Dialect::linuxcnc, "G0 Y7\nX#<_y>"), (Way{0, 7}));
  EXPECT_EQ(way(Dialect::fanuc, "G0 Y7 Z9\nX#5002\nX#5043"), (Way{0, 7, 9}));
}

TEST(IsoVariables, ModalStateIsAnswered) {
  EXPECT_EQ(way(Dialect::linuxcnc,
                "G1 F300 X1\nX#<_feed>\nX#<_motion_mode>\nG18\nX#<_plane>\nX#<_metric>\nG91\n"
                "G90 X#<_incremental>\nT4 M6\nX#<_current_tool>\nX#5400"),
            (Way{1, 300, 10, 180, 1, 1, 4, 4}));
  EXPECT_EQ(way(Dialect::fanuc, "G1 F300 X1\nX#4001\nX#4002\nX#4003\nX#4005\nX#4006\nX#4109\nT3\nX#4120"),
            (Way{1, 1, 17, 90, 94, 21, 300, 3}));
  EXPECT_EQ(way(Dialect::linuxcnc, "G0 X1\n#1=#<_motion_mode>\nG1 F100 X2\nG[#1/10] X3\n"), (Way{1, 2, 3}));
}

TEST(IsoVariables, WorkOffsetsAreThoseThatTheProgramSets) {
  EXPECT_EQ(way(Dialect::linuxcnc, "G10 L2 P2 X5 Y6\nG0 X#5241\nX[#5242+1]\nX#5220\nG55 X0\nX#5220"),
            (Way{5, 7, 1, 5, 7}));
  EXPECT_EQ(
      way(Dialect::fanuc, "#5221=10\n#7002=4\nG54 G0 X1\nX#5221\nX#7002\n#5221=#5221+1\nX1\nX[#4014/54]"),
      (Way{11, 20, 14, 12, 12}));
  EXPECT_EQ(said_of(Dialect::fanuc, "G0 X1\nX#5241"),
            "f:2:2: warning: #5241 is a control-internal value [control-variable] (0 is used; the control "
            "may run another path)");
  EXPECT_EQ(said_of(Dialect::linuxcnc, "G0 X1\n#5221=3"),
            "f:2:1: error: #5221 is read-only [variable] (the assignment is skipped; use another variable)");
}

TEST(IsoVariables, WhatTheControlKeepsIsSaid) {
  EXPECT_EQ(said_of(Dialect::linuxcnc, "G0 X1\nX#500"),
            "f:2:2: warning: #500 has not been set by the program [unset-variable] (0 is used; on the "
            "control it keeps its last value)");
  EXPECT_EQ(said_of(Dialect::fanuc, "G0 X1\nX[#500]"),
            "f:2:3: warning: #500 has not been set by the program [unset-variable] (0 is used; on the "
            "control it keeps its last value)");
  EXPECT_EQ(said_of(Dialect::fanuc, "G0 X1\nX#5021"),
            "f:2:2: warning: #5021 is a control-internal value [control-variable] (0 is used; the control "
            "may run another path)");
  EXPECT_EQ(
      said_of(Dialect::linuxcnc, "G0 X1\nX#<depth>"),
      "f:2:2: error: #<depth> has not been set [unset-variable] (the block does not move; set it before, or "
      "check how the name is written)");
}

TEST(IsoVariables, ThoseOfTheControlCannotBeSet) {
  EXPECT_EQ(said_of(Dialect::linuxcnc, "G0 X1\n#5420=3"),
            "f:2:1: error: #5420 is read-only [variable] (the assignment is skipped; use another variable)");
  EXPECT_EQ(said_of(Dialect::fanuc, "G0 X1\n#0=3"),
            "f:2:1: error: #0 is read-only [variable] (the assignment is skipped; use another variable)");
}

TEST(IsoVariables, AnAlarmEndsTheProgram) {
  const ReadProgram program = read_as(Dialect::fanuc, "G0 X1\n#3000=12(NO TOOL)\nX5\n");
  ASSERT_EQ(program.motions.size(), 1U);
  ASSERT_EQ(program.diagnostics.size(), 2U);
  EXPECT_EQ(
      format(program.diagnostics[0], "f"),
      "f:2:1: error: the program raises alarm 12 [alarm] (the control stops here; check the condition that "
      "leads to it)");
  EXPECT_EQ(program.diagnostics[1].code, "text-after-end");
}

TEST(IsoVariables, DwellsHaveTheUnitOfTheDialect) {
  const auto dwell = [](Dialect dialect, const char* text) {
    return read_clean_as(dialect, text).motions.at(0).dwell;
  };
  EXPECT_EQ(dwell(Dialect::linuxcnc, "G4 P2"), 2);
  EXPECT_EQ(dwell(Dialect::grbl, "G4 P2"), 2);
  EXPECT_EQ(dwell(Dialect::fanuc, "G4 P20"), 0.02);
  EXPECT_EQ(dwell(Dialect::fanuc, "G4 P2."), 2);
  EXPECT_EQ(dwell(Dialect::fanuc, "#1=500\nG4 P#1"), 0.5);
  EXPECT_EQ(dwell(Dialect::fanuc, "G4 X2"), 2);
  EXPECT_EQ(dwell(Dialect::iso, "G4 P200"), 0.2);
}

}  // namespace
}  // namespace feedscope

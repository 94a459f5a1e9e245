#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <vector>

#include "tests/core/program/iso/iso_text.h"

namespace feedscope {
namespace {

using Way = std::vector<double>;

Way linuxcnc(const std::string& text) {
  return way(Dialect::linuxcnc, "G0\n" + text);
}
Way fanuc(const std::string& text) {
  return way(Dialect::fanuc, "G0\n" + text);
}

TEST(OWords, IfTakesTheFirstBranchThatHolds) {
  const auto branch = [](int value) {
    return linuxcnc(
        "#1=" + std::to_string(value) +
        "\no10 if [#1 EQ 1]\nX1\no10 elseif [#1 EQ 2]\nX2\no10 elseif [#1 LT 4]\nX3\no10 else\nX4\n"
        "o10 endif\nX9");
  };
  EXPECT_EQ(branch(1), (Way{1, 9}));
  EXPECT_EQ(branch(2), (Way{2, 9}));
  EXPECT_EQ(branch(3), (Way{3, 9}));
  EXPECT_EQ(branch(4), (Way{4, 9}));
}

TEST(OWords, AnIfThatDoesNotHoldIsSkippedWithWhatItHolds) {
  EXPECT_EQ(linuxcnc("o1 if [0]\no2 if [1]\nX1\no2 else\nX2\no2 endif\no1 endif\nX3"), (Way{3}));
  EXPECT_EQ(linuxcnc("o1 if [1]\no2 if [0]\nX1\no2 else\nX2\no2 endif\no1 else\nX4\no1 endif\nX3"),
            (Way{2, 3}));
}

TEST(OWords, WhileRunsAsLongAsItHolds) {
  EXPECT_EQ(linuxcnc("#1=0\no<loop> while [#1 LT 3]\n#1=[#1+1]\nX#1\no<loop> endwhile\nX9"),
            (Way{1, 2, 3, 9}));
  EXPECT_EQ(linuxcnc("o1 while [0]\nX1\no1 endwhile\nX9"), (Way{9}));
}

TEST(OWords, DoRunsOnceBeforeItAsks) {
  EXPECT_EQ(linuxcnc("#1=5\no1 do\nX#1\n#1=[#1+1]\no1 while [#1 LT 3]\nX9"), (Way{5, 9}));
  EXPECT_EQ(linuxcnc("#1=1\no1 do\nX#1\n#1=[#1+1]\no1 while [#1 LE 3]\nX9"), (Way{1, 2, 3, 9}));
}

TEST(OWords, RepeatCounts) {
  EXPECT_EQ(linuxcnc("G91\no1 repeat [3]\nX1\no1 endrepeat\n"), (Way{1, 2, 3}));
  EXPECT_EQ(linuxcnc("o1 repeat [0]\nX1\no1 endrepeat\nX2"), (Way{2}));
  EXPECT_EQ(linuxcnc("G91\no1 repeat [2]\no2 repeat [2]\nX1\no2 endrepeat\nX10\no1 endrepeat\n"),
            (Way{1, 2, 12, 13, 14, 24}));
}

TEST(OWords, BreakAndContinueRuleTheLoopTheyName) {
  EXPECT_EQ(
      linuxcnc("#1=0\no1 while [1]\n#1=[#1+1]\no2 if [#1 EQ 2]\no1 continue\no2 endif\no3 if [#1 GT 3]\n"
               "o1 break\no3 endif\nX#1\no1 endwhile\nX9"),
      (Way{1, 3, 9}));
  EXPECT_EQ(linuxcnc("G91\no1 repeat [5]\nX1\no2 if [#5420 GE 2]\no1 break\no2 endif\no1 endrepeat\nX10"),
            (Way{1, 2, 12}));
  EXPECT_EQ(linuxcnc("#1=0\no1 repeat [3]\n#1=[#1+1]\no2 if [#1 EQ 2]\no1 continue\no2 endif\nX#1\n"
                     "o1 endrepeat"),
            (Way{1, 3}));
  EXPECT_EQ(
      linuxcnc("#1=0\no1 do\n#1=[#1+1]\no2 if [#1 EQ 2]\no1 continue\no2 endif\nX#1\no1 while [#1 LT 3]"),
      (Way{1, 3}));
}

TEST(OWords, LabelsMayBeUsedAgainAndHaveLeadingZeros) {
  EXPECT_EQ(linuxcnc("o1 if [1]\nX1\no01 endif\nO1 IF [0]\nX2\nO1 ENDIF\nN5 o1if[1]\nX3\n/o1endif"),
            (Way{1, 3}));
}

TEST(OWords, ALineRunsWithTheNumberOfItsText) {
  const ReadProgram program =
      read_clean_as(Dialect::linuxcnc, "G0 X1\no1 repeat [2]\nG91 X1\no1 endrepeat\n");
  ASSERT_EQ(program.motions.size(), 3U);
  EXPECT_EQ(program.motions[1].line, 3U);
  EXPECT_EQ(program.motions[2].line, 3U);
  EXPECT_EQ(program.block_count, 1U + 1 + 2 * 2);
}

TEST(MacroB, IfGoesOrDoes) {
  EXPECT_EQ(fanuc("#1=1\nIF [#1 EQ 1] GOTO 10\nX1\nN10 X2"), (Way{2}));
  EXPECT_EQ(fanuc("#1=2\nIF[#1EQ1]GOTO10\nX1\nN10 X2"), (Way{1, 2}));
  EXPECT_EQ(fanuc("IF [1] THEN GOTO 10\nX1\nN10 X2"), (Way{2}));
  EXPECT_EQ(fanuc("#1=2\nIF[#1 EQ 2] THEN #1=7\nX#1\nIF[#1 EQ 2] THEN #1=8\nX#1"), (Way{7, 7}));
}

TEST(MacroB, GotoSearchesOnwardsThenFromTheStart) {
  EXPECT_EQ(fanuc("#1=0\nN10 #1=#1+1\nX#1\nIF [#1 LT 3] GOTO 10\nX9"), (Way{1, 2, 3, 9}));
  EXPECT_EQ(fanuc("GOTO 10\nN10 X1\nN10 X2"), (Way{1, 2}));
  EXPECT_EQ(fanuc("#5=20\nGOTO #5\nX1\nN20 X2"), (Way{2}));
  EXPECT_EQ(fanuc("GOTO [10+10]\nX1\nN0020 X2"), (Way{2}));
}

TEST(MacroB, LoopsNestAndNumbersAreUsedAgain) {
  EXPECT_EQ(fanuc("#1=0\nWHILE [#1 LT 2] DO1\n#2=0\nWHILE [#2LT2] DO 2\nX[#1*10+#2]\n#2=#2+1\nEND2\n#1=#1+1\n"
                  "END 1\nWHILE [#1 GT 0] DO1\nX[100+#1]\n#1=#1-1\nEND1"),
            (Way{0, 1, 10, 11, 102, 101}));
}

TEST(MacroB, DoWithoutWhileEndsByGoto) {
  EXPECT_EQ(fanuc("#1=0\nDO1\n#1=#1+1\nX#1\nIF [#1 GE 3] GOTO 9\nEND1\nN9 X9"), (Way{1, 2, 3, 9}));
}

TEST(MacroB, OutputIsLeftOut) {
  EXPECT_EQ(said_of(Dialect::fanuc, "G0 X1\nDPRNT[X#1[53]]"),
            "f:2:1: info: DPRNT writes to a device [output-statement] (it does not change the path)");
  EXPECT_EQ(read_as(Dialect::fanuc, "POPEN\nG0 X1\nBPRNT[A]\nPCLOS").motions.size(), 1U);
}

struct Fault {
  Dialect dialect;
  const char* text;
  const char* expected;
};

void PrintTo(const Fault& fault, std::ostream* out) {
  *out << fault.text;
}

class FlowFaults : public testing::TestWithParam<Fault> {};

TEST_P(FlowFaults, NamePlaceThingAndWhatToDo) {
  EXPECT_EQ(said_of(GetParam().dialect, std::string("G0 X1\n") + GetParam().text), GetParam().expected);
}

INSTANTIATE_TEST_SUITE_P(
    Texts, FlowFaults,
    testing::Values(
        Fault{Dialect::linuxcnc, "o5 if [1]",
              "f:2:1: error: \"o5 if\" has no endif [flow-pair] (it is skipped; check the labels)"},
        Fault{Dialect::linuxcnc, "o<a> endwhile",
              "f:2:1: error: \"o<a> endwhile\" has no while [flow-pair] (it is skipped; check the labels)"},
        Fault{
            Dialect::linuxcnc, "o5 break",
            "f:2:1: error: \"o5 break\" has no loop around it [flow-pair] (it is skipped; check the labels)"},
        Fault{Dialect::linuxcnc, "o<a> turn",
              "f:2:1: error: \"o<a> turn\" is not an O word [unread-statement] (the line is skipped; O words "
              "are sub, call, if, while, do, repeat and their ends)"},
        Fault{Dialect::linuxcnc, "o5 while [#<a>]\nX5\no5 endwhile",
              "f:2:11: error: #<a> has not been set [unset-variable] (the block does not move; set it "
              "before, or "
              "check how the name is written)"},
        Fault{Dialect::linuxcnc, "o5 if [1] X5\no5 endif",
              "f:2:11: error: \"X5\" follows a statement [unread-statement] (it is skipped; write it "
              "in a line "
              "of its own)"},
        Fault{Dialect::fanuc, "GOTO 7 X5\nN7",
              "f:2:8: error: \"X5\" follows a statement [unread-statement] (it is skipped; write it "
              "in a line "
              "of its own)"},
        Fault{
            Dialect::fanuc, "END2",
            "f:2:1: error: \"END2\" has no DO with its number [flow-pair] (it is skipped; check the labels)"},
        Fault{Dialect::fanuc, "WHILE [1] DO1",
              "f:2:1: error: \"WHILE [1] DO1\" has no END with its number [flow-pair] (it is skipped; check "
              "the labels)"},
        Fault{Dialect::fanuc, "IF [1] X5",
              "f:2:8: error: GOTO or THEN is missing after the condition [expression] (the line is skipped; "
              "complete it)"},
        Fault{Dialect::fanuc, "GOTO 7",
              "f:2:6: error: jump target N7 does not exist [jump-target] (the jump is skipped; correct the "
              "number)"}));

TEST(IsoFlow, IfOverManyLinesTakesTheBranchThatHolds) {
  const auto branch = [](int value) {
    return fanuc("#1=" + std::to_string(value) +
                 "\nIF[#1EQ1]THEN\nX1\nELSEIF [#1 EQ 2] THEN (two)\nX2\nIF[1]THEN\nX2.5\nENDIF\nELSE\nX3\n"
                 "N20 ENDIF\nX9");
  };
  EXPECT_EQ(branch(1), (Way{1, 9}));
  EXPECT_EQ(branch(2), (Way{2, 2.5, 9}));
  EXPECT_EQ(branch(3), (Way{3, 9}));
}

TEST(IsoFlow, TheFirstTwoLettersOfAMacroWordAreEnough) {
  EXPECT_EQ(fanuc("#1=0\nWH[#1LT3]DO1\n#1=#1+1\nX#1\nEN1\nIF[#1EQ3]GO5\nX8\nN5X9\nIF[1]TH#2=7\nX#2"),
            (Way{1, 2, 3, 9, 7}));
}

TEST(IsoFlow, AnIfOverManyLinesNeedsItsEnd) {
  EXPECT_EQ(said_of(Dialect::fanuc, "G0 X1\nIF[1]THEN\nX2"),
            "f:2:6: error: \"IF\" has no ENDIF [flow-pair] (it is skipped; check the labels)");
}

TEST(IsoFlow, AnEndlessLoopIsStopped) {
  for (const auto& [dialect, text] :
       {std::pair(Dialect::linuxcnc, "o1 while [1]\nX1\no1 endwhile\n"),
        std::pair(Dialect::fanuc, "DO1\nX1\nEND1\n"), std::pair(Dialect::fanuc, "N1 X1\nGOTO 1\n")}) {
    const ReadProgram program =
        read_text(std::string("G0 X1\n") + text, {.dialect = dialect, .repeat_limit = 1000});
    ASSERT_EQ(program.diagnostics.size(), 1U);
    EXPECT_EQ(program.diagnostics[0].code, "run-limit");
    EXPECT_LT(program.motions.size(), 1100U);
  }
}

TEST(IsoFlow, WhatFollowsDoInItsLineBelongsToTheLoop) {
  // Against the same loop in lines of its own, for every way to write it.
  const std::vector<double> expected{1, 2, 3, 4, 9};
  for (const std::string loop :
       {"WHILE [#1 LT 4] DO1\n#1=#1+1\nG0 X#1\nEND1", "WHILE[#1LT4]DO1#1=#1+1\nX#1\nEND1",
        "WHILE [#1 LT 4] DO1 #1=#1+1\nG0 X#1\nEND1", "WHILE [#1 LT 4] DO1 #1=#1+1 X#1\nEND1",
        "DO1 #1=#1+1\nX#1\nIF [#1 GE 4] GOTO 5\nEND1\nN5",
        "DO1 IF [#1 GE 4] GOTO 5\n#1=#1+1\nX#1\nEND1\nN5"}) {
    EXPECT_EQ(way(Dialect::fanuc, "G0\n#1=0\n" + loop + "\nX9"), expected) << loop;
  }
  EXPECT_EQ(way(Dialect::fanuc, "G0\nWHILE [0] DO1 X5\nEND1\nX9"), (std::vector<double>{9}))
      << "nothing of a loop that does not begin";
}

TEST(IsoFlow, AProgramThatWasCutOffSaysSo) {
  const std::string endless = "G0 X1\nDO1\nX1\nEND1\n";
  EXPECT_TRUE(read_text(endless, {.dialect = Dialect::fanuc, .repeat_limit = 1000}).cut_off);
  EXPECT_FALSE(read_text("G0 X1\n", {.dialect = Dialect::fanuc, .repeat_limit = 1000}).cut_off);
}

TEST(IsoFlow, ASubWithinASubIsAnError) {
  const ReadProgram program =
      read_text("G0\no1 sub\nX1\no2 sub\nX2\no2 endsub\no1 endsub\nX9\n", {.dialect = Dialect::linuxcnc});
  ASSERT_EQ(program.diagnostics.size(), 1U);
  EXPECT_EQ(format(program.diagnostics[0], "f"),
            "f:4: error: a sub inside the sub of line 2 [flow-pair] (LinuxCNC rejects the program; write one "
            "subprogram after the other)");
  EXPECT_TRUE(
      read_text("G0\no1 sub\nX1\no1 endsub\no2 sub\nX2\no2 endsub\nX9\n", {.dialect = Dialect::linuxcnc})
          .diagnostics.empty());
}

TEST(IsoFlow, ALoopOfDeepHolesIsStopped) {
  const ReadProgram program = read_text("G0 X0 Y0 Z2\nDO1\nG83 X1 R1 Z-99 Q0.01 F100\nEND1\n",
                                        {.dialect = Dialect::fanuc, .repeat_limit = 1000});
  ASSERT_EQ(program.diagnostics.size(), 1U);
  EXPECT_EQ(program.diagnostics[0].code, "run-limit");
  EXPECT_LT(program.motions.size(), 25U * 1000 + 30100);  // the limit, and one hole of 10000 pecks
}

TEST(IsoFlow, DeletedLinesRuleNoFlowWithTheSwitchOn) {
  const std::string text = "G0\n/o1 if [0]\nX1\n/o1 endif\nX2\n";
  EXPECT_EQ(read_text(text, {.dialect = Dialect::linuxcnc}).motions.size(), 1U);
  EXPECT_EQ(read_text(text, {.dialect = Dialect::linuxcnc, .skip_deleted_blocks = true}).motions.size(), 2U);
}

}  // namespace
}  // namespace feedscope

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <memory>
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

Way way_of(const ReadProgram& program) {
  Way positions;
  for (const MotionBlock& block : program.motions) {
    positions.push_back(block.target.x());
  }
  return positions;
}

TEST(OCalls, SubprogramsAreSkippedWhereTheyStandAndRunWhereTheyAreCalled) {
  EXPECT_EQ(linuxcnc("o100 sub\nX1\no100 endsub\nX5\no100 call\nX6\no100 call\n"), (Way{5, 1, 6, 1}));
  EXPECT_EQ(linuxcnc("o<a> call\no<a> sub\nX1\no<a> endsub\nX2"), (Way{1, 2}));
}

TEST(OCalls, ArgumentsAreLocalAndMissingOnesZero) {
  EXPECT_EQ(
      linuxcnc(
          "#1=50 #<a>=8\no1 sub\nX#1\nX#2\nX#3\n#1=99\n#<a>=3\no1 endsub\no1 call [1+1] [7]\nX#1\nX#<a>"),
      (Way{2, 7, 0, 50, 8}));
}

TEST(OCalls, VariablesBeyondThirtyAndUnderscoredNamesAreGlobal) {
  EXPECT_EQ(linuxcnc("o1 sub\n#31=4\n#<_b>=5\no1 endsub\no1 call\nX#31\nX#<_b>"), (Way{4, 5}));
}

TEST(OCalls, CallsNestAndRecur) {
  EXPECT_EQ(
      linuxcnc("o1 sub\no2 if [#1 GT 0]\nX#1\no1 call [#1-1]\nX[10*#1]\no2 endif\no1 endsub\no1 call [3]"),
      (Way{3, 2, 1, 10, 20, 30}));
}

TEST(OCalls, ReturnEndsThemWithAValue) {
  EXPECT_EQ(
      linuxcnc(
          "o1 sub\no2 if [#1 EQ 1]\no1 return [7]\no2 endif\nX1\no1 endsub [8]\no1 call [1]\nX#<_value>\n"
          "o1 call [0]\nX#<_value>\nX#<_value_returned>"),
      (Way{7, 1, 8, 1}));
}

TEST(OCalls, ALoopAroundAReturnStartsAnewInTheNextCall) {
  EXPECT_EQ(
      linuxcnc("G91\no1 sub\no2 repeat [3]\nX1\no3 if [#1]\no1 return\no3 endif\no2 endrepeat\no1 endsub\n"
               "o1 call [1]\no1 call [0]\n"),
      (Way{1, 2, 3, 4}));
}

TEST(OCalls, LabelsMayBeComputed) {
  EXPECT_EQ(
      linuxcnc("#1=100\no100 sub\nX1\no100 endsub\no101 sub\nX2\no101 endsub\no#1 call\no[#1+1] call\n"),
      (Way{1, 2}));
}

TEST(MCalls, AProgramBehindTheEndIsRunSeveralTimes) {
  EXPECT_EQ(fanuc("G91\nM98 P10 L3\nX10\nM30\nO10\nX1\nM99\n"), (Way{1, 2, 3, 13}));
  EXPECT_EQ(fanuc("G91\nM98 P30010\nX10\nM30\nO0010 (HOLES)\nX1\nM99\n"), (Way{1, 2, 3, 13}));
  EXPECT_EQ(fanuc("M98 P10 L0\nX10\nO10\n"), (Way{10}));
  EXPECT_EQ(fanuc("M98 P1\nX9\nM30\nO1\nX1\nM98 P2\nX2\nM99\nO2\nX3\nM99"), (Way{1, 3, 2, 9}));
}

TEST(MCalls, MotionOfTheBlockComesFirst) {
  EXPECT_EQ(fanuc("X5 M98 P1\nX9\nM30\nO1 X1\nM99 X7"), (Way{5, 1, 7, 9}));
}

TEST(MCalls, M198IsACallOnAFanucOnly) {
  EXPECT_EQ(fanuc("M198 P1\nX9\nM30\nO1\nX1\nM99"), (Way{1, 9}));
  EXPECT_EQ(linuxcnc("M198 P1\nX9\n"), (Way{9}));
}

TEST(MCalls, VariablesAreTheCallers) {
  EXPECT_EQ(linuxcnc("#1=0\nM98 P1 L10\nX#1\nM30\nO1\n#1=[#1+1]\nM99"), (Way{10}));
  EXPECT_EQ(fanuc("#1=0\nM98 P1 L10\nX#1\nM30\nO1\n#1=#1+1\nM99"), (Way{10}));
}

TEST(MCalls, M99GoesToABlockOfTheCaller) {
  EXPECT_EQ(fanuc("M98 P1\nX1\nN20 X2\nM30\nO1\nX5\nM99 P20"), (Way{5, 2}));
  EXPECT_EQ(fanuc("M99 P20\nX1\nN20 X2"), (Way{2}));
}

TEST(MCalls, ReturnsToTheSameLineNumberInTheTextCalledFromAndM97RunsBlocks) {
  EXPECT_EQ(fanuc("G91\nM97 P100 L2\nX10\nM30\nN100 X1\nM99"), (Way{1, 2, 12}));
}

TEST(MCalls, AMainProgramThatStartsOverIsShownOnce) {
  EXPECT_EQ(way(Dialect::fanuc, "G0 X1\nM99\n"), (Way{1}));
  EXPECT_EQ(said_of(Dialect::fanuc, "N1 G0 X1\nM99 P1"),
            "f:2:1: info: the program repeats from N1 without end [endless-program] (one pass is shown)");
}

TEST(MCalls, AProgramEndsWhereTheNextOneBegins) {
  EXPECT_EQ(way_of(read_as(Dialect::fanuc, "O1\nG0 X1\nM98 P3\nX2\nO2\nX7\nM30\nO3\nX3\nO4\nX8\nM99")),
            (Way{1, 3, 2}));
}

TEST(MCalls, M97WithoutPEndsInterruptsAndCallsNothing) {
  EXPECT_EQ(fanuc("M97\nX1"), (Way{1}));
}

TEST(MCalls, ABlockThatCannotBeReadCallsNothing) {
  const ReadProgram program = read_as(Dialect::fanuc, "G0 X1\nG65 P1 A[\nM98 P[\nM30\nO1\nX5\nM99");
  EXPECT_EQ(way_of(program), (Way{1}));
}

TEST(ModalState, IsKeptAndRestored) {
  const ReadProgram program =
      read_clean_as(Dialect::linuxcnc, "G1 G90 F600 G64 P0.1\nX1\nM70\nG20\nG91 G18 F1 G61\nX1\nM72\nX2\n");
  ASSERT_EQ(program.motions.size(), 3U);
  EXPECT_NEAR(program.motions[1].target.x(), 26.4, 1e-12);
  EXPECT_EQ(program.motions[2].target.x(), 2);
  EXPECT_EQ(program.motions[2].feed, 10);
  EXPECT_EQ(program.motions[2].path_control, program.motions[0].path_control);
  EXPECT_NE(program.motions[1].path_control, program.motions[0].path_control);
}

TEST(ModalState, M73RestoresItAtTheReturn) {
  EXPECT_EQ(linuxcnc("o1 sub\nM73\nG91\nX1\nX1\no1 endsub\nX5\no1 call\nX3\n"), (Way{5, 6, 7, 3}));
}

TEST(ModalState, HoldsTheWorkOffset) {
  EXPECT_EQ(linuxcnc("G10 L2 P1 X10\nG10 L2 P2 X20\nG54 X0\nM70\nG55 X0\nM72\nX0"), (Way{10, 20, 10}));
}

TEST(ModalState, M71ForgetsIt) {
  EXPECT_EQ(
      said_of(Dialect::linuxcnc, "G0 X1\nM70\nM71\nM72\n"),
      "f:4:1: error: M72 has no modal state to restore [modal-state] (nothing changes; write M70 before it)");
}

TEST(Tools, AreListedInTheOrderOfTheirFirstUse) {
  const ReadProgram program = read_clean_as(Dialect::fanuc, "G0 X1\nT5 M6\nT2\nM6\nT5\nM6\nT0\n#1=7\nT#1\n");
  ASSERT_EQ(program.tools.size(), 3U);
  EXPECT_EQ(program.tools[0].name, "5");
  EXPECT_EQ(program.tools[1].name, "2");
  EXPECT_EQ(program.tools[1].line, 3U);
  EXPECT_EQ(program.tools[2].name, "7");
}

TEST(Grbl, CommandsAndMessagesAreNoBlocks) {
  EXPECT_EQ(said_of(Dialect::grbl, "$H\nG0 X1\nM117 Layer 3 of X5\n"),
            "f:1:1: info: \"$H\" is a control command [control-command] (it does not change the path)");
  EXPECT_EQ(way(Dialect::grbl, "G0 X1\nM117 X5\nX2"), (Way{1, 2}));
}

TEST(Macros, ArgumentsBecomeVariables) {
  EXPECT_EQ(
      fanuc(
          "G65 P9010 A1 B2 C3 D7 E8 F9 H11 M13 Q17 R18 S19 T20 U21 V22 W23 X24 Y25 Z26 I4 J5 K6\nM30\nO9010\n"
          "#33=1\nWHILE[#33LE26]DO1\nX#[#33]\n#33=#33+1\nEND1\nM99"),
      (Way{1, 2, 3, 4, 5, 6, 7, 8, 9, 11, 13, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26}));
}

TEST(Macros, ArgumentsInGroupsOfIJK) {
  EXPECT_EQ(fanuc("G65 P1 A1 I4 J5 K6 I7 J8 K9 I10 K12\nM30\nO1\nX#4\nX#7\nX#8\nX#10\nX#11\nX#12\nM99"),
            (Way{4, 7, 8, 10, 12}));
}

TEST(Macros, HaveVariablesOfTheirOwnAtEachRun) {
  EXPECT_EQ(
      fanuc("#1=5\nG65 P1 A2 L2\nX#1\nM30\nO1\nX#1\n#1=#1+1\nX#1\nIF [#2 EQ #0] GOTO 5\nX99\nN5 #2=1\nM99"),
      (Way{2, 3, 2, 3, 5}));
}

TEST(Macros, ModalOnesRunAfterEachMotion) {
  EXPECT_EQ(fanuc("G91\nX1\nG66 P1 Z5\nX1\nM8\nX1\nG67\nX1\nM30\nO1\nX[10*#26]\nX[-10*#26]\nM99"),
            (Way{1, 2, 52, 2, 3, 53, 3, 4}));
}

TEST(Macros, AModalOneThatIsMissingIsSaidWhereItIsAskedFor) {
  const ReadProgram program =
      read_text("G1 X1 F100\n  G66 P7 Z5\nX2\n(short)\nX3\nG67\nX4\nM30\n", {.dialect = Dialect::fanuc});
  ASSERT_EQ(program.diagnostics.size(), 1U);
  EXPECT_EQ(program.diagnostics[0].code, "subprogram");
  EXPECT_EQ(program.diagnostics[0].line, 2U);
  EXPECT_EQ(program.diagnostics[0].column, 7U);
  EXPECT_EQ(program.motions.size(), 4U);
}

TEST(Macros, GotoStaysInItsProgram) {
  EXPECT_EQ(fanuc("N10 X1\nG65 P1\nX2\nM30\nO1\n#1=#1+1\nIF [#1 EQ 1] GOTO 10\nX8\nN10 X3\nM99"),
            (Way{1, 3, 2}));
}

class FilesBeside : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::path(testing::TempDir()) /
              (std::string("feedscope_") + testing::UnitTest::GetInstance()->current_test_info()->name());
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    return folder_ / name;
  }
  ReadProgram read(const std::string& name, Dialect dialect, const std::string& text) const {
    return read_program(std::make_shared<const SourceText>(SourceText::from_file(write(name, text))), nullptr,
                        {.dialect = dialect, .unit = LengthUnit::mm});
  }
  std::filesystem::path folder_;
};

TEST_F(FilesBeside, AreFoundByNumberAndReadOnce) {
  write("o0100.NC", "%\nO0100\nX1\nX2\nM99\n%\n");
  const ReadProgram program = read("main.nc", Dialect::fanuc, "G0 X5\nM98 P100 L2\nX6\nM30\n");
  EXPECT_EQ(way_of(program), (Way{5, 1, 2, 1, 2, 6}));
  EXPECT_TRUE(program.diagnostics.empty());
  EXPECT_EQ(program.motions[1].line, 2U) << "of the call";
}

TEST_F(FilesBeside, ReturnAtTheirEndWithoutM99) {
  write("100.ngc", "X1\n");
  EXPECT_EQ(way_of(read("main.ngc", Dialect::linuxcnc, "G0 X5\nM98 P100\nX6\n")), (Way{5, 1, 6}));
}

TEST_F(FilesBeside, HoldNamedSubprogramsThatCallThoseOfTheProgram) {
  write("drill.ngc",
        "o<helper> sub\nX8\no<helper> endsub\no<drill> sub\nX#1\no<helper> call\no<own> call\n"
        "o<drill> endsub\nM2\n");
  const ReadProgram program =
      read("main.ngc", Dialect::linuxcnc, "G0\no<own> sub\nX9\no<own> endsub\no<Drill> call [3]\nX4\n");
  EXPECT_EQ(way_of(program), (Way{3, 8, 9, 4}));
  EXPECT_TRUE(program.diagnostics.empty());
  EXPECT_EQ(program.motions[0].line, 5U);
}

TEST_F(FilesBeside, AreCalledByNameInBrackets) {
  write("pocket.nc", "X1\nM99\n");
  EXPECT_EQ(way_of(read("main.nc", Dialect::fanuc, "G0 X5\nM98 (/jobs/POCKET.nc) L2\nX6\n")),
            (Way{5, 1, 1, 6}));
}

TEST_F(FilesBeside, AFaultNamesTheFile) {
  write("O7.nc", "X1\nX[1\nM99");
  const ReadProgram program = read("main.nc", Dialect::fanuc, "G0 X5\nM98 P7\n");
  ASSERT_EQ(program.diagnostics.size(), 1U);
  EXPECT_EQ(program.diagnostics[0].line, 2U);
  EXPECT_NE(program.diagnostics[0].file.find("O7.nc"), std::string::npos);
}

struct Fault {
  Dialect dialect;
  const char* text;
  const char* expected;
};

void PrintTo(const Fault& fault, std::ostream* out) {
  *out << fault.text;
}

class CallFaults : public testing::TestWithParam<Fault> {};

TEST_P(CallFaults, NamePlaceThingAndWhatToDo) {
  EXPECT_EQ(said_of(GetParam().dialect, std::string("G0 X1\n") + GetParam().text), GetParam().expected);
}

INSTANTIATE_TEST_SUITE_P(
    Texts, CallFaults,
    testing::Values(
        Fault{Dialect::fanuc, "M98 P77",
              "f:2:5: error: M98 calls program 77, which is neither in the program nor in a file in its "
              "folder [subprogram] (its motion is missing; add the file \"O0077\" to the program's folder)"},
        Fault{Dialect::fanuc, "M98",
              "f:2:1: error: M98 without P [subprogram] (nothing is called; write P with the number of the "
              "subprogram)"},
        Fault{
            Dialect::fanuc, "G65 A1",
            "f:2:1: error: G65 without P [subprogram] (nothing is called; write P with the macro's number)"},
        Fault{Dialect::fanuc, "G65 P9 A1",
              "f:2:5: error: macro program 9 is called, which is neither in the program nor in a file in its "
              "folder [subprogram] (its motion is missing; add the file \"O0009\" to the program's folder)"},
        Fault{Dialect::linuxcnc, "o<probe> call [1]",
              "f:2:1: error: o<probe> is called, which is neither in the program nor in a file in its folder "
              "[subprogram] (its motion is missing; add the file \"probe.ngc\" to the program's folder)"},
        Fault{Dialect::fanuc, "M97 P5",
              "f:2:1: error: M97 without P and the number of a block in this program [jump-target] (nothing "
              "is called; write P with the N number of the first block)"},
        Fault{Dialect::fanuc, "M98 P1 L-1\nM30\nO1\nM99",
              "f:2:8: error: L-1 is not a number of times from 0 to 1000000000 [repeat-count] (it is run "
              "once)"},
        Fault{Dialect::linuxcnc, "o5 return",
              "f:2:9: error: return or endsub outside a subprogram [flow-pair] (it is skipped; a subprogram "
              "is written between sub and endsub)"}));

TEST(IsoCalls, EndlessRecursionIsStopped) {
  const ReadProgram program =
      read_as(Dialect::linuxcnc, "G0 X1\no1 sub\nX2\no1 call\no1 endsub\no1 call\nX3\n");
  ASSERT_EQ(program.diagnostics.size(), 1U);
  EXPECT_EQ(program.diagnostics[0].code, "call-depth");
  EXPECT_EQ(program.motions.size(), 1U + 64 + 1);
}

}  // namespace
}  // namespace feedscope

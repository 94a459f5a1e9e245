#include "core/program/tools/tool_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/error.h"

namespace feedscope {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pair;

std::map<std::string, double> radii(const std::string& text, double unit = 1) {
  return read_tool_table(SourceText("tools", text), unit).all();
}

std::string fault_of(const std::string& text) {
  try {
    read_tool_table(SourceText("tools", text));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(ToolTable, LinuxcncGivesDiameters) {
  EXPECT_THAT(radii("; my tools\nT1 P1 D10 Z+50.5 ;end mill D20\nT2 P2 Z1\nt12 P3 d6.5\n"),
              ElementsAre(Pair("1", 5), Pair("12", 3.25)));
  EXPECT_THAT(radii("T3 P1 D0.5\n", 25.4), ElementsAre(Pair("3", 6.35)));
}

TEST(ToolTable, SinumerikHasEdgesWearAndNames) {
  EXPECT_THAT(radii("%_N_TO_INI\nN10 $TC_TP2[2]=\"MILL_10\"\n$TC_DP6[2,1]=5\n$TC_DP15[2,1]=-0.02\n"
                    "$TC_DP1[2,2]=120 $TC_DP6[2,2] = 4 $TC_DP3[2,1]=100\n"),
              ElementsAre(Pair("2", 4.98), Pair("2,2", 4), Pair("MILL_10", 4.98), Pair("MILL_10,2", 4)));
}

TEST(ToolTable, AToolWithoutANameGoesByItsNumber) {
  EXPECT_THAT(radii("$TC_TP2[3]=\"\"\n$TC_DP6[3,1]=5\n$TC_DP6[3,2]=4\n"),
              ElementsAre(Pair("3", 5), Pair("3,2", 4)));
  EXPECT_THAT(radii("$TC_TP2[3]=\",2\"\n$TC_DP6[3,1]=5\n"), ElementsAre(Pair("3", 5)));
  EXPECT_THAT(radii("nr;name;radius\n3;,1;5\n;\" \";4\n"), ElementsAre(Pair("3", 5)));
}

TEST(ToolTable, FanucOffsetsAddTheirWearAndNameTheirUnit) {
  EXPECT_THAT(
      radii("%\nO9999\nG10 L10 P1 R150.\nG10 L12 P1 R5. (T1)\nG10 L13 P1 R-.01\nG20\nG10L12P2R.25\n%\n"),
      ElementsAre(Pair("1", 4.99), Pair("2", 6.35)));
}

TEST(ToolTable, HeidenhainHasColumnsOfFixedWidth) {
  const std::string table =
      "BEGIN TOOL    .T MM\n"
      "T     NAME             L        R      R2   DL   DR\n"
      "0                      +0       +0     +0\n"
      "1     MILL D10         +85.5    +5     +0   +0   -0,01\n"
      "27    BALL             +60      +3     +3\n"
      "[END]\n";
  EXPECT_THAT(radii(table), ElementsAre(Pair("0", 0), Pair("1", 4.99), Pair("27", 3), Pair("BALL", 3),
                                        Pair("MILL D10", 4.99)));
  EXPECT_THAT(radii("BEGIN TOOL .T INCH\nT NAME R\n4      1\n"), ElementsAre(Pair("4", 25.4)));
}

TEST(ToolTable, ListOfASpreadsheet) {
  EXPECT_THAT(radii("T;Name;Diameter\n1;\"Mill 10\";10,0\n2;;6\n3;Probe;\n"),
              ElementsAre(Pair("1", 5), Pair("2", 3), Pair("MILL 10", 5)));
  EXPECT_THAT(radii("nr,radius\n7,2.5\n"), ElementsAre(Pair("7", 2.5)));
}

TEST(ToolTable, LeavesOutRadiiBelowZero) {
  EXPECT_THAT(radii("nr;radius\n1;-5\n2;3\n"), ElementsAre(Pair("2", 3)));
  EXPECT_THAT(radii("$TC_DP6[1,1]=1\n$TC_DP15[1,1]=-2\n$TC_DP6[2,1]=1\n"), ElementsAre(Pair("2", 1)));
}

TEST(ToolTable, FaultsNameTheirPlace) {
  EXPECT_THAT(fault_of("T1 P1 D1..0\n"), HasSubstr("line 1, column"));
  EXPECT_THAT(fault_of("nr;radius\n1;5\n2;x\n"), HasSubstr("line 3: \"x\" is not a number"));
  EXPECT_THAT(fault_of("$TC_DP6[1,1\n"), HasSubstr("line 1"));
  EXPECT_THAT(fault_of("$TC_DP6[]=5\n"), HasSubstr("line 1, column 9: a number is missing"));
  EXPECT_THAT(fault_of("$TC_DP6[1,]=5\n"), HasSubstr("line 1, column 11: a number is missing"));
  EXPECT_THAT(fault_of("$TC_DP6[1,1]=5\n$TC_TP2[\"7\"]=\"A\"\n"),
              HasSubstr("line 2, column 9: a number is missing"));
  EXPECT_THAT(fault_of("G1 X5\n"), HasSubstr("'tools' is not a supported tool table"));
  EXPECT_THAT(fault_of(""), HasSubstr("not a supported tool table"));
}

}  // namespace
}  // namespace feedscope

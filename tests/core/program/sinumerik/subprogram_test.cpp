#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/core/program/sinumerik/read_sinumerik.h"

namespace feedscope {
namespace {

using testing::ElementsAre;

TEST(SinumerikSubprograms, InTheSameFileBehindTheirHeads) {
  EXPECT_THAT(xs_of("%_N_MAIN_MPF\n;$PATH=/_N_WKS_DIR/_N_PART_WPD\nG0 X1\nSUB1 P2\nL10\nX9\nM30\n"
                    "%_N_SUB1_SPF\nG91\nX1\nG90\nM17\n%_N_L10_SPF\nX7\nRET"),
              ElementsAre(1, 2, 3, 7, 9));
}

TEST(SinumerikSubprograms, MainProgramMayStandBehindThem) {
  EXPECT_THAT(xs_of("%_N_SUB1_SPF\nG0 X5\nM17\n%_N_MAIN_MPF\nG0 X1\nSUB1\nM30"), ElementsAre(1, 5));
}

TEST(SinumerikSubprograms, TakeParametersByValueAndByReference) {
  EXPECT_THAT(
      xs_of("%_N_MAIN_MPF\nDEF REAL LENGTH=2\nDEF INT "
            "COUNT\nG0\nMOVE(3,LENGTH,\"NEAR\")\nX=LENGTH\nMOVE(1,LENGTH)\n"
            "M30\n%_N_MOVE_SPF\nPROC MOVE(REAL AT,VAR REAL BACK,STRING[8] HOW=\"FAR\") SAVE DISPLOF\n"
            "DEF REAL COUNT=100\nIF HOW==\"FAR\"\nX=AT+COUNT\nELSE\nX=AT+BACK\nENDIF\nBACK=AT*10\nRET"),
      ElementsAre(5, 30, 101));
}

TEST(SinumerikSubprograms, TakeArraysByValueAndByReference) {
  EXPECT_THAT(xs_of("%_N_MAIN_MPF\nDEF REAL VALS[3]=SET(1,2,3),SUMS[3]\nG0\nADD_UP(VALS,SUMS,10)\n"
                    "FOR R1=0 TO 2\nX=SUMS[R1]\nX=VALS[R1]\nENDFOR\nM30\n"
                    "%_N_ADD_UP_SPF\nPROC ADD_UP(REAL IN[3],VAR REAL OUT[],REAL MORE)\nDEF REAL OWN[3]\n"
                    "SHIFT(IN,OWN,MORE)\nFOR R2=0 TO 2\nOUT[R2]=OWN[R2]+IN[R2]\nIN[R2]=-1\nENDFOR\nRET\n"
                    "%_N_SHIFT_SPF\nPROC SHIFT(REAL IN[3],VAR REAL OUT[3],REAL MORE)\nFOR R3=0 TO 2\n"
                    "OUT[R3]=IN[R3]+MORE\nENDFOR\nRET"),
              ElementsAre(12, 1, 14, 2, 16, 3));
}

TEST(SinumerikSubprograms, SaveKeepsTheCallersModes) {
  EXPECT_THAT(
      xs_of("%_N_MAIN_MPF\nG0 X1\nMOVE\nX5\nM30\n%_N_MOVE_SPF\nPROC MOVE SAVE\nG91 X1\nTRANS X100\nM17"),
      ElementsAre(1, 2, 5));
}

TEST(SinumerikSubprograms, ModalCallFollowsEveryMotion) {
  EXPECT_THAT(xs_of("%_N_MAIN_MPF\nG0 X10\nMCALL STEP(1)\nX20\nY5\nM8\nMCALL\nX30\nM30\n%_N_STEP_SPF\n"
                    "PROC STEP(REAL BY)\nG91\nX=BY\nG90\nM17"),
              ElementsAre(10, 20, 21, 21, 22, 30));
}

TEST(SinumerikSubprograms, LieBesideTheProgramWhateverTheCaseOfTheirNames) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "sinumerik_subprograms";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "part.mpf") << "G0 X1\nCALL \"SUB_A\"\nL20 P2\nCALL \"/_N_SPF_DIR/_N_SUB_A_SPF\"\n"
                                        "EXTCALL(\"D:\\JOBS\\OP10.NC\")\nEXTCALL \"OP10\"\nM30\n";
  std::ofstream(folder / "op10.nc") << "X50\nX=IC(1)";
  std::ofstream(folder / "OP10.MPF") << "X60\nM30";
  std::ofstream(folder / "sub_a.spf") << "%_N_SUB_A_SPF\n;$PATH=/_N_SPF_DIR\nG91 X1\nG90\nM17\n";
  std::ofstream(folder / "L20.SPF") << "G91\nX10\nG90";
  const ReadProgram program =
      read_program(std::make_shared<const SourceText>(SourceText::from_file(folder / "part.mpf")), nullptr,
                   {.unit = LengthUnit::mm});
  EXPECT_EQ(program.dialect, Dialect::sinumerik);
  EXPECT_TRUE(program.diagnostics.empty()) << format(program.diagnostics.front(), "part.mpf");
  ASSERT_EQ(program.motions.size(), 8U);
  EXPECT_DOUBLE_EQ(program.motions[4].target.x(), 23);
  EXPECT_DOUBLE_EQ(program.motions[6].target.x(), 51);
  EXPECT_DOUBLE_EQ(program.motions.back().target.x(), 60);
  EXPECT_EQ(program.motions[1].line, 2U);
  std::filesystem::remove_all(folder);
}

TEST(SinumerikSubprograms, OneThatCallsItselfIsStopped) {
  const ReadProgram program = read_sinumerik("%_N_MAIN_MPF\nG0 X1\nSUB1\nM30\n%_N_SUB1_SPF\nSUB1\nM17");
  ASSERT_EQ(program.diagnostics.size(), 1U);
  EXPECT_EQ(program.diagnostics[0].code, "call-depth");
}

}  // namespace
}  // namespace feedscope

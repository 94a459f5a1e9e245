#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/core/program/heidenhain/read_heidenhain.h"

namespace feedscope {
namespace {

TEST(HeidenhainFlow, JumpsIfAParameterIsDefinedOrNot) {
  EXPECT_EQ(
      path_of(read_clean_heidenhain("FN 9: IF +Q5 IS UNDEFINED GOTO LBL 1\nL X+1 FMAX\nLBL 1\nQ5 = 0\n"
                                    "FN 9: IF +Q5 IS UNDEFINED GOTO LBL 2\nL Y+1 FMAX\nLBL 2\n"
                                    "FN 9: IF QS1 IS DEFINED GOTO LBL 3\nL Z+1 FMAX\nLBL 3\n"
                                    "FN 9: IF Q5 IS DEFINED GOTO LBL \"END\"\nL X+9 FMAX\nLBL \"END\"\n")),
      "r0,1,0 r0,1,1");
}

TEST(HeidenhainFlow, SubprogramsRunFromTheirLabelToLabelZero) {
  const ReadProgram program = read_clean_heidenhain(
      "BEGIN PGM A MM\nL X+1 F100\nCALL LBL 7\nL X+2\nCALL LBL \"HOLE\"\nL Z+0 M30\nLBL 7\nL IY+1\nLBL 0\n"
      "LBL \"HOLE\"\nL IY+5\nCALL LBL 7\nLBL 0\nEND PGM A MM\n");
  EXPECT_EQ(path_of(program), "1,0,0 1,1,0 2,1,0 2,6,0 2,7,0 2,7,0");
  EXPECT_EQ(program.call_count, 3U);
}

TEST(HeidenhainFlow, SectionsAreRepeatedFromTheirLabel) {
  EXPECT_EQ(path_of(read_clean_heidenhain("LBL 1\nL IX+1 F100\nCALL LBL 1 REP 2/2\nL Y+1\n")),
            "1,0,0 2,0,0 3,0,0 3,1,0");
  // The inner repeat starts anew each time.
  EXPECT_EQ(read_clean_heidenhain("LBL 1\nL IX+1 F100\nLBL 2\nL IY+1\nCALL LBL 2 REP2\nCALL LBL 1 REP3\n")
                .motions.size(),
            16U);
}

TEST(HeidenhainFlow, JumpsCompareParameters) {
  EXPECT_EQ(path_of(read_clean_heidenhain(
                "FN 0: Q1 = +0\nLBL 1\nQ1 = Q1 + 1\nL X+Q1 F100\nFN 12: IF +Q1 LT +3 GOTO LBL "
                "1\nFN9: IF +Q1 EQU +3 GOTO LBL \"END\"\nL Y+99\nLBL \"END\"\nFN 10: IF Q1 NE "
                "3 GOTO LBL 1\nFN 11: IF +1 GT +Q1 GOTO LBL 1\n")),
            "1,0,0 2,0,0 3,0,0");
}

TEST(HeidenhainFlow, BlanksBetweenAKeywordAndItsNumberMayBeMissing) {
  // The same program with each of these blanks left out, and with all of them.
  const std::string text =
      "0 BEGIN PGM A MM\n1 BLK FORM 0.1 Z X+0 Y+0 Z-9\n2 TOOL DEF 1 L+0 R+5\n3 TOOL CALL 1 Z S3000 F500\n"
      "4 CYCL DEF 9 .0 V.ZEIT\n5 CYCL DEF 9 .1 V.ZEIT 0.5\n6 FN 0: Q1 = +0\n7 LBL 1\n8 L IX+1 F100\n"
      "9 FN 1: Q1 = +Q1 + +1\n10 FN 12: IF +Q1 LT +3 GOTO LBL 1\n11 CALL LBL 2\n12 CALL LBL 3 REP 1\n13 L "
      "M30\n"
      "14 LBL 2\n15 L IY+1\n16 LBL 0\n17 LBL 3\n18 END PGM A MM\n";
  const std::string expected = path_of(read_clean_heidenhain(text));
  ASSERT_NE(expected.find("3,1,0"), std::string::npos) << expected;
  const std::vector<std::pair<std::string, std::string>> blanks{
      {"TOOL DEF 1", "TOOL DEF1"},
      {"TOOL CALL 1", "TOOL CALL1"},
      {"CYCL DEF 9 .0", "CYCL DEF9 .0"},
      {"CYCL DEF 9 .1", "CYCL DEF9.1"},
      {"V.ZEIT 0.5", "V.ZEIT0.5"},
      {"FN 0:", "FN0:"},
      {"FN 12: IF", "FN12:IF"},
      {"IF +Q1 LT +3 GOTO LBL 1", "IF+Q1LT+3GOTO LBL1"},
      {"GOTO LBL 1", "GOTO LBL1"},
      {"CALL LBL 2", "CALL LBL2"},
      {"CALL LBL 3 REP 1", "CALL LBL3 REP1"},
      {"7 LBL 1", "7 LBL1"},
      {"BLK FORM 0.1", "BLK FORM0.1"}};
  std::string all = text;
  for (const auto& [with, without] : blanks) {
    const auto replaced = [with = with, without = without](std::string in) {
      const std::size_t at = in.find(with);
      return at == std::string::npos ? in : in.replace(at, with.size(), without);
    };
    EXPECT_EQ(path_of(read_clean_heidenhain(replaced(text))), expected) << without;
    all = replaced(all);
  }
  EXPECT_EQ(path_of(read_clean_heidenhain(all)), expected) << all;
}

struct FunctionCase {
  const char* text;
  double q1;
};
void PrintTo(const FunctionCase& c, std::ostream* out) {
  *out << c.text;
}
class HeidenhainFunction : public testing::TestWithParam<FunctionCase> {};

TEST_P(HeidenhainFunction, ComputesQ1) {
  const ReadProgram program =
      read_clean_heidenhain("Q2 = 4\nQ3 = -30\n" + std::string(GetParam().text) + "\nL X+Q1 F100\n");
  EXPECT_NEAR(end_of(program).x(), GetParam().q1, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(
    Functions, HeidenhainFunction,
    testing::Values(FunctionCase{"FN 0: Q1 = +60", 60}, FunctionCase{"FN1: Q1 = -Q2 + -5", -9},
                    FunctionCase{"FN 2: Q1 = +10 - +Q2", 6}, FunctionCase{"FN 3: Q1 = +3 * +3", 9},
                    FunctionCase{"FN 4: Q1 = +8 DIV +Q2", 2}, FunctionCase{"FN 5: Q1 = SQRT 4", 2},
                    FunctionCase{"FN 6: Q1 = SIN -Q3", 0.5}, FunctionCase{"FN 7: Q1 = COS +60", 0.5},
                    FunctionCase{"FN 8: Q1 = +3 LEN +Q2", 5}, FunctionCase{"FN 13: Q1 = -1 ANG -1", 225},
                    FunctionCase{"Q1 = Q2 + 3 * 2", 10}, FunctionCase{"Q1 = ( Q2 + 3 ) * 2", 14},
                    FunctionCase{"Q1 = 2 ^ 3 - 1,5", 6.5}, FunctionCase{"Q1 = SQRT ( Q2 * 4 ) + 1", 5},
                    FunctionCase{"Q1 = SIN 30 + COS Q3 * 0", 0.5}, FunctionCase{"Q1 = - Q2", -4},
                    FunctionCase{"Q1 = SQ Q2", 16}, FunctionCase{"Q1 = INT 2.7 + FRAC 2.5", 2.5},
                    FunctionCase{"Q1 = INT - 2.7", -2}, FunctionCase{"Q1 = ABS Q3", 30},
                    FunctionCase{"Q1 = NEG Q3", 30}, FunctionCase{"Q1 = SGN Q3", -1},
                    FunctionCase{"Q1 = 7 % 4", 3}, FunctionCase{"Q1 = ATAN 1", 45},
                    FunctionCase{"Q1 = ASIN 0.5 + ACOS 0.5", 90}, FunctionCase{"Q1 = TAN 45", 1},
                    FunctionCase{"Q1 = LN EXP 2 + LOG 100", 4}, FunctionCase{"Q1 = PI", 3.14159265358979},
                    FunctionCase{"FN 18: SYSREAD Q1 = ID20 NR3", 2},
                    FunctionCase{"TOOL CALL 7 Z S9 F250\nFN 18: SYSREAD Q1 = ID20 NR1", 7},
                    FunctionCase{"TOOL CALL 7 Z S9 F250\nFN 18: SYSREAD Q1 = ID20 NR9", 250},
                    FunctionCase{"TOOL DEF 7 R4\nFN 18: SYSREAD Q1 = ID50 NR2 IDX7", 4},
                    FunctionCase{"TOOL DEF 7 R4\nTOOL CALL 7 Z S9 DR+0.5\nFN 18: SYSREAD Q1 = ID200 NR1",
                                 4.5},
                    FunctionCase{"CYCL DEF 7.1 Y-3\nFN 18: SYSREAD Q1 = ID220 NR2 IDX2", -3},
                    FunctionCase{"FN 18: SYSREAD Q1 = ID10 NR1", 0}, FunctionCase{"Q1 = Q113", 0},
                    FunctionCase{"TOOL DEF 3 L+0 R+5\nTOOL CALL 3 Z S500 DR+0.5\nQ1 = Q108", 5.5},
                    FunctionCase{"TOOL CALL 3 Y S500\nFN 18: SYSREAD Q1 = ID20 NR4", 500},
                    FunctionCase{"QS1 = \"NA\" || \"ME\"\nCALL LBL QS1\nFN 9: IF 1 EQU 1 GOTO LBL \"Z\"\nLBL "
                                 "\"NAME\"\nQ1 = 8\nLBL 0\nLBL \"Z\"",
                                 8}));

TEST(HeidenhainFlow, SystemDataAnswersTheToolsPosition) {
  EXPECT_EQ(
      path_of(read_clean_heidenhain(
          "CYCL DEF 7.1 X+10\nL X+5 Y+7 F100\nFN 18: SYSREAD Q1 = ID270 NR1 IDX1\nFN 18: SYSREAD Q2 = ID270 "
          "NR1 IDX2\nL Z+Q1 Y-Q2\n")),
      "15,7,0 15,-7,5");
}

class HeidenhainFiles : public testing::Test {
 protected:
  HeidenhainFiles() {
    folder = std::filesystem::path(testing::TempDir()) /
             ("heidenhain_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
    std::filesystem::create_directories(folder);
  }
  ~HeidenhainFiles() override { std::filesystem::remove_all(folder); }

  void write(const std::string& name, const std::string& text) const { std::ofstream(folder / name) << text; }
  ReadProgram read(const std::string& name) const {
    return read_program(std::make_shared<const SourceText>(SourceText::from_file(folder / name)), nullptr,
                        {.unit = LengthUnit::mm});
  }

  std::filesystem::path folder;
};

TEST_F(HeidenhainFiles, CalledProgramsLieBesideInAnyCase) {
  write("MAIN.H",
        "BEGIN PGM MAIN MM\nQ1 = 3\nQL1 = 5\nL X+1 F100\nCALL PGM TNC:\\NC\\sub.h\nL X+QL1\nCALL PGM "
        "SUB\nCYCL DEF 12.0 "
        "PGM CALL\nCYCL DEF 12.1 PGM sub.H\nL X+6 M99\nL Z+1\nEND PGM MAIN MM\n");
  write("Sub.h", "BEGIN PGM SUB INCH\nQL1 = 9\nL Y+Q1\nLBL 1\nL Z+0\nEND PGM SUB INCH\n");
  const ReadProgram program = read("MAIN.H");
  EXPECT_TRUE(program.diagnostics.empty()) << format(program.diagnostics.front(), "MAIN.H");
  EXPECT_EQ(path_of(program),
            "1,0,0 1,76.2,0 1,76.2,0 5,76.2,0 5,76.2,0 5,76.2,0 6,76.2,0 6,76.2,0 6,76.2,0 6,76.2,1");
  EXPECT_EQ(program.motions[1].line, 5U) << "the line of the call";
  EXPECT_EQ(program.call_count, 3U);
}

TEST_F(HeidenhainFiles, AProgramOfAnotherDialectIsNotCalled) {
  write("MAIN.H", "BEGIN PGM MAIN MM\nL X+1 F100\nCALL PGM SUB.MPF\nEND PGM MAIN MM\n");
  write("SUB.MPF", "%_N_SUB_MPF\nTRANS X10\nG1 X5 F100\n");
  const ReadProgram program = read("MAIN.H");
  ASSERT_EQ(program.diagnostics.size(), 1U);
  EXPECT_EQ(program.diagnostics[0].message.english(),
            "program \"SUB.MPF\" is in another dialect, Sinumerik 840D");
}

}  // namespace
}  // namespace feedscope

#include <gtest/gtest.h>

#include <filesystem>
#include <random>

#include "tests/core/program/heidenhain/read_heidenhain.h"
#include "tests/support/folders.h"
#include "tests/support/program_checks.h"

namespace feedscope {
namespace {

const std::filesystem::path samples = std::filesystem::path(FEEDSCOPE_SOURCE_DIR) / "resources" / "programs";

ReadProgram read_file(const std::filesystem::path& file) {
  return read_program(std::make_shared<const SourceText>(SourceText::from_file(file)));
}

TEST(HeidenhainSamples, AreReadClean) {
  const ReadProgram plate = read_file(samples / "heidenhain_plate.h");
  for (const Diagnostic& diagnostic : plate.diagnostics) {
    EXPECT_EQ(diagnostic.code, "machining-mode") << format(diagnostic, "heidenhain_plate.h");
  }
  EXPECT_EQ(plate.dialect, Dialect::heidenhain);
  EXPECT_EQ(plate.tools.size(), 2U);
  EXPECT_EQ(plate.path_controls.size(), 3U);
  const ReadProgram spiral = read_file(samples / "heidenhain_spiral.i");
  for (const Diagnostic& diagnostic : spiral.diagnostics) {
    ADD_FAILURE() << format(diagnostic, "heidenhain_spiral.i");
  }
  EXPECT_EQ(spiral.dialect, Dialect::heidenhain_iso);
}

/// Whatever the text, what comes out can be worked with.
void expect_sane(const std::string& text, Dialect dialect) {
  ASSERT_EQ(insane_part(read_heidenhain(text, {.dialect = dialect, .repeat_limit = 2000})), "") << text;
}

TEST(HeidenhainGarbage, RandomWordsAreReadWithoutHarm) {
  constexpr std::string_view conversational[] = {
      "L",
      "C",
      "CC",
      "CR",
      "CT",
      "CP",
      "LP",
      "RND",
      "CHF",
      "APPR LCT",
      "X+1",
      "Y-2",
      "IZ+3",
      "PA",
      "IPA-400",
      "PR+5",
      "R+2",
      "R0",
      "RL",
      "RR",
      "DR+",
      "DR-",
      "F100",
      "FMAX",
      "LEN3",
      "CCA90",
      "M99",
      "M91",
      "DEP LT",
      "DEP CT",
      "LBL 1",
      "LBL 0",
      "Q1",
      "= ",
      "CALL LBL 1",
      "REP 3",
      "CYCL DEF",
      "200",
      "Q200=1",
      "Q201=-9",
      "220",
      "7.1",
      "10.1",
      "ROT+30",
      "11.1 SCL2",
      "CYCL CALL",
      "TOOL CALL 1 Z S9",
      "TOOL DEF 1 R+2",
      "~\n",
      ";",
      "FN 9: IF 1 EQU Q1 GOTO LBL 1",
      "\n",
      "\n",
      "\n",
      "\n",
      "1e9",
      "-",
      "\"",
      "END PGM",
      "32.1 T0.1",
      "26.1 X2",
      "PLANE SPATIAL SPA+30",
      "SPB-70",
      "STAY",
      "PLANE VECTOR BX1 BY0 BZ2",
      "NX0 NY3 NZ-1",
      "PLANE RELATIV SPC+Q1",
      "PLANE RESET",
      "CYCL DEF 19.1 A+20",
      "PATTERN DEF",
      "PAT1 (X1 Y2 DX3 DY4 NUMX3 NUMY2 Z+Q1)",
      "CIRC1 (X1 Y2 D30 START+4 NUM3)",
      "CYCL CALL PAT",
      "CYCL CALL POS",
      "GLOBAL DEF 100 Q200=3\n",
      "CYCL DEF 240 C Q200=PREDEF Q201=-5 Q206=MAX Q203=Q1 Q204=9\n",
      "CYCL DEF 204 B Q200=2 Q249=4 Q250=20 Q251=3 Q252=5 Q253=7 Q254=2 Q203=0 "
      "Q204=9 Q214=3\n",
      "M89",
      "FUNCTION DWELL TIME",
      "FUNCTION DWELL REV9",
      "LIN_Z-3",
      "FZ0.1",
      "FN 9: IF Q1 IS UNDEFINED GOTO LBL 1",
      "Q1 = 10 ^ 200\n",
      "X+Q1",
      "Q201 = Q1\n",
      "11.1 SCL Q1"};
  constexpr std::string_view din[] = {"G0",          "G1",          "G2",           "G3",
                                      "G5",          "G6",          "G10",          "G11",
                                      "G12",         "G13",         "G16",          "G24",
                                      "G25",         "G26",         "G27",          "G28",
                                      "G29",         "G41",         "G40",          "G54",
                                      "G72",         "G73",         "G79",          "G83",
                                      "G90",         "G91",         "G98",          "L1",
                                      "L0",          ",3",          "X+1",          "Y-2",
                                      "Z3",          "I+5",         "J-5",          "R+4",
                                      "H+400",       "F60",         "P01 2",        "P02 -9",
                                      "T1",          "S99",         "M99",          "%A",
                                      "G71",         "*\n",         "*\n",          "*\n",
                                      "\n",          "N5",          "D00 Q1 P01 2", "D12 P01 Q1 P02 9 P03 1",
                                      "Q1 = Q1 + 1", "G200 Q200=1", "Q201=-3",      "G99 T1 L0 R2",
                                      "~\n"};
  std::mt19937 random(5);
  const auto check = [&](const auto& pieces, Dialect dialect) {
    for (int round = 0; round < 8000 && !testing::Test::HasFailure(); ++round) {
      std::string text;
      for (std::size_t i = random() % 60; i > 0; --i) {
        text += pieces[random() % std::size(pieces)];
        text += random() % 4 == 0 ? "" : " ";
      }
      expect_sane(text, dialect);
    }
  };
  check(conversational, Dialect::heidenhain);
  check(din, Dialect::heidenhain_iso);
}

TEST(HeidenhainGarbage, RandomBytesAreReadWithoutHarm) {
  std::mt19937 random(6);
  for (int round = 0; round < 2000 && !HasFailure(); ++round) {
    std::string text(random() % 300, ' ');
    for (char& c : text) {
      // Fewer control characters than a text may hold.
      const auto byte = static_cast<char>(random() % 256);
      c = byte >= 0 && byte < ' ' ? '\n' : byte;
    }
    expect_sane(text, round % 2 == 0 ? Dialect::heidenhain : Dialect::heidenhain_iso);
  }
}

}  // namespace
}  // namespace feedscope

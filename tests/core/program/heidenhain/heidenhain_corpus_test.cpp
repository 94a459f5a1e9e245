#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <random>

#include "tests/core/program/heidenhain/read_heidenhain.h"

namespace feedscope {
namespace {

const std::filesystem::path corpus =
    std::filesystem::path(FEEDSCOPE_SOURCE_DIR) / ".." / "shared" / "corpus" / "heidenhain";
const std::filesystem::path samples = std::filesystem::path(FEEDSCOPE_SOURCE_DIR) / "resources" / "programs";

Program read_file(const std::filesystem::path& file) {
  return read_program(std::make_shared<const SourceText>(SourceText::from_file(file)));
}

std::ptrdiff_t count(const Program& program, Motion motion) {
  return std::count_if(program.motions.begin(), program.motions.end(),
                       [motion](const MotionBlock& block) { return block.motion == motion; });
}

/// A published program, and how it differs from the scan of words in FACTS.json.
struct CorpusCase {
  const char* file;
  std::ptrdiff_t rapids;
  std::ptrdiff_t lines;
  std::ptrdiff_t arcs;
  std::ptrdiff_t dwells;
  std::size_t left_out;  ///< machine positions
  const char* reason;
};
void PrintTo(const CorpusCase& c, std::ostream* out) {
  *out << c.file;
}
class HeidenhainCorpus : public testing::TestWithParam<CorpusCase> {};

TEST_P(HeidenhainCorpus, MotionsAgreeWithTheScanOrTheDifferenceIsKnown) {
  if (!std::filesystem::exists(corpus)) {
    GTEST_SKIP() << "no collection of real programs at " << corpus;
  }
  const CorpusCase& expected = GetParam();
  const Program program = read_file(corpus / expected.file);
  EXPECT_EQ(program.dialect, Dialect::heidenhain);
  EXPECT_EQ(count(program, Motion::rapid), expected.rapids) << expected.reason;
  EXPECT_EQ(count(program, Motion::line), expected.lines) << expected.reason;
  EXPECT_EQ(count(program, Motion::arc), expected.arcs) << expected.reason;
  EXPECT_EQ(count(program, Motion::dwell), expected.dwells) << expected.reason;
  std::size_t left_out = 0;
  for (const Diagnostic& diagnostic : program.diagnostics) {
    left_out += diagnostic.code == "machine-position" ? 1 : 0;
    EXPECT_TRUE(diagnostic.code == "machine-position" || diagnostic.code == "arc-center")
        << format(diagnostic, expected.file);
  }
  EXPECT_EQ(left_out, expected.left_out);
}

INSTANTIATE_TEST_SUITE_P(
    Programs, HeidenhainCorpus,
    testing::Values(
        CorpusCase{"aamorim1913__CIRSTUD.h", 4, 6, 0, 0, 2,
                   "two rapids to M91; its circle starts where the operator has put the tool, in X0 here, "
                   "the centre"},
        CorpusCase{"aamorim1913__Top-light-cover_11.h", 277, 531, 708, 4, 3,
                   "the scan: 199 rapids and 491 lines; M91 left out, 4 holes of cycle 1 added"},
        CorpusCase{"aamorim1913__basemach_11.h", 506, 1395, 369, 11, 7,
                   "the scan: 402 rapids and 1342 lines; M91 left out, 16 holes of cycle 1 added"},
        CorpusCase{"aamorim1913__boss_12.h", 334, 4964, 455, 4, 3,
                   "the scan: 337 rapids, 4968 lines with those that only switch; M91 left out"}));

TEST(HeidenhainSamples, AreReadClean) {
  const Program plate = read_file(samples / "heidenhain_plate.h");
  for (const Diagnostic& diagnostic : plate.diagnostics) {
    ADD_FAILURE() << format(diagnostic, "heidenhain_plate.h");
  }
  EXPECT_EQ(plate.dialect, Dialect::heidenhain);
  EXPECT_EQ(plate.tools.size(), 2U);
  EXPECT_EQ(plate.path_controls.size(), 3U);
  const Program spiral = read_file(samples / "heidenhain_spiral.i");
  for (const Diagnostic& diagnostic : spiral.diagnostics) {
    ADD_FAILURE() << format(diagnostic, "heidenhain_spiral.i");
  }
  EXPECT_EQ(spiral.dialect, Dialect::heidenhain_iso);
}

/// Whatever the text, what comes out can be worked with.
void expect_sane(const std::string& text, Dialect dialect) {
  const Program program = read_heidenhain(text, {.dialect = dialect, .repeat_limit = 2000});
  for (const MotionBlock& block : program.motions) {
    ASSERT_TRUE(block.target.allFinite() && std::isfinite(block.feed) && std::isfinite(block.dwell)) << text;
    ASSERT_TRUE(block.feed >= 0 && block.dwell >= 0) << text;
    ASSERT_TRUE(block.line >= 1 && block.line <= program.source->line_count()) << text;
  }
  for (const ArcWords& arc : program.arcs) {
    ASSERT_TRUE(arc.center.allFinite() && std::isfinite(arc.turns)) << text;
  }
  for (const Diagnostic& diagnostic : program.diagnostics) {
    ASSERT_LE(diagnostic.line, program.source->line_count()) << text;
    if (diagnostic.line > 0) {
      ASSERT_LE(diagnostic.column, program.source->line(diagnostic.line).size() + 1)
          << format(diagnostic, "text") << "\n"
          << text;
    }
  }
}

TEST(HeidenhainGarbage, RandomWordsAreReadWithoutHarm) {
  constexpr std::string_view conversational[] = {"L",
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

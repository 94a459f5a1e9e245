#include "core/program/program_unit.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <random>

#include "core/program/program.h"

namespace feedscope {
namespace {

using Source = ProgramUnit::Source;

ReadProgram read(Dialect dialect, const std::string& text, std::optional<LengthUnit> unit = std::nullopt) {
  ReadOptions options;
  options.dialect = dialect;
  options.unit = unit;
  return read_program(std::make_shared<const SourceText>("test.nc", text), nullptr, options);
}

std::vector<Diagnostic> assumed(const ReadProgram& program) {
  std::vector<Diagnostic> found;
  std::ranges::copy_if(program.diagnostics, std::back_inserter(found),
                       [](const Diagnostic& diagnostic) { return diagnostic.code == "unit-assumed"; });
  return found;
}

/// How a dialect says each unit, and a program behind it.
struct Words {
  Dialect dialect;
  std::string inch, metric;  ///< a first line
  std::string none;          ///< the same without a unit
  std::string rapid, line;   ///< blocks, {} for X and Y
};

const std::vector<Words>& all_words() {
  static const std::vector<Words> words{
      {Dialect::iso, "G20\n", "G21\n", "\n", "G0 X{} Y{}\n", "G1 X{} Y{} F400\n"},
      {Dialect::fanuc, "O1 G20\n", "O1 G21\n", "O1\n", "G0 X{} Y{}\n", "G1 X{} Y{} F400\n"},
      {Dialect::linuxcnc, "G20\n", "G21\n", "\n", "G0 X{} Y{}\n", "G1 X{} Y{} F400\n"},
      {Dialect::sinumerik, "G700\n", "G710\n", "\n", "G0 X{} Y{}\n", "G1 X{} Y{} F400\n"},
      {Dialect::heidenhain, "BEGIN PGM A INCH\n", "BEGIN PGM A MM\n", "\n", "L X+{} Y+{} FMAX\n",
       "L X+{} Y+{} F400\n"},
      {Dialect::heidenhain_iso, "%A G70 *\n", "%A G71 *\n", "\n", "G0 X+{} Y+{} *\n",
       "G1 X+{} Y+{} F400 *\n"}};
  return words;
}

/// Blocks at random, of the same numbers for the same seed.
std::string body(const Words& words, unsigned seed) {
  std::mt19937 random(seed);
  std::string text;
  for (int i = 0; i < 8; ++i) {
    const auto number = [&] { return fmt::format("{}", 1 + static_cast<int>(random() % 300)); };
    const std::string x = number(), y = number();
    text += fmt::format(fmt::runtime(random() % 3 == 0 ? words.rapid : words.line), x, y);
  }
  return text;
}

void expect_same_motions(const ReadProgram& a, const ReadProgram& b, const std::string& text) {
  ASSERT_EQ(a.motions.size(), b.motions.size()) << text;
  for (std::size_t i = 0; i < a.motions.size(); ++i) {
    EXPECT_EQ(a.motions[i].target, b.motions[i].target) << text;
    EXPECT_EQ(a.motions[i].feed, b.motions[i].feed) << text;
  }
}

TEST(ProgramUnit, TheOptionDoesWhatTheWordOfTheProgramDoes) {
  for (const Words& words : all_words()) {
    for (unsigned seed = 0; seed < 20; ++seed) {
      const std::string rest = body(words, seed);
      const std::string& id = words.metric;
      const ReadProgram inch = read(words.dialect, words.inch + rest);
      const ReadProgram metric = read(words.dialect, words.metric + rest);
      EXPECT_EQ(inch.unit, (ProgramUnit{LengthUnit::inch, Source::program})) << id;
      EXPECT_EQ(metric.unit, (ProgramUnit{LengthUnit::mm, Source::program})) << id;
      ASSERT_FALSE(inch.motions.empty()) << id;
      EXPECT_NEAR(inch.motions.back().target.x(), 25.4 * metric.motions.back().target.x(), 1e-9) << id;

      const ReadProgram asked_inch = read(words.dialect, words.none + rest, LengthUnit::inch);
      expect_same_motions(asked_inch, inch, id + rest);
      EXPECT_EQ(asked_inch.unit, (ProgramUnit{LengthUnit::inch, Source::asked})) << id;
      expect_same_motions(read(words.dialect, words.none + rest, LengthUnit::mm), metric, id + rest);
      expect_same_motions(read(words.dialect, words.none + rest), metric, id + rest);
      // What the program says goes before what is asked for.
      expect_same_motions(read(words.dialect, words.metric + rest, LengthUnit::inch), metric, id + rest);
      expect_same_motions(read(words.dialect, words.inch + rest, LengthUnit::mm), inch, id + rest);
    }
  }
}

TEST(ProgramUnit, OneWarningWhereNobodySaysIt) {
  for (const Words& words : all_words()) {
    const std::string rest = body(words, 1);
    const ReadProgram program = read(words.dialect, words.none + rest);
    EXPECT_EQ(program.unit, (ProgramUnit{LengthUnit::mm, Source::assumed}));
    ASSERT_EQ(assumed(program).size(), 1U) << words.metric;
    EXPECT_EQ(assumed(program)[0].severity, Severity::warning);
    EXPECT_EQ(assumed(program)[0].line, 2U) << words.metric;
    for (const std::string& first : {words.metric, words.inch}) {
      EXPECT_TRUE(assumed(read(words.dialect, first + rest)).empty()) << first;
    }
    for (const LengthUnit unit : {LengthUnit::mm, LengthUnit::inch}) {
      EXPECT_TRUE(assumed(read(words.dialect, words.none + rest, unit)).empty()) << words.metric;
    }
  }
}

TEST(ProgramUnit, AWordBehindTheFirstMotionIsTooLate) {
  EXPECT_EQ(assumed(read(Dialect::iso, "G1 X10 F100\nG21 X20\n")).size(), 1U);
  EXPECT_EQ(assumed(read(Dialect::iso, "G4 P1\nG21 G1 X10 F100\n")).size(), 0U);
  EXPECT_EQ(assumed(read(Dialect::iso, "(nothing moves)\nM3\n")).size(), 0U);
}

TEST(ProgramUnit, SizesOfInchesAreSaidToLookLikeThem) {
  const auto hint = [](Dialect dialect, const std::string& text) {
    const auto found = assumed(read(dialect, text));
    return found.empty() ? std::string() : found[0].hint.english();
  };
  const std::string small = "G0 X0 Y0 Z1\nG1 Z-.25 F10\nX4 F80\nY3\nX0\nY0\n";
  EXPECT_NE(hint(Dialect::fanuc, small).find("4 x 3 x 1.25 mm cut at 80 mm/min"), std::string::npos)
      << hint(Dialect::fanuc, small);
  EXPECT_NE(hint(Dialect::fanuc, small).find("--unit inch"), std::string::npos);
  // grbl and printers start in mm: a word where it looks wrong only.
  EXPECT_NE(hint(Dialect::grbl, small).find("look like inches"), std::string::npos);
  const std::string large = "G0 X0 Y0 Z5\nG1 Z-1 F300\nX120 F1500\nY80\nX0\n";
  EXPECT_EQ(hint(Dialect::fanuc, large).find("look like inches"), std::string::npos);
  EXPECT_EQ(hint(Dialect::grbl, large), "");
}

TEST(ProgramUnit, SinumerikFeedsStayInTheBasicSystemUnderG70AndG71) {
  const std::string rest = "G1 X10 F100\n";
  const auto feed = [&](const std::string& first, LengthUnit unit) {
    return read(Dialect::sinumerik, first + rest, unit).motions.back().feed * 60;
  };
  EXPECT_NEAR(feed("G70\n", LengthUnit::mm), 100, 1e-9);
  EXPECT_NEAR(feed("G71\n", LengthUnit::inch), 2540, 1e-9);
  EXPECT_NEAR(feed("G710\n", LengthUnit::inch), 100, 1e-9);
  EXPECT_NEAR(feed("G700\n", LengthUnit::mm), 2540, 1e-9);
}

}  // namespace
}  // namespace feedscope

#include "core/machine/work_offsets.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <random>
#include <string>
#include <vector>

#include "core/base/diagnostic.h"
#include "core/program/program.h"

namespace feedscope {
namespace {

ReadProgram read(const std::string& text, Dialect dialect, const WorkOffsets& offsets = {}) {
  ReadOptions options;
  options.dialect = dialect;
  options.offsets = offsets;
  return read_program(std::make_shared<const SourceText>("test.nc", text), nullptr, options);
}

TEST(WorkOffsets, AreKnownByTheNameThatProgramsCallThemBy) {
  EXPECT_EQ(WorkOffsets::key("G55"), "G55");
  EXPECT_EQ(WorkOffsets::key("g055 "), "G55");
  EXPECT_EQ(WorkOffsets::key("G59.1"), "G59.1");
  EXPECT_EQ(WorkOffsets::key("g54.1p03"), "G54.1 P3");
  EXPECT_EQ(WorkOffsets::key("G154 P12"), "G154 P12");
  EXPECT_EQ(WorkOffsets::key("G505"), "G505");
  for (const char* none : {"", "55", "G", "GX", "G55X", "G55 P", "G55=1", "G54.1.1", "G123456"}) {
    EXPECT_EQ(WorkOffsets::key(none), "") << none;
  }
}

TEST(WorkOffsets, ThoseGivenComeBeforeThoseAdded) {
  WorkOffsets asked;
  asked.set("G55", Vec3(1, 2, 3));
  WorkOffsets machine;
  machine.set("g55", Vec3(7, 7, 7));
  machine.set("G56", Vec3(4, 5, 6));
  asked.add_missing(machine);
  EXPECT_EQ(asked.all().at("G55"), Vec3(1, 2, 3));
  EXPECT_EQ(asked.all().at("G56"), Vec3(4, 5, 6));
}

/// A language, and how its programs call two offsets.
struct Language {
  Dialect dialect;
  std::array<std::string, 3> offsets;
};

class WorkOffsetsOf : public testing::TestWithParam<Language> {};

/// A motion in an offset ends at its coordinates plus the zero point; an axis that it does not name stays
/// where it is, whichever offset that came from.
TEST_P(WorkOffsetsOf, ShiftWhatIsProgrammedInThem) {
  for (std::uint32_t seed = 1; seed <= 50; ++seed) {
    std::mt19937 random(seed);
    const auto below = [&](int n) { return static_cast<int>(random() % static_cast<std::uint32_t>(n)); };
    WorkOffsets offsets;
    std::array<Vec3, 3> zeros;
    for (std::size_t i = 0; i < zeros.size(); ++i) {
      zeros[i] = Vec3(below(400) - 200.5, below(400) - 200.25, below(100));
      offsets.set(GetParam().offsets[i], zeros[i]);
    }
    std::string text = "G90\n";
    std::vector<Vec3> expected;
    Vec3 at = Vec3::Zero();
    for (int line = 0; line < 30; ++line) {
      const auto offset = static_cast<std::size_t>(below(3));
      const int axes = line == 0 ? 7 : 1 + below(7);
      text += GetParam().offsets[offset] + "\nG0";
      for (int axis = 0; axis < 3; ++axis) {
        if ((axes >> axis & 1) != 0) {
          const int value = below(200) - 100;
          text += fmt::format(" {}{}", "XYZ"[axis], value);
          at[axis] = value + zeros[offset][axis];
        }
      }
      text += "\n";
      expected.push_back(at);
    }
    const ReadProgram program = read(text, GetParam().dialect, offsets);
    ASSERT_EQ(program.motions.size(), expected.size()) << text;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      ASSERT_LT((program.motions[i].target - expected[i]).norm(), 1e-9) << "motion " << i << "\n" << text;
    }
    std::uint64_t motions = 0;
    for (const OffsetUse& use : program.work_offsets) {
      EXPECT_TRUE(use.given) << use.name;
      motions += use.blocks;
    }
    EXPECT_EQ(motions, expected.size());
    for (const Diagnostic& diagnostic : program.diagnostics) {
      EXPECT_NE(diagnostic.code, "work-offset") << text;
    }
  }
}

TEST_P(WorkOffsetsOf, NotGivenAreZeroAndAWarningNamesThem) {
  WorkOffsets one;
  one.set(GetParam().offsets[0], Vec3(1, 2, 3));
  const std::string text =
      "G90 " + GetParam().offsets[0] + "\nG0 X10 Y0 Z0\n" + GetParam().offsets[1] + "\nG0 X10 Y0 Z0\nX20\n";
  const ReadProgram program = read(text, GetParam().dialect, one);
  EXPECT_EQ(program.motions[0].target, Vec3(11, 2, 3));
  EXPECT_EQ(program.motions[1].target, Vec3(10, 0, 0));
  ASSERT_EQ(program.work_offsets.size(), 2U);
  EXPECT_TRUE(program.work_offsets[0].given);
  EXPECT_FALSE(program.work_offsets[1].given);
  EXPECT_EQ(program.work_offsets[1].blocks, 2U);
  EXPECT_EQ(program.work_offsets[1].line, 3U);
  std::size_t warnings = 0;
  for (const Diagnostic& diagnostic : program.diagnostics) {
    if (diagnostic.code == "work-offset") {
      ++warnings;
      EXPECT_EQ(diagnostic.severity, Severity::warning);
      EXPECT_NE(diagnostic.hint.english().find("--offset"), std::string::npos) << diagnostic.hint.english();
    }
  }
  EXPECT_EQ(warnings, 1U);
}

INSTANTIATE_TEST_SUITE_P(Dialects, WorkOffsetsOf,
                         testing::Values(Language{Dialect::fanuc, {"G54", "G59", "G54.1 P3"}},
                                         Language{Dialect::linuxcnc, {"G55", "G59.1", "G59.3"}},
                                         Language{Dialect::sinumerik, {"G54", "G57", "G505"}}));

TEST(WorkOffsets, OfTheProgramReplaceThoseGiven) {
  WorkOffsets given;
  given.set("G55", Vec3(100, 0, 0));
  const ReadProgram program =
      read("G90 G55 G0 X1 Y0 Z0\nG10 L2 P2 X-50 Y0 Z0\nG55 X1 Y0 Z0\n", Dialect::fanuc, given);
  EXPECT_EQ(program.motions[0].target, Vec3(101, 0, 0));
  EXPECT_EQ(program.motions.back().target, Vec3(-49, 0, 0));
}

}  // namespace
}  // namespace feedscope

#include "core/analysis/run/program_facts.h"

#include <gtest/gtest.h>

namespace feedscope {
namespace {

ProgramFacts facts_of_text(const std::string& text) {
  const ReadProgram program = read_program(std::make_shared<const SourceText>("part.nc", text));
  return facts_of(program, build_toolpath(program));
}

TEST(ProgramFacts, CountWhatTheProgramHolds) {
  const ProgramFacts facts =
      facts_of_text("(a comment)\nG0 X10\nG1 X20 F600\nG2 X30 Y0 I5 J0 F1200\nG4 P2\n\nG1 X30 Y10\n");
  EXPECT_EQ(facts.lines, 7U);
  EXPECT_EQ(facts.blocks, 5U);
  EXPECT_EQ(facts.segments, 5U);
  EXPECT_EQ(facts.arcs, 1U);
  EXPECT_EQ(facts.dwells, 1U);
  EXPECT_NEAR(facts.path_length, 10 + 10 + 5 * 3.14159265358979 + 10, 1e-9);
  EXPECT_DOUBLE_EQ(facts.rapid_length, 10);
  EXPECT_GT(facts.dwell_time, 0);
  EXPECT_DOUBLE_EQ(facts.min_feed, 10);
  EXPECT_DOUBLE_EQ(facts.largest_feed, 20);
  EXPECT_DOUBLE_EQ(facts.bounds.max.x(), 30);
}

TEST(ProgramFacts, OfAnEmptyProgramAreZero) {
  const ProgramFacts facts = facts_of_text("");
  EXPECT_EQ(facts.lines, 0U);
  EXPECT_EQ(facts.segments, 0U);
  EXPECT_EQ(facts.largest_feed, 0);
  EXPECT_TRUE(facts.bounds.empty());
}

}  // namespace
}  // namespace feedscope

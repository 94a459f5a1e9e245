#include "core/program/sinumerik/language/repeats.h"

#include <gtest/gtest.h>

#include "core/program/text/read_fault.h"
#include "tests/core/program/sinumerik/part_bench.h"

namespace feedscope::sinumerik {
namespace {

/// Labels in lines 2 and 4; the statement is thought to be in line 6.
struct SinumerikRepeats : testing::Test {
  bool run(std::string_view name, std::string_view rest) {
    bench.go_to(6);
    Scanner scanner(rest);
    return repeats.run(name, scanner);
  }
  /// The lines that run from the statement on, up to line 7.
  std::vector<std::uint32_t> lines_to_the_end() {
    std::vector<std::uint32_t> lines;
    for (std::uint32_t line = bench.next_line(); line != 0 && lines.size() < 100; line = bench.next_line()) {
      if (repeats.is_over(line)) {
        continue;
      }
      lines.push_back(line);
      if (line >= 7) {
        break;
      }
    }
    return lines;
  }

  PartBench bench{"X1\nAA: X2\nX3\nBB: X4\nX5\nREPEAT\nX7\nX8\n"};
  ProgramIndexes indexes;
  LastMotion last;
  Targets targets{bench.context};
  Splines splines{bench.context, targets, last};
  Jumps jumps{bench.context, bench.values, splines, indexes};
  Repeats repeats{bench.context, bench.values, splines, indexes, jumps};
};

using Lines = std::vector<std::uint32_t>;

TEST_F(SinumerikRepeats, RunThePartBetweenTwoLabelsAndGoOn) {
  EXPECT_TRUE(run("REPEAT", "AA BB"));
  EXPECT_EQ(lines_to_the_end(), Lines({2, 3, 4, 7}));
}

TEST_F(SinumerikRepeats, RunFromOneLabelToTheStatementAsOftenAsPSays) {
  EXPECT_TRUE(run("REPEAT", "BB P=2"));
  EXPECT_EQ(lines_to_the_end(), Lines({4, 5, 4, 5, 7}));
}

TEST_F(SinumerikRepeats, RunOneBlock) {
  EXPECT_TRUE(run("REPEATB", "AA P3"));
  EXPECT_EQ(lines_to_the_end(), Lines({2, 2, 2, 7}));
}

TEST_F(SinumerikRepeats, RunNothingForP0) {
  EXPECT_TRUE(run("REPEATB", "AA P0"));
  EXPECT_EQ(lines_to_the_end(), Lines({7}));
}

TEST_F(SinumerikRepeats, LeaveRepeatWithoutALabelToLoops) {
  EXPECT_FALSE(run("REPEAT", ""));
  EXPECT_FALSE(run("UNTIL", "1"));
}

TEST_F(SinumerikRepeats, RefuseALabelThatDoesNotExist) {
  EXPECT_THROW(run("REPEAT", "CC"), ReadFault);
}

TEST_F(SinumerikRepeats, EndWithTheSubprogramThatTheyAreIn) {
  bench.go_to(6);
  ASSERT_TRUE(bench.lines.call(1));
  run("REPEAT", "AA BB P=9");
  bench.lines.return_from_call();
  repeats.leave_call();
  EXPECT_FALSE(repeats.is_over(5));
}

}  // namespace
}  // namespace feedscope::sinumerik

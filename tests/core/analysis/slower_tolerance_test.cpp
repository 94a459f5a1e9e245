#include "core/analysis/notes/slower_tolerance.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace feedscope {
namespace {

std::vector<ComparedRun> runs_of(const std::string& text, const std::vector<std::string>& models,
                                 const std::vector<double>& tolerances) {
  const LoadedProgram program = load_program(std::make_shared<const SourceText>("corner.nc", text));
  return compare_runs(program, setups_to_compare({"spinner-mvc850"}, models, tolerances));
}

TEST(SlowerTolerance, OfARightAngleIsTheBlendThatIsSlowerThanTheStop) {
  const auto runs = runs_of("G1 X20 F3000\nY20\n", {"essid", "gassara", "msaddek"}, {0.01, 0});
  const auto all = tolerance_runs(runs);
  const auto slower = slower_with_wider_tolerance(all);
  ASSERT_EQ(slower.size(), 3u);
  for (const SlowerTolerance& one : slower) {
    EXPECT_EQ(one.narrow_value, 0);
    EXPECT_EQ(one.wide_value, 0.01);
    const Summary& wide = runs[one.wide].summary;
    const Summary& narrow = runs[one.narrow].summary;
    EXPECT_EQ(one.more, wide.cycle_time - narrow.cycle_time);
    EXPECT_GT(one.more, 0);
    double growth = 0;
    for (std::size_t i = 0; i < wide.time_by_cause.size(); ++i) {
      growth = std::max(growth, wide.time_by_cause[i] - narrow.time_by_cause[i]);
    }
    EXPECT_EQ(one.cause_more, growth);
    EXPECT_EQ(wide.time_by_cause[cause_index(one.cause)] - narrow.time_by_cause[cause_index(one.cause)],
              growth);
    EXPECT_THAT(to_string(one, all), ::testing::HasSubstr("0.01 mm takes longer than 0 mm"));
  }
}

TEST(SlowerTolerance, IsNoneWhereAWiderToleranceIsFaster) {
  EXPECT_TRUE(
      slower_with_wider_tolerance(
          tolerance_runs(runs_of("G1 X20 F3000\nY20\n", {"ward", "cam", "tapie"}, {0.01, 0.02, 0.05, 0.1})))
          .empty());
}

TEST(SlowerTolerance, ComparesRunsOfOneMachineAndModelAlone) {
  EXPECT_TRUE(slower_with_wider_tolerance(
                  tolerance_runs(runs_of("G1 X20 F3000\nY20\n", {"essid", "gassara"}, {0.01})))
                  .empty());
}

}  // namespace
}  // namespace feedscope

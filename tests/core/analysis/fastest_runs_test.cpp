#include "core/analysis/study/fastest_runs.h"

#include <gmock/gmock.h>

namespace feedscope {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(FastestRuns, AreAllThatTakeTheSameTimeWithTheLeastError) {
  const std::vector<RunTime> runs{{12, 0.001}, {10, 0.02}, {10 * (1 + 1e-12), 0.01}, {10, 0.01}, {10, 0.03}};
  EXPECT_THAT(fastest_runs(runs, std::nullopt), ElementsAre(2, 3));
  EXPECT_THAT(fastest_runs(runs, 0.01), ElementsAre(2, 3)) << "an error at the bound keeps it";
  EXPECT_THAT(fastest_runs(runs, 0.005), ElementsAre(0));
  EXPECT_THAT(fastest_runs(runs, 0.0005), IsEmpty());
}

TEST(FastestRuns, AreNoneOfWhichMoreIsRefused) {
  const std::vector<RunTime> runs{{1, 0, 3}, {0, 0, 0, false}, {5, 0, 2}, {6, 0, 2}};
  EXPECT_THAT(fastest_runs(runs, std::nullopt), ElementsAre(2));
  EXPECT_THAT(fastest_runs(std::vector<RunTime>{{0, 0, 0, false}}, std::nullopt), IsEmpty());
}

}  // namespace
}  // namespace feedscope

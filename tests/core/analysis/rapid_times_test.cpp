#include "core/analysis/time/rapid_times.h"

#include <gtest/gtest.h>

#include <array>

namespace feedscope {
namespace {

constexpr double tiny = 1e-8;

TEST(RapidTimes, LeaveWhatLiesBetweenThem) {
  RapidTimes rapids;
  rapids.add(1, 2);
  rapids.add(2, 3);  // goes on: one stretch
  rapids.add(5, 9);  // over a whole column
  const std::array times{0.0, 2.0, 4.0, 6.0, 8.0, 10.0};
  const std::vector<ColumnStretch> left = rapids.outside(times);
  const std::vector<ColumnStretch> expected{{0, 0, 1}, {1, 3, 4}, {2, 4, 5}, {4, 9, 10}};
  ASSERT_EQ(left.size(), expected.size());
  for (std::size_t i = 0; i < left.size(); ++i) {
    EXPECT_EQ(left[i].column, expected[i].column);
    EXPECT_NEAR(left[i].from, expected[i].from, tiny);
    EXPECT_NEAR(left[i].to, expected[i].to, tiny);
  }
}

TEST(RapidTimes, LeaveEverythingWhereThereAreNone) {
  const std::array times{0.0, 1.0, 2.0};
  EXPECT_EQ(RapidTimes().outside(times).size(), 2U);
  RapidTimes before;
  before.add(0, 1);
  EXPECT_EQ(before.outside(std::array{1.5, 2.0}).size(), 1U);
  EXPECT_TRUE(before.outside(std::array{0.25, 0.5}).empty());
}

}  // namespace
}  // namespace feedscope

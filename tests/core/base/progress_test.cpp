#include "core/base/progress.h"

#include <gtest/gtest.h>

#include <thread>
#include <vector>

namespace feedscope {
namespace {

TEST(Progress, OfPartsAddsUpToTheWhole) {
  Progress whole;
  Progress half(whole, 0.5);
  Progress quarter(whole, 0.25);
  half.report(0.5);
  quarter.report(1);
  EXPECT_DOUBLE_EQ(whole.fraction(), 0.5);
  half.report(1);
  EXPECT_DOUBLE_EQ(whole.fraction(), 0.75);
  half.report(0);  // begins its next pass
  EXPECT_DOUBLE_EQ(whole.fraction(), 0.25);
}

TEST(Progress, OfAPartOfAPartCountsInTheWhole) {
  Progress whole;
  Progress half(whole, 0.5);
  Progress quarter(half, 0.5);
  Progress eighth(quarter, 0.5);
  eighth.report(1);
  EXPECT_DOUBLE_EQ(half.fraction(), 0.25);
  EXPECT_DOUBLE_EQ(whole.fraction(), 0.125);
  half.report(1);  // with all its parts
  EXPECT_DOUBLE_EQ(whole.fraction(), 0.5);
}

TEST(Progress, OfPartsAddsUpFromSeveralThreads) {
  constexpr int parts = 4;
  constexpr int steps = 1024;  // shares are powers of two, so that sums are exact
  Progress whole;
  {
    std::vector<std::jthread> threads;
    for (int i = 0; i < parts; ++i) {
      threads.emplace_back([&whole] {
        Progress part(whole, 1.0 / parts);
        for (int step = 1; step <= steps; ++step) {
          part.report(static_cast<double>(step) / steps);
        }
      });
    }
  }
  EXPECT_EQ(whole.fraction(), 1);
}

TEST(Progress, CancellingTheWholeCancelsEveryPartButNotTheReverse) {
  Progress whole;
  Progress first(whole, 0.5);
  Progress second(whole, 0.5);
  first.cancel();
  EXPECT_THROW(first.report(0.1), Cancelled);
  EXPECT_NO_THROW(second.report(0.1));
  EXPECT_FALSE(whole.cancelled());
  whole.cancel();
  EXPECT_THROW(second.report(0.2), Cancelled);
}

}  // namespace
}  // namespace feedscope

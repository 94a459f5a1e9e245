#include "core/base/parallel.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/base/progress.h"

namespace feedscope {
namespace {

using testing::Each;
using testing::ThrowsMessage;

TEST(InParallel, CallsEveryNumberOnce) {
  std::vector<std::atomic<int>> calls(1000);
  in_parallel(calls.size(), [&](std::size_t i) { ++calls[i]; });
  EXPECT_THAT(std::vector<int>(calls.begin(), calls.end()), Each(1));
  in_parallel(0, [](std::size_t) { FAIL(); });
}

TEST(InParallel, CallsAllAndThrowsWhatTheFirstOneThrew) {
  std::atomic<int> calls = 0;
  const auto work = [&] {
    in_parallel(50, [&](std::size_t i) {
      ++calls;
      if (i >= 7) {
        throw std::runtime_error(std::to_string(i));
      }
    });
  };
  EXPECT_THAT(work, ThrowsMessage<std::runtime_error>("7"));
  EXPECT_EQ(calls, 50);
}

TEST(InParallel, BeginsNothingMoreOnceItIsCancelled) {
  constexpr std::size_t count = 100'000;
  std::atomic<std::size_t> begun{0};
  const auto work = [&](std::size_t) {
    ++begun;
    throw Cancelled();
  };
  EXPECT_THROW(in_parallel(count, work), Cancelled);
  EXPECT_LE(begun, 1000U) << "one on each thread";
}

TEST(InParallel, DoesAllTasks) {
  int a = 0;
  int b = 0;
  in_parallel({[&] { a = 1; }, [&] { b = 2; }});
  EXPECT_EQ(a + b, 3);
}

TEST(InOrder, MakesAnywhereAndTakesOneAfterTheOther) {
  std::vector<std::atomic<int>> made(500);
  std::vector<std::size_t> taken;
  in_order(made.size(), [&](std::size_t i) -> std::function<void()> {
    ++made[i];
    return [&taken, i] { taken.push_back(i); };
  });
  EXPECT_THAT(std::vector<int>(made.begin(), made.end()), Each(1));
  ASSERT_EQ(taken.size(), made.size());
  for (std::size_t i = 0; i < taken.size(); ++i) {
    EXPECT_EQ(taken[i], i);
  }
  in_order(0, [](std::size_t) -> std::function<void()> {
    ADD_FAILURE();
    return [] {};
  });
}

TEST(InOrder, EndsWithWhatIsThrown) {
  std::atomic<int> calls = 0;
  const auto work = [&] {
    in_order(100000, [&](std::size_t i) -> std::function<void()> {
      ++calls;
      if (i == 7) {
        throw std::runtime_error("seven");
      }
      return [] {};
    });
  };
  EXPECT_THAT(work, ThrowsMessage<std::runtime_error>("seven"));
  EXPECT_LT(calls, 100000);
}

}  // namespace
}  // namespace feedscope

#include "core/base/parallel.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <string>
#include <vector>

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

TEST(InParallel, DoesAllTasks) {
  int a = 0;
  int b = 0;
  in_parallel({[&] { a = 1; }, [&] { b = 2; }});
  EXPECT_EQ(a + b, 3);
}

}  // namespace
}  // namespace feedscope

#include "core/base/clock_text.h"

#include <gtest/gtest.h>

namespace feedscope {
namespace {

TEST(ClockText, CountsHoursMinutesAndSeconds) {
  EXPECT_EQ(clock_text(0), "0:00:00");
  EXPECT_EQ(clock_text(59.49), "0:00:59");
  EXPECT_EQ(clock_text(59.5), "0:01:00");
  EXPECT_EQ(clock_text(3725.4), "1:02:05");
  EXPECT_EQ(clock_text(100 * 3600), "100:00:00");
}

TEST(ClockText, GivesNoTimeNoSign) {
  EXPECT_EQ(seconds_text(1.2504), "1.250 s");
  EXPECT_EQ(seconds_text(-0.0006), "-0.001 s");
  EXPECT_EQ(seconds_text(-4e-4), "0.000 s");
  EXPECT_EQ(seconds_text(-1e-17), "0.000 s");
}

}  // namespace
}  // namespace feedscope

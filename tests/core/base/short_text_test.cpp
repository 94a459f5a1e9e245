#include "core/base/short_text.h"

#include <gtest/gtest.h>

namespace feedscope {
namespace {

TEST(ShortText, TimesChangeTheirFormAtAMinuteAndAnHour) {
  EXPECT_EQ(short_time(0), "0 s");
  EXPECT_EQ(short_time(0.0123), "12.3 ms");
  EXPECT_EQ(short_time(48.53), "48.5 s");
  EXPECT_EQ(short_time(2), "2.00 s") << "as many figures as the 2.71 s next to it";
  EXPECT_EQ(short_time(9.996), "10.0 s");
  EXPECT_EQ(short_time(0.02), "20.0 ms");
  EXPECT_EQ(short_time(59.94), "59.9 s");
  EXPECT_EQ(short_time(59.96), "1:00.0") << "never 60 s";
  EXPECT_EQ(short_time(108.46), "1:48.5");
  EXPECT_EQ(short_time(119.97), "2:00.0");
  EXPECT_EQ(short_time(3599.96), "1:00:00") << "never 60:00.0";
  EXPECT_EQ(short_time(3725.4), "1:02:05");
}

TEST(ShortText, LengthsBelowATenthOfAMillimetreAreInMicrometres) {
  EXPECT_EQ(short_length(0), "0 um");
  EXPECT_EQ(short_length(1e-9), "0 um");
  EXPECT_EQ(short_length(0.0113), "11.3 um");
  EXPECT_EQ(short_length(0.02), "20 um");
  EXPECT_EQ(short_length(0.00005664), "0.0566 um");
  EXPECT_EQ(short_length(0.1), "0.1 mm");
  EXPECT_EQ(short_length(12.345), "12.3 mm");
  EXPECT_EQ(short_length(1234.5), "1234 mm");
}

TEST(ShortText, SharesBelowAPercentAreNotNone) {
  EXPECT_EQ(short_percent(0.0823), "8 %");
  EXPECT_EQ(short_percent(0.0118), "1.2 %") << "more than one percent";
  EXPECT_EQ(short_percent(0.0031), "0.3 %");
  EXPECT_EQ(short_percent(0), "0 %");
}

}  // namespace
}  // namespace feedscope

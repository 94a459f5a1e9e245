#include "core/drives/span_looks.h"

#include <gtest/gtest.h>

namespace feedscope {
namespace {

/// Along X from 5 s on.
SetSpan span_of(double duration, double velocity, double acceleration) {
  SetSpan span;
  span.time = 5;
  span.duration = duration;
  span.axes[0].derivative[1] = velocity;
  span.axes[0].derivative[2] = acceleration;
  return span;
}

void expect_borders(const SpanLooks& looks, const SetSpan& span) {
  EXPECT_DOUBLE_EQ(looks.at(0), span.time);
  EXPECT_DOUBLE_EQ(looks.at(looks.count()), span.end());
  for (int i = 0; i < looks.count(); ++i) {
    ASSERT_LT(looks.at(i), looks.at(i + 1)) << i;
    ASSERT_EQ(looks.first_after(looks.at(i)), i + 1) << i;
    ASSERT_EQ(looks.first_after(looks.middle(i)), i + 1) << i;
  }
  EXPECT_EQ(looks.first_after(span.time - 1), 0);
  EXPECT_EQ(looks.first_after(span.end()), looks.count() + 1);
}

TEST(SpanLooks, AreTwoMillisecondsApartWhereTheVelocityChanges) {
  const SetSpan span = span_of(0.1015, 3, 7);
  const SpanLooks looks(span, true);
  EXPECT_EQ(looks.count(), 51);
  expect_borders(looks, span);
}

TEST(SpanLooks, OfAShortSpanAreTwo) {
  const SetSpan span = span_of(1e-5, 3, 7);
  EXPECT_EQ(SpanLooks(span, true).count(), 2);
  expect_borders(SpanLooks(span, true), span);
}

TEST(SpanLooks, GetFartherApartOnceTheDrivesHaveSettled) {
  const SetSpan span = span_of(10.1, 3, 0);
  const SpanLooks looks(span, true);
  EXPECT_EQ(looks.count(), 50 + 200);
  EXPECT_NEAR(looks.duration(0), 0.002, 1e-12);
  EXPECT_NEAR(looks.duration(50), 0.05, 1e-12);
  expect_borders(looks, span);
}

TEST(SpanLooks, StayCloseWhereAxesWithFrictionMayTurnRound) {
  const SetSpan turning = span_of(10, -3, 0.6);
  EXPECT_EQ(SpanLooks(turning, false).count(), 5000);
  EXPECT_EQ(SpanLooks(turning, true).count(), 50 + 198);
  EXPECT_EQ(SpanLooks(span_of(10, 3, 0), false).count(), 50 + 198);
}

TEST(SpanLooks, OfADwellOfHoursAreFew) {
  const SetSpan span = span_of(1e4, 0, 0);
  EXPECT_EQ(SpanLooks(span, true).count(), 50 + 1000);
  expect_borders(SpanLooks(span, true), span);
}

}  // namespace
}  // namespace feedscope

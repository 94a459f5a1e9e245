#include "core/analysis/agreement/held_stretches.h"

#include <gtest/gtest.h>

#include <vector>

namespace feedscope {
namespace {

/// 10 mm/s along 100 mm, standing `dwell` at 30 mm and `hold` at 70 mm [s].
TimeLaw law_of(double dwell, double hold) {
  constexpr double period = 0.01;
  constexpr double feed = 10;
  std::vector<double> time;
  MatchedRecord matched;
  double s = 0;
  double left_of_dwell = dwell;
  double left_of_hold = hold;
  for (int i = 0; s < 100; ++i) {
    double& left = s < 50 ? left_of_dwell : left_of_hold;
    if (s >= (s < 50 ? 30 : 70) && left > 0) {
      left -= period;
    } else {
      s += feed * period;
    }
    time.push_back(i * period);
    matched.s.push_back(s);
    matched.distance.push_back(0);
  }
  matched.first = 0;
  matched.end = time.size();
  return {time, matched};
}

TEST(HeldStretches, AreWhereATraceStandsAndTheRunDoesNot) {
  const std::vector<HeldStretch> held = held_stretches(law_of(2, 3), law_of(2, 0), 1e-4);
  ASSERT_EQ(held.size(), 1U);
  EXPECT_NEAR(held[0].held, 3, 0.05);
  EXPECT_NEAR(held[0].to - held[0].from, 3, 0.05);
  EXPECT_NEAR(held[0].from, 9, 0.05);
  EXPECT_NEAR(held[0].from_s, 65, 0.5) << "half a second before it";
  EXPECT_NEAR(held[0].to_s, 75, 0.5);
}

TEST(HeldStretches, AreNoDwellsThatTheRunHasTooAndNoShortStops) {
  EXPECT_TRUE(held_stretches(law_of(2, 3), law_of(2, 3), 1e-4).empty());
  EXPECT_TRUE(held_stretches(law_of(0, 0.3), law_of(0, 0), 1e-4).empty());
  EXPECT_TRUE(held_stretches(law_of(0, 0), law_of(2, 3), 1e-4).empty());
  EXPECT_TRUE(held_stretches(TimeLaw(), law_of(0, 0), 1e-4).empty());
}

TEST(HeldStretches, AtADwellAreWhatItIsLongerThanInTheRun) {
  const std::vector<HeldStretch> held = held_stretches(law_of(5, 0), law_of(2, 0), 1e-4);
  ASSERT_EQ(held.size(), 1U);
  EXPECT_NEAR(held[0].held, 3, 0.05);
}

}  // namespace
}  // namespace feedscope

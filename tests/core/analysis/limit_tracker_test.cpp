#include "core/analysis/load/limit_tracker.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>

namespace feedscope {
namespace {

LimitTracker::Look look_at(double time, double predicted, std::uint32_t line = 1) {
  return {time, line, predicted, 2 * predicted};
}

TEST(LimitTracker, CutsAStepWhereTheLoadPassesTheBound) {
  LimitTracker above(LoadLimit::max_force);
  above.add(look_at(0, 0, 3), look_at(1, 100, 4), 0, 75);
  const LimitFigures figures = above.finish();
  EXPECT_DOUBLE_EQ(figures.time, 0.25);
  EXPECT_DOUBLE_EQ(figures.programmed_time, 0.625);
  ASSERT_EQ(figures.places.size(), 1U);
  EXPECT_DOUBLE_EQ(figures.places[0].from, 0.75);
  EXPECT_DOUBLE_EQ(figures.places[0].to, 1);
  EXPECT_EQ(figures.places[0].first_line, 3U);
  EXPECT_EQ(figures.places[0].last_line, 4U);
  EXPECT_EQ(figures.places[0].worst, 100);
  LimitTracker below(LoadLimit::least_chip);
  below.add(look_at(0, 0), look_at(1, 100), 0, 75);
  const LimitFigures thin = below.finish();
  EXPECT_DOUBLE_EQ(thin.time, 0.75);
  EXPECT_EQ(thin.places[0].worst, 0);
}

TEST(LimitTracker, JoinsStepsWithoutABreakOfOneOperation) {
  LimitTracker tracker(LoadLimit::max_force);
  tracker.add(look_at(0, 10, 1), look_at(1, 20, 2), 0, 5);
  tracker.add(look_at(1, 20, 2), look_at(2, 12, 3), 0, 5);
  tracker.add(look_at(2, 12, 3), look_at(3, 12, 4), 1, 5);
  tracker.add(look_at(4, 12, 5), look_at(5, 12, 5), 1, 5);
  const LimitFigures figures = tracker.finish();
  EXPECT_EQ(figures.count, 3U);
  ASSERT_EQ(figures.places.size(), 3U);
  EXPECT_EQ(figures.places[0].to, 2);
  EXPECT_EQ(figures.places[0].last_line, 3U);
  EXPECT_EQ(figures.places[0].worst, 20);
  EXPECT_EQ(figures.places[1].operation, 1);
}

TEST(LimitTracker, KeepsTheLongestPlacesInOrderOfTime) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> length(0.01, 0.9);
  LimitTracker tracker(LoadLimit::max_force);
  std::vector<double> lengths;
  double time = 0;
  for (int i = 0; i < 1000; ++i) {
    lengths.push_back(length(random));
    tracker.add(look_at(i, 10), look_at(i + lengths.back(), 10), 0, 5);
    time += lengths.back();
  }
  const LimitFigures figures = tracker.finish();
  EXPECT_EQ(figures.count, 1000U);
  EXPECT_NEAR(figures.time, time, 1e-9);
  ASSERT_EQ(figures.places.size(), LimitFigures::most_places);
  std::sort(lengths.begin(), lengths.end(), std::greater<>());
  for (std::size_t i = 0; i < figures.places.size(); ++i) {
    const LoadPlace& place = figures.places[i];
    EXPECT_GE(place.to - place.from, lengths[LimitFigures::most_places - 1] - 1e-9);
    EXPECT_TRUE(i == 0 || figures.places[i - 1].from < place.from);
  }
}

}  // namespace
}  // namespace feedscope

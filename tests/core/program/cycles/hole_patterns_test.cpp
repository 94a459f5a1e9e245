#include "core/program/cycles/hole_patterns.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/base/units.h"

namespace feedscope {
namespace {

TEST(HolePatterns, ACircleHasEqualAnglesAtEqualDistance) {
  std::minstd_rand random(3);
  std::uniform_real_distribution<double> any(-50, 50);
  for (int trial = 0; trial < 200; ++trial) {
    const int count = 1 + static_cast<int>(random() % 40);
    const CirclePattern pattern{
        {any(random), any(random)}, 2 * std::abs(any(random)) + 1, any(random), 0.1, count};
    const std::vector<Vec2> places = places_of(pattern);
    ASSERT_EQ(places.size(), static_cast<std::size_t>(count));
    for (std::size_t i = 0; i < places.size(); ++i) {
      const Vec2 arm = places[i] - pattern.center;
      EXPECT_NEAR(arm.norm(), pattern.diameter / 2, 1e-9);
      const double angle = pattern.start + static_cast<double>(i) * pattern.step;
      EXPECT_NEAR(std::remainder(std::atan2(arm.y(), arm.x()) - angle, 2 * units::pi), 0, 1e-9);
    }
  }
}

TEST(HolePatterns, AStepBetweenTwoAnglesReachesTheLastUnlessItIsTheFirstAgain) {
  EXPECT_DOUBLE_EQ(step_between(0, units::pi, 5), units::pi / 4);
  EXPECT_DOUBLE_EQ(step_between(0, 2 * units::pi, 5), 2 * units::pi / 5);
  EXPECT_DOUBLE_EQ(step_between(1, 1 - 2 * units::pi, 4), -units::pi / 2);
  EXPECT_EQ(step_between(0, 1, 1), 0);
}

TEST(HolePatterns, ARowGoesAlongItsAngle) {
  const std::vector<Vec2> places = places_of(RowPattern{{1, 2}, 10, units::pi / 2, 3});
  ASSERT_EQ(places.size(), 3U);
  for (std::size_t i = 0; i < places.size(); ++i) {
    EXPECT_NEAR((places[i] - Vec2(1, 2 + 10 * static_cast<double>(i))).norm(), 0, 1e-12);
  }
}

/// Every place once, neighbours one spacing apart; a frame leaves out what is inside.
TEST(HolePatterns, AGridHasEveryPlaceOnceAndGoesThereAndBack) {
  for (int columns = 1; columns <= 6; ++columns) {
    for (int rows = 1; rows <= 6; ++rows) {
      for (const bool frame_only : {false, true}) {
        GridPattern grid{
            .start = {3, 4}, .column_spacing = 1, .row_spacing = 1, .columns = columns, .rows = rows};
        grid.frame_only = frame_only;
        const std::vector<Vec2> places = places_of(grid);
        const int inside = frame_only && columns > 2 && rows > 2 ? (columns - 2) * (rows - 2) : 0;
        ASSERT_EQ(static_cast<int>(places.size()), columns * rows - inside) << columns << " x " << rows;
        for (std::size_t i = 0; i < places.size(); ++i) {
          const auto same = [&](const Vec2& place) { return (place - places[i]).norm() < 1e-9; };
          EXPECT_EQ(std::ranges::count_if(places, same), 1);
          if (i > 0) {
            EXPECT_NEAR((places[i] - places[i - 1]).norm(), 1, 1e-9);
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace feedscope

#include "ui/scene/camera/fit_outline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace feedscope::ui {
namespace {

const ScreenRectangle whole{{0, 0}, {400, 300}};

TEST(ConvexHull, HasTheCornersAlone) {
  const std::vector<Vec2> square{{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  std::vector<Vec2> points = square;
  points.insert(points.end(), {{1, 1}, {1, 0}, {2, 1}, {0.5, 0.3}, {2, 2}});
  EXPECT_EQ(convex_hull(points), square);
  EXPECT_EQ(convex_hull({{1, 1}, {1, 1}}).size(), 1U);
  EXPECT_EQ(convex_hull({{0, 0}, {1, 1}, {2, 2}, {0.5, 0.5}}).size(), 2U);
  EXPECT_TRUE(convex_hull({}).empty());
}

TEST(ConvexHull, IsAroundAllPointsAndTurnsOneWay) {
  std::mt19937 random(3);
  std::normal_distribution<double> place(0, 100);
  for (int round = 0; round < 200; ++round) {
    std::vector<Vec2> points;
    for (int i = 0; i < 3 + round; ++i) {
      points.emplace_back(place(random), round % 3 == 0 ? 1e-3 * place(random) : place(random));
    }
    const std::vector<Vec2> hull = convex_hull(points);
    for (std::size_t k = 0; k < hull.size(); ++k) {
      EXPECT_TRUE(std::ranges::count(points, hull[k]) > 0) << "round " << round;
      const Vec2 side = hull[(k + 1) % hull.size()] - hull[k];
      for (const Vec2& point : points) {
        const Vec2 from = point - hull[k];
        EXPECT_GE(side.x() * from.y() - side.y() * from.x(), -1e-9) << "round " << round;
      }
    }
  }
}

TEST(FitOutline, FillsAFreeRoomInOneDirectionAndIsInItsMiddle) {
  const FittedOutline fitted = fit_outline({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, whole, {}, HUGE_VAL);
  EXPECT_NEAR(fitted.factor, 150, 0.2);
  EXPECT_NEAR((fitted.place - whole.centre()).norm(), 0, 0.2);
}

/// A square beside a strip across the whole room has what the strip leaves.
TEST(FitOutline, TakesWhatAStripLeaves) {
  const FittedOutline fitted =
      fit_outline({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, whole, {{{0, 0}, {400, 60}}}, HUGE_VAL);
  EXPECT_NEAR(fitted.factor, 240, 0.5);
  EXPECT_GE(fitted.place.y(), 60 - 1e-9);
}

/// A triangle leaves its missing corner to what is there: a square would have to be smaller.
TEST(FitOutline, ATriangleKeepsItsSizeBesideWhatIsInItsMissingCorner) {
  const std::vector<ScreenRectangle> corner{{{300, 0}, {400, 120}}};
  const std::vector<Vec2> triangle{{0, 0}, {1, 1}, {0, 1}};
  EXPECT_NEAR(fit_outline(triangle, whole, corner, HUGE_VAL).factor, 300, 0.5);
}

TEST(FitOutline, WithoutExtentIsAsLargeAsAllowed) {
  EXPECT_EQ(fit_outline({{3, 4}}, whole, {}, 7).factor, 7);
  EXPECT_EQ(fit_outline({}, whole, {}, 7).factor, 1);
  EXPECT_EQ(fit_outline({{0, 0}, {1, 0}}, whole, {}, 7).factor, 7);
}

TEST(FitOutline, RandomOnesAreInTheRoomAndMeetNothingThatIsCovered) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(0, 1);
  for (int i = 0; i < 200; ++i) {
    std::vector<Vec2> points;
    for (int k = 0; k < 30; ++k) {
      points.emplace_back(20 * any(random) - 10, 3 * any(random));
    }
    std::vector<ScreenRectangle> covered;
    for (int k = 0; k < 3; ++k) {
      const Vec2 low(320 * any(random), k == 0 ? 0 : 240);
      covered.push_back({low, low + Vec2(80 * any(random), 60 * any(random))});
    }
    const FittedOutline fitted = fit_outline(convex_hull(points), whole, covered, HUGE_VAL);
    for (std::size_t a = 0; a < points.size(); ++a) {
      const Vec2 point = fitted.place + fitted.factor * points[a];
      EXPECT_TRUE(whole.grown(1e-6).contains({point, point})) << i;
      for (std::size_t b = 0; b < a; ++b) {  // all of the shape is between such points
        for (const double share : {0.0, 0.3, 0.5, 0.8}) {
          const Vec2 between = fitted.place + fitted.factor * (points[a] + share * (points[b] - points[a]));
          for (const ScreenRectangle& rectangle : covered) {
            EXPECT_FALSE(rectangle.grown(-1e-6).contains({between, between})) << i;
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace feedscope::ui

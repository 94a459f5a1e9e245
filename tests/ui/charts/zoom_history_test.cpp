#include "ui/charts/zoom_history.h"

#include <gtest/gtest.h>

namespace feedscope::ui {
namespace {

ChartView showing(double upper) {
  return {{0, upper}};
}

TEST(ZoomHistory, GoesBackAndForwardThroughWhereTheUserRested) {
  ZoomHistory history;
  history.start(showing(10));
  EXPECT_FALSE(history.can_go_back());
  history.rest(showing(10));
  EXPECT_FALSE(history.can_go_back());
  history.rest(showing(5));
  history.rest(showing(2));
  EXPECT_EQ(history.back(), showing(5));
  EXPECT_EQ(history.back(), showing(10));
  EXPECT_FALSE(history.can_go_back());
  EXPECT_EQ(history.forward(), showing(5));
  EXPECT_EQ(history.forward(), showing(2));
  EXPECT_FALSE(history.can_go_forward());
}

TEST(ZoomHistory, ANewViewForgetsWhatLayAhead) {
  ZoomHistory history;
  history.start(showing(10));
  history.rest(showing(5));
  history.back();
  history.rest(showing(3));
  EXPECT_FALSE(history.can_go_forward());
  EXPECT_EQ(history.back(), showing(10));
}

TEST(ZoomHistory, KeepsTheLatestOfVeryMany) {
  ZoomHistory history;
  for (int i = 1; i <= 1000; ++i) {
    history.rest(showing(i));
  }
  EXPECT_EQ(history.back(), showing(999));
  int steps = 1;
  while (history.can_go_back()) {
    history.back();
    ++steps;
  }
  EXPECT_EQ(steps, 199);
}

}  // namespace
}  // namespace feedscope::ui

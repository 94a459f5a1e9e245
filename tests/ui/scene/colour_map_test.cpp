#include "ui/scene/colour_map.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/cielab.h"

namespace feedscope::ui {
namespace {

double lightness(const Rgb& colour) {
  return test::to_lab(test::to_linear(colour))[0];
}

TEST(ColourMap, LightnessRisesInAStraightLine) {
  for (int i = 0; i <= 100; ++i) {
    EXPECT_NEAR(lightness(map_colour(i / 100.0)), 20 + 60 * i / 100.0, 0.1) << i;
  }
}

TEST(ColourMap, NeighboursAreCloseAndNothingIsCutOffAtTheGamut) {
  for (int i = 0; i < 255; ++i) {
    const Rgb a = map_colour(i / 255.0);
    const Rgb b = map_colour((i + 1) / 255.0);
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_LT(std::abs(a[c] - b[c]), 0.025) << i;
      EXPECT_GT(a[c], 0);
      EXPECT_LT(a[c], 1);
    }
  }
}

TEST(ColourMap, ClampsValuesBeyondItsEnds) {
  EXPECT_EQ(map_colour(-1), map_colour(0));
  EXPECT_EQ(map_colour(7), map_colour(1));
}

TEST(ColourMap, LightEndStillShowsOnTheBackground) {
  EXPECT_GT(lightness(palette::background) - lightness(map_colour(1)), 15);
}

}  // namespace
}  // namespace feedscope::ui

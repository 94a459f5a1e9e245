#include "ui/scene/colour_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "tests/support/cielab.h"
#include "ui/scene/scene_style.h"

namespace feedscope::ui {
namespace {

double lightness(const Rgb& colour) {
  return test::to_lab(test::to_linear(colour))[0];
}

void expect_smooth(const std::function<Rgb(double)>& colour) {
  for (int i = 0; i < 255; ++i) {
    const Rgb a = colour(i / 255.0);
    const Rgb b = colour((i + 1) / 255.0);
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_LT(std::abs(a[c] - b[c]), 0.025) << i;
      EXPECT_GT(a[c], 0) << i;
      EXPECT_LT(a[c], 1) << i;
    }
  }
}

TEST(ColourMap, LightnessRisesInAStraightLine) {
  for (int i = 0; i <= 100; ++i) {
    EXPECT_NEAR(lightness(map_colour(i / 100.0)), 20 + 60 * i / 100.0, 0.1) << i;
    EXPECT_NEAR(lightness(map_colour(i / 100.0, Background::dark)), 38 + 52 * i / 100.0, 0.1) << i;
  }
}

TEST(ColourMap, NeighboursAreCloseAndNothingIsCutOffAtTheGamut) {
  for (const Background background : {Background::light, Background::dark}) {
    expect_smooth([&](double u) { return map_colour(u, background); });
    expect_smooth([&](double u) { return diverging_colour(2 * u - 1, background); });
  }
}

TEST(DivergingColour, IsGreyAtZeroAndAsFarFromItOnBothSides) {
  for (const Background background : {Background::light, Background::dark}) {
    const Rgb zero = diverging_colour(0, background);
    EXPECT_NEAR(zero[0], zero[1], 0.01);
    EXPECT_NEAR(zero[1], zero[2], 0.01);
    for (const double size : {0.25, 0.5, 0.75, 1.0}) {
      EXPECT_NEAR(lightness(diverging_colour(-size, background)),
                  lightness(diverging_colour(size, background)), 0.2)
          << size;
    }
    EXPECT_GT(std::abs(lightness(diverging_colour(1, background)) - lightness(zero)), 30);
    EXPECT_GT(std::abs(lightness(zero) - lightness(scene_colours(background).background)), 15);
  }
}

TEST(ColourMap, ClampsValuesBeyondItsEnds) {
  EXPECT_EQ(map_colour(-1), map_colour(0));
  EXPECT_EQ(map_colour(7), map_colour(1));
}

TEST(ColourMap, LightEndStillShowsOnTheBackground) {
  EXPECT_GT(lightness(scene_colours(Background::light).background) - lightness(map_colour(1)), 15);
  EXPECT_GT(
      lightness(map_colour(0, Background::dark)) - lightness(scene_colours(Background::dark).background), 15);
}

}  // namespace
}  // namespace feedscope::ui

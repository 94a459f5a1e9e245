#include "ui/window/panels/pictures_of_panels.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "core/base/error.h"
#include "tests/ui/run_fixture.h"

namespace feedscope::ui {
namespace {

std::size_t count_dark(const Picture& picture) {
  std::size_t dark = 0;
  for (std::size_t i = 0; i < picture.rgb.size(); i += 3) {
    dark += picture.rgb[i] < 0x40 && picture.rgb[i + 1] < 0x40 && picture.rgb[i + 2] < 0x40 ? 1 : 0;
  }
  return dark;
}

TEST(WindowPicture, HasTheSizeAskedForAndIsTheSameEveryTime) {
  const auto run = test::simulate_text(test::small_program);
  const Picture first = draw_window(run, {1280, 800}, {.view = StandardView::top});
  EXPECT_EQ(first.size.width, 1280);
  EXPECT_EQ(first.size.height, 800);
  EXPECT_EQ(first.rgb.size(), 1280U * 800U * 3U);
  EXPECT_EQ(draw_window(run, {1280, 800}, {.view = StandardView::top}).rgb, first.rgb);
  EXPECT_NE(draw_window(run, {1280, 800}, {}).rgb, first.rgb);
}

TEST(WindowPicture, WithLessThanAPixelToAUnitIsTheWholeWindowSmaller) {
  const auto run = test::simulate_text(test::small_program);
  const Picture whole = draw_window(run, {1280, 800}, {});
  WindowLook look;
  look.pixel_ratio = 0.5;
  const Picture half = draw_window(run, {1280, 800}, look);
  ASSERT_EQ(half.size.width, 640);
  ASSERT_EQ(half.size.height, 400);
  double difference = 0;
  for (std::size_t y = 0; y < 400; ++y) {
    for (std::size_t x = 0; x < 640; ++x) {
      const std::size_t at = 3 * (2 * y * 1280 + 2 * x);
      const std::size_t below = at + std::size_t{3} * 1280;
      const int sum = whole.rgb[at] + whole.rgb[at + 3] + whole.rgb[below] + whole.rgb[below + 3];
      difference += std::abs(half.rgb[3 * (y * 640 + x)] - sum / 4.0);
    }
  }
  EXPECT_LT(difference / (640 * 400), 4) << "of 255";
}

TEST(WindowPicture, ChartsShowTheCurves) {
  const auto run = test::simulate_text(test::small_program);
  const Picture charts = draw_charts(run, {1000, 700});
  EXPECT_EQ(charts.size.width, 1000);
  EXPECT_EQ(charts.size.height, 700);
  const auto still = test::simulate_text("");
  EXPECT_GT(count_dark(charts), count_dark(draw_charts(still, {1000, 700})) + 1000);
}

TEST(WindowPicture, TooSmallASizeIsAnErrorThatNamesTheLeast) {
  const auto run = test::simulate_text(test::small_program);
  for (const PictureSize size : {PictureSize{300, 200}, PictureSize{2000, 100}}) {
    try {
      draw_window(run, size, {});
      FAIL() << "no error";
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("at least"), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace feedscope::ui

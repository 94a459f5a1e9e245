#include "tests/render/picture_difference.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace feedscope::test {
namespace {

ui::Picture blank(int width = 400, int height = 300) {
  return {{width, height}, std::vector<unsigned char>(static_cast<std::size_t>(width * height * 3), 255)};
}

/// Mixes black into a pixel.
void shade(ui::Picture& picture, int x, int y, double share) {
  for (int c = 0; c < 3; ++c) {
    auto& part = picture.rgb[static_cast<std::size_t>(3 * (y * picture.size.width + x) + c)];
    part = static_cast<unsigned char>(part * (1 - share));
  }
}

/// A dark upright line from `left` to `left + 2.6`, antialiased by area.
ui::Picture with_line(double left) {
  ui::Picture picture = blank();
  for (int y = 0; y < picture.size.height; ++y) {
    for (int x = 0; x < picture.size.width; ++x) {
      const double covered = std::min(left + 2.6, x + 1.0) - std::max(left, static_cast<double>(x));
      if (covered > 0) {
        shade(picture, x, y, 0.8 * covered);
      }
    }
  }
  return picture;
}

TEST(PictureDifference, IsNothingBetweenEqualPictures) {
  const PictureDifference d = difference(with_line(100), with_line(100));
  EXPECT_EQ(d.largest, 0);
  EXPECT_EQ(d.mean, 0);
}

TEST(PictureDifference, IsAHundredFromBlackToWhite) {
  ui::Picture black = blank();
  std::fill(black.rgb.begin(), black.rgb.end(), static_cast<unsigned char>(0));
  const PictureDifference d = difference(blank(), black);
  EXPECT_NEAR(d.mean, 100, 0.1);
  EXPECT_NEAR(d.largest, 100, 0.1);
}

TEST(PictureDifference, ForgivesAQuarterOfAPixel) {
  for (double left = 100; left < 104; left += 0.25) {
    EXPECT_TRUE(looks_the_same(difference(with_line(left), with_line(left + 0.25)))) << left;
  }
}

TEST(PictureDifference, SeesALineThatIsMissing) {
  EXPECT_FALSE(looks_the_same(difference(with_line(100), blank())));
}

TEST(PictureDifference, SeesALineThatIsTwoPixelsOff) {
  EXPECT_FALSE(looks_the_same(difference(with_line(101), with_line(103))));
}

TEST(PictureDifference, SeesASingleDigitThatIsMissing) {
  ui::Picture digit = blank();
  for (int y = 50; y < 59; ++y) {  // a "1" of 13 pixel type
    shade(digit, 200, y, 0.8);
    shade(digit, 201, y, 0.5);
  }
  EXPECT_FALSE(looks_the_same(difference(digit, blank())));
}

TEST(PictureDifference, SeesAColourThatHasChangedEverywhere) {
  ui::Picture tinted = blank();
  for (std::size_t i = 0; i < tinted.rgb.size(); i += 3) {
    tinted.rgb[i] = 250;
  }
  EXPECT_FALSE(looks_the_same(difference(tinted, blank())));
}

TEST(PictureDifference, CountsTheIncompleteSquaresAtTheEdges) {
  ui::Picture corner = blank(101, 75);
  shade(corner, 100, 74, 1);
  EXPECT_GT(difference(corner, blank(101, 75)).largest, 20);
}

TEST(PictureDifference, RefusesPicturesOfDifferentSize) {
  EXPECT_THROW(difference(blank(400, 300), blank(300, 400)), std::invalid_argument);
}

}  // namespace
}  // namespace feedscope::test

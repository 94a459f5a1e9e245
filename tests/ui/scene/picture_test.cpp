#include "ui/scene/picture.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <set>

#include "core/base/error.h"
#include "tests/ui/run_fixture.h"

namespace feedscope::ui {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

const feedscope::Run& run() {
  static const feedscope::Run drawn = test::simulate_text(test::small_program);
  return drawn;
}

std::size_t colours_in(const Picture& picture) {
  std::set<std::array<unsigned char, 3>> colours;
  for (std::size_t i = 0; i < picture.rgb.size(); i += 3) {
    colours.insert({picture.rgb[i], picture.rgb[i + 1], picture.rgb[i + 2]});
  }
  return colours.size();
}

TEST(Picture, HasTheSizeAskedForAndShowsThePath) {
  const Picture picture = draw_run(run(), {400, 300}, StandardView::iso);
  EXPECT_EQ(picture.rgb.size(), 400U * 300U * 3U);
  EXPECT_GT(colours_in(picture), 200U) << "colour bar, antialiased lines and text";
}

TEST(Picture, IsTheSameBytesEachTime) {
  EXPECT_EQ(draw_run(run(), {320, 240}, StandardView::top).rgb,
            draw_run(run(), {320, 240}, StandardView::top).rgb);
}

TEST(Picture, DiffersByView) {
  EXPECT_NE(draw_run(run(), {320, 240}, StandardView::top).rgb,
            draw_run(run(), {320, 240}, StandardView::iso).rgb);
}

TEST(Picture, IsDrawnAtTheLeastSizeAndForAnEmptyProgram) {
  const auto empty = test::simulate_text("M30\n");
  EXPECT_EQ(draw_run(empty, {min_picture_side, min_picture_side}, StandardView::iso).size.width,
            min_picture_side);
}

TEST(Picture, RefusesASizeOutOfBoundsByName) {
  for (const PictureSize size : {PictureSize{10, 300}, PictureSize{400, 100'000}, PictureSize{-5, 300}}) {
    try {
      draw_run(run(), size, StandardView::iso);
      FAIL() << size.width << "x" << size.height;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr("between 64 and 8192"));
    }
  }
}

TEST(Picture, ComesBackFromPng) {
  const Picture picture = draw_run(run(), {201, 153}, StandardView::front);
  const fs::path file = fs::path(testing::TempDir()) / "feedscope_picture_test.png";
  std::ofstream(file, std::ios::binary) << to_png(picture);
  const Picture back = read_png(file.string());
  fs::remove(file);
  EXPECT_EQ(back.size.width, 201);
  EXPECT_EQ(back.size.height, 153);
  EXPECT_EQ(back.rgb, picture.rgb);
}

TEST(Picture, FileThatIsNoPngIsNamed) {
  const fs::path file = fs::path(testing::TempDir()) / "feedscope_no_picture.png";
  std::ofstream(file, std::ios::binary) << "hello";
  try {
    read_png(file.string());
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("feedscope_no_picture.png"));
  }
  fs::remove(file);
  EXPECT_THROW(read_png("/nowhere/at_all.png"), InputError);
}

TEST(Picture, TextGrowsSlowerThanThePicture) {
  EXPECT_DOUBLE_EQ(scale_for({800, 600}), 1);
  EXPECT_GT(scale_for({1920, 1080}), 1.2);
  EXPECT_LT(scale_for({1920, 1080}), 1.8);
  EXPECT_GT(scale_for({3840, 2160}), 2.4);
  EXPECT_GE(scale_for({64, 64}), 0.7);
}

}  // namespace
}  // namespace feedscope::ui

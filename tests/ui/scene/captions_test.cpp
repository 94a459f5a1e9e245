#include "ui/scene/draw/captions.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace feedscope::ui {
namespace {

/// Everything that can be written over a picture at once.
struct FullCaptions {
  FullCaptions() {
    captions.colours = &scene_colours(Background::light);
    captions.texts = &texts;
    captions.entries = {true, true, true, true,
                        true, true, true, {{"essid, 0.01 mm", {}}, {"ward, 0.1 mm", {}}}};
    captions.key.scale = {.unit = "mm/min", .low = 0, .high = 12000, .beyond = true};
    captions.cube = true;
  }

  SceneTexts texts;
  Captions captions;
};

void expect_apart_and_inside(const ScreenLayout& layout, const std::string& where) {
  const std::vector<ScreenRectangle> all = layout.covered();
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_TRUE(layout.window().contains(all[i])) << where << ", overlay " << i;
    for (std::size_t k = 0; k < i; ++k) {
      EXPECT_FALSE(all[i].meets(all[k])) << where << ", overlays " << k << " and " << i;
    }
  }
}

TEST(Captions, OverlaysAreInsideOfTheWindowAndCoverNoOther) {
  FullCaptions full;
  for (const bool causes : {false, true}) {
    if (causes) {
      full.captions.key = {Colouring::cause, {}, {}, {}};
      for (int i = 0; i < 12; ++i) {
        full.captions.key.causes.push_back({static_cast<CauseKind>(i), 1.0 / 12});
      }
    }
    for (int width = 160; width <= 3840; width += 92) {
      for (int height = 120; height <= 2160; height += 170) {
        for (const double scale : {0.7, 1.0, 2.0}) {
          if (width >= 220 * scale && height >= 170 * scale) {
            expect_apart_and_inside(
                screen_layout(width, height, scale, full.captions),
                std::to_string(width) + "x" + std::to_string(height) + " at " + std::to_string(scale));
          }
        }
      }
    }
  }
}

TEST(Captions, AFourTimesLargerPictureHasTheSameComposition) {
  FullCaptions full;
  const std::vector<ScreenRectangle> small = screen_layout(1920, 1080, 1.35, full.captions).covered();
  const std::vector<ScreenRectangle> large = screen_layout(3840, 2160, 2.7, full.captions).covered();
  ASSERT_EQ(small.size(), large.size());
  constexpr double rounded = 16;  // [pixels] sizes of type are whole, and long texts add up
  for (std::size_t i = 0; i < small.size(); ++i) {
    EXPECT_LT((small[i].low - large[i].low / 2).norm(), rounded) << i;
    EXPECT_LT((small[i].high - large[i].high / 2).norm(), rounded) << i;
  }
}

TEST(Captions, NothingIsExplainedThatThePictureDoesNotContain) {
  FullCaptions full;
  full.captions.entries = {};
  full.captions.key = {};
  const ScreenLayout layout = screen_layout(800, 600, 1, full.captions);
  EXPECT_TRUE(layout.legend.empty());
  EXPECT_TRUE(layout.colours.empty());
  EXPECT_FALSE(layout.scale_bar.empty());
}

/// The colours say which line is the executed one.
TEST(Captions, TheExecutedPathIsNamedOnlyWhereNoColoursAreExplained) {
  FullCaptions full;
  full.captions.entries = {};
  full.captions.entries.executed = true;
  EXPECT_TRUE(screen_layout(800, 600, 1, full.captions).legend.empty());
  full.captions.key = {Colouring::run, {}, {}, {}};
  EXPECT_FALSE(screen_layout(800, 600, 1, full.captions).legend.empty());
}

TEST(Captions, AnotherViewMayExplainBoth) {
  FullCaptions full;
  full.captions.legend = false;
  const ScreenLayout layout = screen_layout(800, 600, 1, full.captions);
  EXPECT_EQ(layout.covered().size(), 1U) << "the cube";
}

TEST(Captions, CloseUpsHaveStripsAboveAndBelowThePath) {
  FullCaptions full;
  full.captions.strip = true;
  full.captions.cube = false;
  for (const int width : {300, 416, 832, 3840}) {
    for (const double scale : {0.68, 1.0}) {
      const ScreenLayout layout = screen_layout(width, 290, scale, full.captions);
      EXPECT_EQ(layout.colours.low, Vec2(0, 0));
      EXPECT_EQ(layout.colours.high.x(), width) << "no path beside the colours";
      EXPECT_LT(layout.colours.size().y(), 0.12 * 290);
      EXPECT_EQ(layout.legend.low.x(), 0);
      EXPECT_EQ(layout.legend.high, Vec2(width, 290));
      EXPECT_TRUE(layout.colours.contains(layout.scale_bar)) << width << " at " << scale;
    }
  }
}

TEST(Captions, ARunUnderTheShownOneSaysSo) {
  FullCaptions full;
  full.captions.entries.overlays.pop_back();
  const double before = screen_layout(1280, 800, 1, full.captions).legend.size().x();
  full.captions.entries.overlays.front().beneath = true;
  EXPECT_GT(screen_layout(1280, 800, 1, full.captions).legend.size().x(), before + 50);
}

TEST(Captions, TheLongestCausesAreNamedWhereNotAllHaveRoom) {
  FullCaptions full;
  full.captions.key = {Colouring::cause, {}, {}, {}};
  for (int i = 0; i < 10; ++i) {
    full.captions.key.causes.push_back({static_cast<CauseKind>(i), 0.1});
  }
  EXPECT_EQ(named_causes(1280, 800, 1, full.captions), 10U);
  std::size_t before = 0;
  for (int height = 60; height <= 800; height += 20) {
    const std::size_t named = named_causes(300, height, 1, full.captions);
    EXPECT_GE(named, std::max<std::size_t>(1, before));
    EXPECT_LE(screen_layout(300, height, 1, full.captions).colours.size().y(), std::max(18.0, 0.25 * height));
    before = named;
  }
}

}  // namespace
}  // namespace feedscope::ui

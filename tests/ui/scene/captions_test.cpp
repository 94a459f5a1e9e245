#include "ui/scene/draw/captions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "ui/scene/draw/colour_panel.h"

namespace feedscope::ui {
namespace {

constexpr double row = 22;  // [pixels]

/// Rows of a legend that holds nothing but a warning, in a window of this width.
double warning_rows(const std::string& warning, int width) {
  SceneTexts texts;
  texts.warning = warning;
  const SceneColours colours = scene_colours(Background::light);
  Captions captions;
  captions.colours = &colours;
  captions.texts = &texts;
  return (screen_layout(width, 600, 1, captions).legend_height - 8) / row;
}

TEST(Captions, AWarningThatIsWiderThanItsRoomIsBrokenIntoRowsThatFit) {
  const std::string words = "Not in the cycle time: 2 tool changes, 1 spindle start, 6 moves to positions";
  const TextStyle style{.size = panel_text_pixels};
  const double whole = Canvas::text_size(words, style).x();
  EXPECT_EQ(warning_rows(words, 2000), 1);
  double before = 1;
  for (int width = 1200; width >= 350; width -= 50) {
    const double rows = warning_rows(words, width);
    EXPECT_GE(rows, before) << width;
    EXPECT_GE(rows * width, whole) << "some row is wider than the window of " << width;
    before = rows;
  }
  EXPECT_GE(before, 3);
}

TEST(Captions, EveryWarningBeginsARowWhereTwoDoNotFit) {
  EXPECT_EQ(warning_rows("short\nshort", 1000), 1);
  EXPECT_EQ(warning_rows("Program read with 5 warnings\nProgram cut off at line 77", 520), 2);
}

TEST(Captions, TheLegendOfALowPictureLeavesThePathMostOfIt) {
  SceneTexts texts;
  texts.programmed = "programmed";
  texts.rapid = "rapid";
  texts.executed = "executed";
  texts.warning = "Program read with 5 warnings\nNot in the cycle time: 2 tool changes, 1 spindle start";
  const SceneColours colours = scene_colours(Background::light);
  Captions captions;
  captions.colours = &colours;
  captions.texts = &texts;
  captions.entries.programmed = captions.entries.rapid = captions.entries.executed = true;
  const double all = screen_layout(220, 1000, 1, captions).legend_height;
  for (int height = 80; height <= 400; height += 20) {
    const double legend = screen_layout(220, height, 1, captions).legend_height;
    EXPECT_LE(legend, std::max((height < 400 ? 0.25 : 0.45) * height + 8, row + 8)) << height;
    EXPECT_GE(legend, std::min(all, row)) << "the warning is never left out";
  }
}

TEST(ColourPanel, SaysHowManyCausesHaveNoRoom) {
  SceneTexts texts;
  const SceneColours colours = scene_colours(Background::light);
  Captions captions;
  captions.colours = &colours;
  captions.texts = &texts;
  captions.key.colouring = Colouring::cause;
  constexpr std::size_t causes = 6;
  for (std::size_t i = 0; i < causes; ++i) {
    captions.key.causes.push_back({static_cast<CauseKind>(i), 1.0 / causes});
  }
  EXPECT_EQ(fitting_cause_rows(captions, 128, 1000, 1).size(), causes);
  std::size_t before = 0;
  for (int height = 25; height <= 400; height += 5) {
    const std::vector<CauseRow> rows = fitting_cause_rows(captions, 128, height, 1);
    ASSERT_FALSE(rows.empty());
    const bool whole = rows.back().colour.has_value();
    const std::size_t shown = whole ? rows.size() : rows.size() - 1;
    EXPECT_EQ(whole, shown == causes);
    if (!whole) {
      EXPECT_EQ(rows.back().lines.front(), "+ " + std::to_string(causes - shown)) << height;
    }
    EXPECT_GE(shown, before);
    before = shown;
  }
  EXPECT_EQ(before, causes);
}

TEST(Captions, AWordWithoutRoomStandsInARowOfItsOwn) {
  EXPECT_EQ(warning_rows(std::string(200, 'x') + " y", 400), 2);
}

}  // namespace
}  // namespace feedscope::ui

#include "ui/theme/program_colours.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <algorithm>

#include "tests/support/cielab.h"
#include "ui/theme/theme.h"

namespace feedscope::ui {
namespace {

double luminance(const QColor& colour) {
  return 0.2126 * test::to_linear(colour.redF()) + 0.7152 * test::to_linear(colour.greenF()) +
         0.0722 * test::to_linear(colour.blueF());
}

/// WCAG 2: contrast ratio.
double contrast(const QColor& a, const QColor& b) {
  const auto [dark, light] = std::minmax({luminance(a), luminance(b)});
  return (light + 0.05) / (dark + 0.05);
}

class ProgramColoursTest : public testing::TestWithParam<ThemeKind> {
 protected:
  ProgramColoursTest() { apply_theme(GetParam()); }
  ~ProgramColoursTest() override { apply_theme(ThemeKind::light); }

  QPalette palette() const { return QApplication::palette(); }
};

TEST_P(ProgramColoursTest, TextStandsOutFromItsGround) {
  const QPalette of_application = palette();
  const ProgramColours& colours = program_colours(of_application);
  const QColor ground = palette().color(QPalette::Base);
  for (const QColor& colour :
       {colours.comment, colours.label, colours.block_delete, colours.g_code, colours.m_code, colours.axis_x,
        colours.axis_y, colours.axis_z, colours.other_axis, colours.argument, colours.feed, colours.tool,
        colours.keyword, colours.variable, colours.literal}) {
    EXPECT_GE(contrast(colour, ground), 4.5) << colour.name().toStdString();
  }
  EXPECT_GE(contrast(palette().color(QPalette::Text), colours.found), 4.5);
}

TEST_P(ProgramColoursTest, HeatGoesFromTheGroundToTheSlowestInOneDirection) {
  const QColor ground = theme_colours(palette()).gutter;
  EXPECT_EQ(heat_colour(0, ground, palette()), ground);
  EXPECT_EQ(heat_colour(1, ground, palette()), program_colours(palette()).slow);
  double before = 1;
  for (int i = 1; i <= 10; ++i) {
    const double stands_out = contrast(heat_colour(i / 10.0, ground, palette()), ground);
    EXPECT_GT(stands_out, before);
    before = stands_out;
  }
  EXPECT_GE(before, 3);
}

INSTANTIATE_TEST_SUITE_P(Themes, ProgramColoursTest, testing::Values(ThemeKind::light, ThemeKind::dark));

}  // namespace
}  // namespace feedscope::ui

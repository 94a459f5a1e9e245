#include "ui/runs/comparison_layout.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QFontMetricsF>

#include "tests/ui/comparison_fixture.h"

namespace feedscope::ui {
namespace {

void expect_inside(const QRectF& area, const QRectF& whole, const char* what) {
  EXPECT_TRUE(whole.contains(area)) << what << ": " << area.left() << " " << area.top() << " " << area.right()
                                    << " " << area.bottom();
}

void expect_one_below_the_other(const std::vector<QRectF>& areas) {
  for (std::size_t i = 1; i < areas.size(); ++i) {
    EXPECT_GE(areas[i].top(), areas[i - 1].bottom() - 1e-9) << i;
  }
}

class LaidOut : public testing::TestWithParam<std::pair<std::size_t, int>> {
 protected:
  LaidOut() : bars_(comparison_bars(feedscope::test::many_compared_runs(GetParam().first))) {}

  ComparisonLayout at_height(int height) const { return lay_out(bars_, {GetParam().second, height}, font_); }

  const QFont font_ = QApplication::font();
  ComparisonBars bars_;
};

TEST_P(LaidOut, NothingOverlapsOrLeavesThePicture) {
  const int width = GetParam().second;
  for (const int height :
       {min_comparison_height(bars_, width, font_), natural_comparison_height(bars_, width, font_), 3000}) {
    const ComparisonLayout layout = at_height(height);
    const QRectF whole(0, 0, width, height);
    std::vector<QRectF> lines = layout.rows;
    lines.insert(lines.end(), layout.machines.begin(), layout.machines.end());
    std::ranges::sort(lines, {}, [](const QRectF& line) { return line.top(); });
    expect_one_below_the_other(lines);
    expect_one_below_the_other(
        {layout.title, layout.legend.front(), layout.headings, layout.plot, layout.axis});
    EXPECT_LE(layout.legend.back().bottom(), layout.headings.top());
    for (const QRectF& line : lines) {
      expect_inside(line, whole, "row");
      EXPECT_GE(line.height(), layout.bar_height);
    }
    for (const QRectF& entry : layout.legend) {
      expect_inside(entry, whole, "legend");
    }
    expect_inside(layout.axis, whole, "axis");
    EXPECT_GT(layout.plot.width(), width / 5.0);
  }
}

TEST_P(LaidOut, ColumnsStandSideBySideAndHoldTheirTexts) {
  const ComparisonLayout layout = at_height(2000);
  std::vector<TextColumn> columns = layout.names;
  columns.insert(columns.end(), layout.figures.begin(), layout.figures.end());
  const QFontMetricsF metrics(font_);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    EXPECT_EQ(columns[i].texts.size(), layout.rows.size());
    for (const QString& text : columns[i].texts) {
      EXPECT_LE(metrics.horizontalAdvance(text), columns[i].right - columns[i].left + 1);
    }
    if (i > 0) {
      EXPECT_GT(columns[i].left, columns[i - 1].right);
    }
  }
  EXPECT_LT(layout.names.back().right, layout.plot.left());
  EXPECT_GT(layout.figures.front().left, layout.plot.right());
}

TEST_P(LaidOut, EveryBarEndsInThePlot) {
  const ComparisonLayout layout = at_height(2000);
  EXPECT_EQ(layout.x_of(0), layout.plot.left());
  EXPECT_LT(layout.x_of(bars_.longest), layout.plot.right());
  EXPECT_GE(layout.ticks.values.size(), 2u);
  EXPECT_LE(layout.x_of(layout.ticks.values.back()), layout.plot.right() + 1e-9);
}

TEST_P(LaidOut, WhatIsEnoughBeforeTheCausesAreKnownIsEnoughAfter) {
  const int width = GetParam().second;
  EXPECT_GE(enough_comparison_height(bars_, width), min_comparison_height(bars_, width, font_));
}

INSTANTIATE_TEST_SUITE_P(Sizes, LaidOut,
                         testing::Values(std::pair{1, 1280}, std::pair{7, 640}, std::pair{7, 1280},
                                         std::pair{40, 640}, std::pair{40, 1920}));

TEST(ComparisonLayout, NamesAModelOnceAndEveryTolerance) {
  const auto bars = comparison_bars(feedscope::test::many_compared_runs(8));
  const ComparisonLayout layout = lay_out(bars, {1280, 800}, QApplication::font());
  EXPECT_EQ(layout.names[0].texts.back(), "H") << "eight runs";
  EXPECT_EQ(layout.names[1].texts, (std::vector<QString>{"essid", "", "", "", "msaddek", "", "", ""}));
  EXPECT_EQ(layout.names[2].texts[1], "0.02");
}

TEST(ComparisonLayout, TimesAreClockTimesFromAMinuteOn) {
  const Cause feed{CauseKind::programmed_feed, -1};
  const auto figures = [&](double time) {
    return lay_out(
               comparison_bars(std::vector{feedscope::test::compared_run("m", "cam", {}, {{feed, time}})}),
               {1280, 400}, QApplication::font())
        .figures;
  };
  EXPECT_EQ(figures(59)[0].texts[0], "59.0\u00a0s");
  EXPECT_EQ(figures(110.22)[0].texts[0], "1:50.2");
  EXPECT_EQ(figures(3725.44)[0].texts[0], "1:02:05");
}

}  // namespace
}  // namespace feedscope::ui

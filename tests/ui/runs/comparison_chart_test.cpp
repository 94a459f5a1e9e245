#include "ui/runs/comparison_chart.h"

#include <gtest/gtest.h>

#include <QImage>
#include <QPainter>
#include <set>

#include "tests/ui/comparison_fixture.h"
#include "tests/ui/report/recorded_text.h"
#include "ui/scene/cause_colour.h"

namespace feedscope::ui {
namespace {

QRgb color_of(CauseKind kind) {
  const Rgb rgb = cause_colour(kind);
  return QColor::fromRgbF(static_cast<float>(rgb[0]), static_cast<float>(rgb[1]), static_cast<float>(rgb[2]))
      .rgb();
}

QImage drawn(ComparisonChart& chart, QSize size) {
  chart.resize(size);
  return chart.grab().toImage().convertToFormat(QImage::Format_RGB32);
}

TEST(ComparisonChart, FillsABarWithTheColoursOfItsCausesToScale) {
  const std::vector runs{feedscope::test::compared_run(
      "m", "essid", 0.01, {{{CauseKind::programmed_feed, -1}, 3}, {{CauseKind::axis_jerk, 1}, 1}})};
  ComparisonChart chart;
  chart.set_comparison("a.nc", "", comparison_bars(runs));
  const QImage image = drawn(chart, {1000, 300});
  const ComparisonLayout layout = lay_out(chart.bars(), {1000, 300}, chart.font());
  const int y = static_cast<int>(layout.rows[0].center().y() - layout.bar_height / 2 + 2);  // above its texts
  const auto at = [&](double time) { return image.pixel(static_cast<int>(layout.x_of(time)), y); };
  EXPECT_EQ(at(0.1), color_of(CauseKind::programmed_feed));
  EXPECT_EQ(at(2.9), color_of(CauseKind::programmed_feed));
  EXPECT_EQ(at(3.1), color_of(CauseKind::axis_jerk));
  EXPECT_EQ(at(3.9), color_of(CauseKind::axis_jerk));
  EXPECT_EQ(at(4.05), qRgb(255, 255, 255));
}

TEST(ComparisonChart, ShowsEveryKindThatItTellsApart) {
  ComparisonChart chart;
  chart.set_comparison("a.nc", "", comparison_bars(feedscope::test::many_compared_runs(40)));
  const QImage image = drawn(chart, chart.sizeHint());
  std::set<QRgb> seen;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      seen.insert(image.pixel(x, y));
    }
  }
  for (const CauseKind kind : chart.bars().kinds) {
    EXPECT_TRUE(seen.contains(color_of(kind))) << cause_title({kind, -1});
  }
}

TEST(ComparisonChart, DrawsNothingAndRunsWithoutMotion) {
  ComparisonChart chart;
  EXPECT_FALSE(drawn(chart, {640, 200}).isNull());
  chart.set_comparison("a.nc", "",
                       comparison_bars(std::vector{feedscope::test::compared_run("m", "cam", {}, {})}));
  EXPECT_FALSE(drawn(chart, {640, 300}).isNull());
}

TEST(ComparisonChart, RunsHaveTheirLettersWhereThereAreSeveral) {
  const std::vector times{std::pair{Cause{CauseKind::programmed_feed, -1}, 2.0}};
  std::vector runs{feedscope::test::compared_run("m", "essid", 0.01, times)};
  const auto texts = [&] {
    ComparisonChart chart;
    chart.set_comparison("a.nc", "", comparison_bars(runs));
    chart.resize(1000, 300);
    feedscope::test::RecordedText paper;
    QPainter painter(&paper);
    chart.draw(painter);
    return paper.texts();
  };
  EXPECT_FALSE(texts().contains("A"));
  runs.push_back(feedscope::test::compared_run("m", "essid", 0.05, times));
  EXPECT_TRUE(texts().contains("A"));
  EXPECT_TRUE(texts().contains("B"));
}

/// Otherwise a control that cuts less than the program looks fast.
TEST(ComparisonChart, MarksTheRunWhoseControlRefusesLines) {
  const std::vector times{std::pair{Cause{CauseKind::programmed_feed, -1}, 3.0}};
  std::vector runs{feedscope::test::compared_run("m", "cam", {}, times),
                   feedscope::test::compared_run("m", "klipper", {}, times)};
  ComparisonChart chart;
  const auto texts = [&] {
    chart.set_comparison("a.nc", "", comparison_bars(runs));
    chart.resize(1000, 300);
    feedscope::test::RecordedText paper;
    QPainter painter(&paper);
    chart.draw(painter);
    return paper.texts();
  };
  EXPECT_FALSE(texts().contains("refused lines"));
  EXPECT_EQ(texts().filter("×").size(), 2);
  runs[1].lines_not_run = 46;
  EXPECT_EQ(texts().filter("×").size(), 1) << "no ratio of a part to the whole";
  EXPECT_TRUE(texts().contains("refused lines"));
  EXPECT_TRUE(texts().contains("46"));
  EXPECT_TRUE(texts().contains("without refused lines"));

  const QImage image = drawn(chart, {1000, 300});
  const ComparisonLayout layout = lay_out(chart.bars(), {1000, 300}, chart.font());
  const auto colours_of = [&](std::size_t run) {
    const int y = static_cast<int>(layout.rows[run].center().y() - layout.bar_height / 2 + 2);
    std::set<QRgb> seen;
    for (int x = 10; x < 40; ++x) {
      seen.insert(image.pixel(static_cast<int>(layout.plot.left()) + x, y));
    }
    return seen;
  };
  EXPECT_EQ(colours_of(0), std::set{color_of(CauseKind::programmed_feed)});
  EXPECT_GT(colours_of(1).size(), 1u);
}

TEST(ComparisonChart, ElidesATitleThatIsTooLong) {
  ComparisonChart chart;
  chart.set_comparison(QString(500, 'W'), QString(500, 'm'),
                       comparison_bars(feedscope::test::many_compared_runs(2)));
  const QImage image = drawn(chart, {640, 400});
  for (int y = 0; y < 40; ++y) {
    EXPECT_EQ(image.pixel(636, y), qRgb(255, 255, 255)) << y;
  }
}

}  // namespace
}  // namespace feedscope::ui

#include "ui/charts/chart_header.h"

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>
#include <algorithm>

namespace feedscope::ui {
namespace {

class ChartHeaderTest : public testing::Test {
 protected:
  void give_width(int width) { header.fit_in({0, 0, width, 60}); }
  /// Of those that every run has; the machine's axes of five-axis runs stand behind them.
  std::size_t count() const {
    return static_cast<std::size_t>(std::ranges::count_if(spec.curves, [](const CurveSpec& curve) {
      return info_of(curve.quantity).source == QuantitySource::motion;
    }));
  }

  const ChartSpec spec = kinematic_chart_specs()[1];
  ChartHeader header{spec};
};

TEST_F(ChartHeaderTest, WhatIsListedStandsWithinItWhateverItsWidth) {
  header.list_all(true);
  header.set_notes({{5, "limit of X Y", {}}}, {"bands: 5 to 95 % of the time, pale: extremes"});
  for (int width = 1200; width >= 80; width -= 20) {
    give_width(width);
    EXPECT_LE(header.width(), width);
    for (std::size_t i = 0; i < count(); ++i) {
      EXPECT_TRUE(header.item(i).isNull() || header.rect().contains(header.item(i))) << width << ' ' << i;
      for (std::size_t k = 0; k < i; ++k) {
        EXPECT_FALSE(header.item(i).intersects(header.item(k))) << width << ' ' << i << ' ' << k;
      }
    }
  }
}

TEST_F(ChartHeaderTest, IsOneLineAsWideAsWhatIsShown) {
  give_width(1200);
  const int usual = header.width();
  EXPECT_LT(usual, 1200);
  header.list_all(true);
  EXPECT_GT(header.width(), usual) << "hidden curves too";
  EXPECT_LT(header.height(), 2 * header.fontMetrics().height());
}

TEST_F(ChartHeaderTest, HiddenCurvesAreListedUnderThePointer) {
  give_width(1200);
  const auto hidden = static_cast<std::size_t>(std::ranges::find_if(spec.curves, &CurveSpec::on_demand) -
                                               spec.curves.begin());
  ASSERT_LT(hidden, count());
  EXPECT_TRUE(header.item(hidden).isNull());
  QEnterEvent enter({2, 2}, {2, 2}, {2, 2});
  QCoreApplication::sendEvent(&header, &enter);
  EXPECT_FALSE(header.item(hidden).isNull());
  QSignalSpy clicked(&header, &ChartHeader::curve_clicked);
  QTest::mouseClick(&header, Qt::LeftButton, {}, header.item(hidden).center());
  ASSERT_EQ(clicked.count(), 1);
  EXPECT_EQ(clicked[0][0].value<std::size_t>(), hidden);
}

TEST_F(ChartHeaderTest, CurvesOfTheMachineAreListedWhereARunHasThem) {
  header.list_all(true);
  give_width(1200);
  ASSERT_EQ(spec.curves.size(), count() + 3);
  EXPECT_TRUE(header.item(count()).isEmpty());
  header.set_available(std::vector<bool>(spec.curves.size(), true));
  for (std::size_t i = 0; i < spec.curves.size(); ++i) {
    EXPECT_FALSE(header.item(i).isEmpty()) << i;
  }
}

TEST_F(ChartHeaderTest, TheTipNamesWhatHasNoRoom) {
  give_width(150);
  header.set_notes({{5, "limit of X Y", {}}}, {"rapids up to 20000"});
  header.set_runs({{QStringLiteral("slower"), Qt::red, false, 1.0}});
  const QString tip = header.tip_at({2, 2});
  EXPECT_TRUE(tip.contains("slower: 1"));
  EXPECT_TRUE(tip.contains("limit of X Y"));
  EXPECT_TRUE(tip.contains("rapids up to 20000"));
}

}  // namespace
}  // namespace feedscope::ui

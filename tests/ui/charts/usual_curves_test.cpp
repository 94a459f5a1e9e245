#include "ui/charts/usual_curves.h"

#include <gtest/gtest.h>

#include <QTest>
#include <numeric>

#include "tests/ui/charts/charts_panel_fixture.h"
#include "tests/ui/patience.h"

namespace feedscope::ui {
namespace {

/// Six thousand short cuts at 1200 mm/min, each after a rapid: more than the charts have columns for.
std::string long_program() {
  std::string text = "G21 G90 G94 G0 X0 Y0 Z0 F1200\n";
  for (int i = 0; i < 6000; ++i) {
    text += "G1 X10\nG0 Y10\nG0 X0\nG0 Y0\n";
  }
  return text;
}

class UsualCurvesTest : public test::ChartsPanelTest {
 protected:
  UsualCurvesTest() {
    cursor.set_trajectory(long_run.trajectory);
    panel.set_run(long_run.trajectory, std::make_shared<const Envelope>(long_run.trajectory), false);
    settle();
  }

  void settle() {
    panel.refresh();
    EXPECT_TRUE(QTest::qWaitFor([this] { return !panel.busy(); }, patience));
    QApplication::processEvents();
    panel.refresh();
    EXPECT_TRUE(QTest::qWaitFor([this] { return !panel.busy(); }, patience));
  }
  double largest(std::size_t chart, std::size_t curve) {
    Extent whole;
    const auto quantity = panel.chart(chart).spec().curves[curve].quantity;
    const Envelope envelope(long_run.trajectory);
    const auto bands = range.rapids_shown() ? envelope.columns(panel.column_times())
                                            : envelope.cutting_columns(panel.column_times());
    for (const Band& band : bands) {
      whole.add(band[quantity]);
    }
    return panel.chart(chart).spec().convert(double{whole.max});
  }

  feedscope::Run long_run = test::simulate_text(long_program());
};

TEST_F(UsualCurvesTest, StandInChartsOfLongPrograms) {
  FeedShares& shares = panel.shares();
  panel.resize(1100, panel.height());
  settle();
  EXPECT_TRUE(panel.chart(0).shows_usual());
  EXPECT_TRUE(panel.chart(1).shows_usual());
  EXPECT_TRUE(shares.isVisible());
  EXPECT_EQ(shares.geometry().left(), panel.chart(0).geometry().right() + 1);
  range.show_times(0, long_run.trajectory->duration() / 1000);
  settle();
  EXPECT_FALSE(panel.chart(0).shows_usual()) << "where columns show every block the curves do";
  EXPECT_FALSE(shares.isVisible());
}

TEST_F(UsualCurvesTest, HiddenRapidsAreInNoChart) {
  panel.chart(0).choose_values(Interval{0, 100'000});
  EXPECT_GT(largest(0, 0), 4000);
  const std::vector<double> with = panel.shares().shares();
  range.show_rapids(false);
  settle();
  EXPECT_FALSE(panel.chart(0).chosen_values()->width() < 100'000);
  panel.fit();
  settle();
  EXPECT_LT(panel.chart(0).values().upper, 1500) << "the largest feed is 1200 mm/min";
  const std::vector<double> without = panel.shares().shares();
  ASSERT_FALSE(without.empty());
  EXPECT_NEAR(std::accumulate(without.begin(), without.end(), 0.0), 1, 1e-9);
  for (const QPolygonF& line : panel.chart(0).mean_lines()) {
    for (const QPointF& place : line) {
      EXPECT_LT(panel.chart(0).value_at(place.y()), 1201);
    }
  }
}

TEST_F(UsualCurvesTest, SharesSayHowMuchTimePassesAtAFeed) {
  FeedShares& shares = panel.shares();
  range.show_rapids(false);
  settle();
  // A cut of 10 mm at 1200 mm/min lasts longest at that feed.
  const std::vector<double> bars = shares.shares();
  const auto most = std::ranges::max_element(bars) - bars.begin();
  const double upper = panel.chart(0).values().upper;
  EXPECT_NEAR((static_cast<double>(most) + 0.5) / static_cast<double>(bars.size()) * upper, 1200,
              2 * upper / static_cast<double>(bars.size()));
  EXPECT_GT(bars[static_cast<std::size_t>(most)], 0.5);
  const int y = static_cast<int>(panel.chart(0).height_of(1200));
  EXPECT_TRUE(shares.tip_at(y).contains(QStringLiteral("% of the time"))) << shares.tip_at(y).toStdString();
  EXPECT_TRUE(shares.tip_at(shares.height() - 1).isEmpty()) << "below zero";
}

}  // namespace
}  // namespace feedscope::ui

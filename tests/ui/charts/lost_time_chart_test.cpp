#include "ui/charts/lost_time_chart.h"

#include <gtest/gtest.h>

#include <QImage>
#include <QPainter>
#include <QTest>
#include <cmath>

#include "tests/ui/charts/charts_panel_fixture.h"
#include "tests/ui/patience.h"

namespace feedscope::ui {
namespace {

using feedscope::test::simulate_text;
using feedscope::test::small_program;

RunOverlay overlay_of(const feedscope::Run& run, const QString& name) {
  const auto envelope = std::make_shared<const Envelope>(run.trajectory);
  return {run.trajectory, envelope, {}, QColor(Qt::red), name};
}

feedscope::Run with_jerk(double jerk) {
  return simulate_run(load_program(std::make_shared<const SourceText>("test.nc", small_program)),
                      make_setup({"", "essid", std::nullopt, {"X.jerk=" + std::to_string(jerk)}}));
}

TEST(LostTimes, EndWithTheDifferenceOfTheCycleTimes) {
  const auto slow = with_jerk(5);
  const auto fast = with_jerk(40);
  const double duration = slow.trajectory->duration();
  LostTimes at;
  for (int i = 0; i <= 20; ++i) {
    at.times.push_back(duration * i / 20);
    at.positions.push_back(at.times.back());
  }
  const LostTimes lost =
      lost_times(*slow.trajectory, {overlay_of(fast, "fast"), overlay_of(slow, "same")}, at);
  ASSERT_EQ(lost.others.size(), 2U);
  EXPECT_EQ(lost.others[0].lost.front(), 0);
  EXPECT_NEAR(lost.others[0].lost.back(), duration - fast.trajectory->duration(), 1e-9);
  EXPECT_GT(lost.others[0].lost.back(), 0);
  for (const double same : lost.others[1].lost) {
    EXPECT_NEAR(same, 0, 1e-9);
  }
}

TEST(LostTimes, ARunOfAnotherPathIsLeftOut) {
  const auto run = simulate_text(small_program);
  const auto other = simulate_text("G21 G1 X1 F100\n");
  LostTimes at{{0, 1}, {0, 1}, {}};
  EXPECT_TRUE(lost_times(*run.trajectory, {overlay_of(other, "other")}, at).others.empty());
}

class LostTimeChartTest : public test::ChartsPanelTest {
 protected:
  bool rests() {
    panel.refresh();
    return QTest::qWaitFor([this] { return !panel.busy(); }, patience);
  }
};

TEST_F(LostTimeChartTest, IsThereWithAnotherRunAndTellsTheDifferenceAtTheCursor) {
  ASSERT_TRUE(rests());
  EXPECT_FALSE(panel.lost().isVisible());
  const auto fast = with_jerk(40);
  panel.set_overlays({overlay_of(fast, "fast")});
  ASSERT_TRUE(rests());
  ASSERT_TRUE(panel.lost().isVisible());
  cursor.set_time(0);
  EXPECT_EQ(panel.lost().value_text(0), "0.000 s");
  const double duration = run.trajectory->duration();
  cursor.set_time(duration);
  const double lost = duration - fast.trajectory->duration();
  EXPECT_EQ(panel.lost().value_text(0),
            QString(QChar(lost < 0 ? 0x2212 : '+')) + QString::number(std::abs(lost), 'f', 3) + " s");
  const Interval values = panel.lost().values();
  EXPECT_LE(values.lower, std::min(0.0, lost));
  EXPECT_GE(values.upper, std::max(0.0, lost));
  panel.set_overlays({});
  ASSERT_TRUE(rests());
  EXPECT_FALSE(panel.lost().isVisible());
}

TEST_F(LostTimeChartTest, FollowsTheRange) {
  panel.set_overlays({overlay_of(with_jerk(40), "fast")});
  const double duration = run.trajectory->duration();
  range.show_times(0.25 * duration, 0.5 * duration);
  ASSERT_TRUE(rests());
  EXPECT_NEAR(panel.lost().lost().times.front(), 0.25 * duration, 1e-6);
  EXPECT_NEAR(panel.lost().lost().times.back(), 0.5 * duration, 1e-6);
}

}  // namespace
}  // namespace feedscope::ui

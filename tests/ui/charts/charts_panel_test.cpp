#include "ui/charts/charts_panel.h"

#include <gtest/gtest.h>

#include <QPainter>
#include <QScrollArea>
#include <QScrollBar>

#include "tests/ui/charts/charts_panel_fixture.h"
#include "tests/ui/report/recorded_text.h"
#include "ui/theme/theme.h"

namespace feedscope::ui {
namespace {

using test::ChartsPanelTest;

constexpr std::size_t feed_chart = 0;
constexpr std::size_t achieved = 0;
constexpr std::size_t programmed = 1;

TEST_F(ChartsPanelTest, AClickInTheLegendHidesAndShowsACurve) {
  const QPoint item = panel.header(feed_chart).item(programmed).center();
  QTest::mouseClick(&panel.header(feed_chart), Qt::LeftButton, {}, item);
  EXPECT_FALSE(panel.chart(feed_chart).curve_shown(programmed));
  EXPECT_TRUE(panel.chart(feed_chart).curve_shown(achieved));
  panel.header(feed_chart).list_all(true);  // the pointer is over it
  QTest::mouseClick(&panel.header(feed_chart), Qt::LeftButton, {},
                    panel.header(feed_chart).item(programmed).center());
  EXPECT_TRUE(panel.chart(feed_chart).curve_shown(programmed));
}

TEST_F(ChartsPanelTest, CtrlClickShowsACurveAloneAndThenAll) {
  const QPoint item = panel.header(feed_chart).item(programmed).center();
  QTest::mouseClick(&panel.header(feed_chart), Qt::LeftButton, Qt::ControlModifier, item);
  EXPECT_TRUE(panel.chart(feed_chart).curve_shown(programmed));
  EXPECT_FALSE(panel.chart(feed_chart).curve_shown(achieved));
  QTest::mouseClick(&panel.header(feed_chart), Qt::LeftButton, Qt::ControlModifier,
                    panel.header(feed_chart).item(programmed).center());
  EXPECT_TRUE(panel.chart(feed_chart).curve_shown(achieved));
}

TEST_F(ChartsPanelTest, TheOrdinateFitsWhatIsShown) {
  constexpr std::size_t z = 4;
  panel.header(feed_chart).list_all(true);  // the pointer is over it
  QTest::mouseClick(&panel.header(feed_chart), Qt::LeftButton, Qt::ControlModifier,
                    panel.header(feed_chart).item(z).center());
  EXPECT_LT(panel.chart(feed_chart).values().upper, 100);  // Z does not move
  panel.show_curve(feed_chart, achieved, true);
  EXPECT_GT(panel.chart(feed_chart).values().upper, 2900);
}

TEST_F(ChartsPanelTest, RapidsLeaveTheFeedOfCuttingItsRoom) {
  const feedscope::Run slow = test::simulate_text("G0 X200 Y0 Z0\nG1 X210 F300\nY20\nG0 X0\nY0\nM30\n");
  const auto bands = std::make_shared<const Envelope>(slow.trajectory);
  EXPECT_NEAR(bands->cutting()[QuantityId::feed].max, 5, 0.1) << "mm/s";
  EXPECT_GT(bands->overall()[QuantityId::feed].max, 100);
  cursor.set_trajectory(slow.trajectory);
  panel.set_run(slow.trajectory, bands, false);
  panel.refresh();
  EXPECT_GT(panel.chart(0).values().upper, 300);
  EXPECT_LT(panel.chart(0).values().upper, 600);
  // A rapid alone is shown in full, and so is what the user asks for.
  const double first = slow.trajectory->state_at_path(199).time;
  ChartsState state;
  state.time = Interval{0, first};
  panel.set_state(state);
  panel.refresh();
  EXPECT_GT(panel.chart(0).values().upper, 10000);
  state.time.reset();
  panel.set_state(state);
  panel.refresh();
  panel.chart(0).choose_values(Interval{0, 25000});
  panel.refresh();
  EXPECT_EQ(panel.chart(0).values(), (Interval{0, 25000}));
  panel.chart(0).choose_values(std::nullopt);
  EXPECT_LT(panel.chart(0).values().upper, 600);
}

TEST_F(ChartsPanelTest, CtrlAndWheelZoomTheValuesAtThePointer) {
  KinematicChart& chart = panel.chart(1);
  const Interval before = chart.values();
  const double lower = panel.range().lower();
  const QPoint at = place(1, 0.4, 0.25);
  const double pivot = chart.value_at(at.y());
  wheel(1, at, Qt::ControlModifier);
  EXPECT_NEAR(chart.values().width(), 0.8 * before.width(), 1e-9);
  EXPECT_NEAR(chart.value_at(at.y()), pivot, 1e-9);
  EXPECT_EQ(panel.range().lower(), lower);
  QTest::mouseDClick(chart.viewport(), Qt::LeftButton, {}, QPoint(5, at.y()));
  EXPECT_EQ(chart.values(), before);
}

TEST_F(ChartsPanelTest, ShiftAndWheelPan) {
  panel.range().zoom(0.5, 0.5 * panel.range().length());
  const double lower = panel.range().lower();
  const double width = panel.range().upper() - lower;
  wheel(0, place(0, 0.5, 0.5), Qt::ShiftModifier);
  EXPECT_NEAR(panel.range().lower(), lower - 0.1 * width, 1e-9);
  EXPECT_NEAR(panel.range().upper() - panel.range().lower(), width, 1e-9);
}

TEST_F(ChartsPanelTest, AFlatBoxZoomsAlongTheAbscissaOnly) {
  const double length = panel.range().length();
  const Interval values = panel.chart(0).values();
  drag(0, place(0, 0.25, 0.5), place(0, 0.75, 0.5), Qt::RightButton);
  EXPECT_NEAR(panel.range().lower(), 0.25 * length, 0.005 * length);
  EXPECT_NEAR(panel.range().upper(), 0.75 * length, 0.005 * length);
  EXPECT_FALSE(panel.chart(0).chosen_values().has_value());
  EXPECT_NEAR(panel.chart(0).values().upper, values.upper, 0.2 * values.upper);
}

TEST_F(ChartsPanelTest, ATallBoxZoomsTheValuesToo) {
  KinematicChart& chart = panel.chart(0);
  const QPoint from = place(0, 0.2, 0.1);
  const QPoint to = place(0, 0.6, 0.8);
  const double upper = chart.value_at(from.y());
  const double lower = chart.value_at(to.y());
  const double left = chart.position_at(from.x());
  drag(0, from, to, Qt::LeftButton, Qt::ControlModifier);
  EXPECT_NEAR(chart.values().upper, upper, 1e-6);
  EXPECT_NEAR(chart.values().lower, lower, 1e-6);
  EXPECT_NEAR(panel.range().lower(), left, 1e-9);
  QTest::mouseDClick(chart.viewport(), Qt::LeftButton, {}, to);
  EXPECT_FALSE(chart.chosen_values().has_value());
  EXPECT_EQ(panel.range().lower(), 0);
}

TEST_F(ChartsPanelTest, DraggingPans) {
  panel.range().zoom(0.5, 0.5 * panel.range().length());
  const double grabbed = panel.chart(0).position_at(place(0, 0.5, 0.5).x());
  const QPoint to = place(0, 0.4, 0.5);
  drag(0, place(0, 0.5, 0.5), to, Qt::LeftButton);
  EXPECT_NEAR(panel.chart(0).position_at(to.x()), grabbed, 1e-9);
}

TEST_F(ChartsPanelTest, TheCausesCoverTheVisibleRange) {
  EXPECT_FALSE(panel.causes().legend_item(CauseKind::axis_jerk).isEmpty());
  const QRect bar = panel.causes().strip();
  EXPECT_EQ(bar.left(), static_cast<int>(plot(0).left()));
  EXPECT_EQ(bar.width(), static_cast<int>(plot(0).width()));
}

TEST_F(ChartsPanelTest, FollowsTheTheme) {
  const auto background = [this] {
    QPixmap picture(panel.chart(0).size());
    static_cast<QWidget&>(panel.chart(0)).render(&picture);
    return picture.toImage().pixelColor(2, 2);
  };
  apply_theme(ThemeKind::dark);
  QApplication::processEvents();
  EXPECT_LT(background().lightness(), 60);
  apply_theme(ThemeKind::light);
  QApplication::processEvents();
  EXPECT_GT(background().lightness(), 200);
}

TEST_F(ChartsPanelTest, NumbersAndTitlesHaveRoomAtTheSizeOfTheDockAndAtTheLeast) {
  for (const QSize& size : {QSize(934, 360), QSize(500, panel.minimumSizeHint().height())}) {
    panel.resize(size);
    QApplication::processEvents();
    panel.refresh();
    QApplication::processEvents();
    for (std::size_t i = 0; i < chart_count; ++i) {
      KinematicChart& chart = panel.chart(i);
      if (chart.isHidden()) {
        continue;  // without drives
      }
      feedscope::test::RecordedText paper;
      QPainter painter(&paper);
      chart.draw(painter);
      EXPECT_GE(paper.texts().size(), 2) << i;
      for (qsizetype k = 0; k < paper.texts().size(); ++k) {
        const feedscope::test::TextSpan& span = paper.spans()[static_cast<std::size_t>(k)];
        const std::string words = paper.texts()[k].toStdString();
        EXPECT_GE(span.left, 0) << size.width() << ' ' << i << ' ' << words;
        EXPECT_LE(span.right, chart.viewport()->width()) << size.width() << ' ' << i << ' ' << words;
      }
    }
  }
}

TEST_F(ChartsPanelTest, WithoutARunNothingIsShown) {
  panel.set_run(nullptr, nullptr, false);
  panel.refresh();
  EXPECT_TRUE(panel.causes().legend_item(CauseKind::axis_jerk).isEmpty());
  EXPECT_EQ(panel.chart(0).cursor(), std::nullopt);
}

TEST_F(ChartsPanelTest, LabelsStandInTheirPlots) {
  for (const int width : {300, 500, 700, 940}) {
    panel.resize(width, 420);
    QApplication::processEvents();
    for (std::size_t chart = 0; chart < 3; ++chart) {
      const QRect plot = panel.chart(chart).chart()->plotArea().toAlignedRect();
      EXPECT_TRUE(plot.contains(panel.header(chart).geometry())) << width << ' ' << chart;
    }
  }
}

/// A run with a cutting load has two charts more.
class ChartsOfALoad : public ChartsPanelTest {
 protected:
  ChartsOfALoad() {
    Engagement operation;
    operation.diameter = 10;
    operation.teeth = 2;
    operation.radial_depth = 2;
    operation.axial_depth = 5;
    operation.material = "steel-c45";
    operation.spindle_speed = 100;
    operation.least_chip = 0.005;
    operation.max_force = 800;
    RunSources sources;
    sources.load = std::make_shared<const RunLoad>(
        run.trajectory, LoadModel({{operation}, {}}, *run.input.program, *run.path));
    panel.set_run(run.trajectory, std::make_shared<const Envelope>(run.trajectory, sources), false, sources);
    settle();
  }
  void settle() {
    QApplication::processEvents();
    panel.refresh();
    QApplication::processEvents();
  }
  QScrollBar* bar() { return panel.findChild<QScrollArea*>()->verticalScrollBar(); }
};

TEST_F(ChartsOfALoad, WhatThereIsNoRoomForIsScrolledTo) {
  EXPECT_FALSE(panel.chart(force_chart).isHidden());
  EXPECT_FALSE(panel.chart(chip_chart).isHidden());
  EXPECT_TRUE(panel.chart(3).isHidden());  // without drives
  panel.resize(940, 260);
  settle();
  EXPECT_TRUE(bar()->isVisible());
  panel.resize(940, 900);
  settle();
  EXPECT_FALSE(bar()->isVisible());
  panel.resize(940, 260);
  settle();
  EXPECT_TRUE(bar()->isVisible());
}

TEST_F(ChartsOfALoad, AHiddenChartGivesItsRoomToTheOthersAndTheLastOneStays) {
  panel.show_chart(1, false);
  panel.show_chart(2, false);
  settle();
  EXPECT_TRUE(panel.chart(1).isHidden());
  EXPECT_FALSE(bar()->isVisible());
  EXPECT_EQ(panel.state().hidden_charts, QStringList({"acceleration", "jerk"}));
  const ChartsState kept = panel.state();
  for (const std::size_t chart : {std::size_t{0}, force_chart, chip_chart}) {
    panel.show_chart(chart, false);
  }
  EXPECT_FALSE(panel.chart_hidden(chip_chart));
  panel.set_state(ChartsState());
  EXPECT_FALSE(panel.chart(1).isHidden());
  panel.set_state(kept);
  EXPECT_TRUE(panel.chart(1).isHidden());
  EXPECT_FALSE(panel.chart(0).isHidden());
}

/// The filters of `ward` do not regard them, so that its curves would seem to break them.
TEST_F(ChartsPanelTest, JerkLimitsAreShownWhereTheModelKeepsThem) {
  auto setup = run.setup;
  const auto shown = [&](std::size_t chart) {
    panel.set_limits(setup);
    QApplication::processEvents();
    panel.refresh();
    return !panel.chart(chart).limits_in_sight().empty();
  };
  ASSERT_TRUE(shown(jerk_chart));
  const bool acceleration = shown(acceleration_chart);
  setup.model = &find_model("ward");
  setup.settings = complete_settings(*setup.model, setup.machine);
  EXPECT_FALSE(shown(jerk_chart));
  EXPECT_EQ(shown(acceleration_chart), acceleration);
}

TEST_F(ChartsOfALoad, BoundsOfTheOperationsAreLimitLines) {
  const std::vector<LimitLine> force = bound_lines(panel.chart(force_chart).spec(), *panel.sources().load);
  ASSERT_EQ(force.size(), 1U);
  EXPECT_DOUBLE_EQ(force[0].value, 800);
  const std::vector<LimitLine> chip = bound_lines(panel.chart(chip_chart).spec(), *panel.sources().load);
  ASSERT_EQ(chip.size(), 1U);
  EXPECT_DOUBLE_EQ(chip[0].value, 5);  // um
}

}  // namespace
}  // namespace feedscope::ui

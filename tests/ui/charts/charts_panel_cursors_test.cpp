#include <gtest/gtest.h>

#include <QAction>
#include <QKeyEvent>

#include "core/base/units.h"
#include "tests/ui/charts/charts_panel_fixture.h"
#include "tests/ui/own_tip.h"
#include "ui/charts/measurement.h"

namespace feedscope::ui {
namespace {

class ChartsCursors : public test::ChartsPanelTest {
 protected:
  ChartsCursors() {
    panel.activateWindow();
    panel.chart(0).setFocus();
    QApplication::processEvents();
  }

  void press(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
    QTest::keyClick(&panel.chart(0), key, modifiers);
    panel.refresh();
  }
  double pixel() { return (panel.range().upper() - panel.range().lower()) / plot(0).width(); }
};

TEST(Measurement, IsTheSecondLessTheFirst) {
  State a = Trajectory().state(0);
  a.time = 1;
  a.path_length = 10;
  a.speed = 5;
  State b = a;
  b.time = 3;
  b.path_length = 40;
  b.speed = 2;
  const Measurement m = measure(a, b);
  EXPECT_EQ(m.time, 2);
  EXPECT_EQ(m.path_length, 30);
  EXPECT_EQ(m.mean_feed, 15);
  EXPECT_EQ(m.feed, -3);
  EXPECT_EQ(measure(b, a).mean_feed, 15);
  EXPECT_EQ(measure(a, a).mean_feed, 0);
}

/// The cursor hears of a new run before the charts do, and then points to elements that theirs does not have.
TEST_F(ChartsCursors, ACursorOfAnotherRunIsNotShownInThisOne) {
  panel.set_second_cursor(trajectory().duration() / 2);
  ASSERT_TRUE(panel.chart(0).cursor().has_value());
  std::string longer = "G21 G90 F3000\n";
  for (int i = 0; i < 200; ++i) {
    longer += "G1 X" + std::to_string(i % 5) + " Y" + std::to_string(i) + "\n";
  }
  const feedscope::Run other = test::simulate_text(longer);
  cursor.set_trajectory(other.trajectory);
  cursor.set_time(other.trajectory->duration());
  EXPECT_EQ(panel.chart(0).cursor(), std::nullopt);
  EXPECT_TRUE(panel.measurement_text().isEmpty());
  panel.set_run(other.trajectory, std::make_shared<const Envelope>(other.trajectory), false, other.sources);
  panel.refresh();
  EXPECT_NEAR(panel.chart(0).cursor().value_or(-1), other.trajectory->duration(), 1e-9);
}

TEST_F(ChartsCursors, AShiftClickSetsTheSecondAndEscRemovesIt) {
  const QPoint at = place(1, 0.6, 0.5);
  const double time = panel.chart(1).position_at(at.x());
  const double first = cursor.state().time;
  QTest::mouseClick(&panel.chart(1), Qt::LeftButton, Qt::ShiftModifier, at);
  ASSERT_TRUE(panel.second_cursor().has_value());
  EXPECT_NEAR(*panel.second_cursor(), time, 1e-9);
  EXPECT_EQ(cursor.state().time, first);
  for (std::size_t i = 0; i < chart_count; ++i) {
    EXPECT_NEAR(panel.chart(i).second_cursor().value_or(-1), time, 1e-9);
  }
  press(Qt::Key_Escape);
  EXPECT_FALSE(panel.second_cursor().has_value());
  EXPECT_TRUE(panel.measurement_text().isEmpty());
}

TEST_F(ChartsCursors, EscIsLeftToTheWindowWithoutASecondCursor) {
  QKeyEvent key(QEvent::ShortcutOverride, Qt::Key_Escape, Qt::NoModifier);
  key.ignore();
  QApplication::sendEvent(&panel.chart(0), &key);
  EXPECT_FALSE(key.isAccepted());
  panel.set_second_cursor(0.5);
  QApplication::sendEvent(&panel.chart(0), &key);
  EXPECT_TRUE(key.isAccepted());
}

TEST_F(ChartsCursors, DifferencesAreShown) {
  cursor.set_time(0.25);
  panel.set_second_cursor(0.75);
  const State a = trajectory().state(0.25);
  const State b = trajectory().state(0.75);
  const QString length = QString::number(b.path_length - a.path_length, 'f', 3);
  EXPECT_TRUE(panel.measurement_text().contains("Δt 0.5000 s"));
  EXPECT_TRUE(panel.measurement_text().contains("Δs " + length + " mm"));
  const double mean = units::to_mm_min((b.path_length - a.path_length) / 0.5);
  EXPECT_TRUE(panel.measurement_text().contains("mean feed " + QString::number(mean, 'f', 0) + " mm/min"));
}

TEST_F(ChartsCursors, KeysMoveTheFirstByPixels) {
  cursor.set_time(0.5);
  press(Qt::Key_Right);
  EXPECT_NEAR(cursor.state().time, 0.5 + pixel(), 1e-9);
  press(Qt::Key_Left, Qt::ShiftModifier);
  EXPECT_NEAR(cursor.state().time, 0.5 - 9 * pixel(), 1e-9);
  press(Qt::Key_Right, Qt::ShiftModifier);
  press(Qt::Key_Left);
  EXPECT_NEAR(cursor.state().time, 0.5, 1e-9);
}

TEST_F(ChartsCursors, KeysSetTheSecondAndZoomBetween) {
  cursor.set_time(0.4);
  press(Qt::Key_B);
  cursor.set_time(0.9);
  press(Qt::Key_Z);
  EXPECT_NEAR(panel.range().lower(), 0.4, 1e-9);
  EXPECT_NEAR(panel.range().upper(), 0.9, 1e-9);
}

TEST_F(ChartsCursors, KeysZoomAroundTheCursor) {
  cursor.set_time(0.5);
  const double share = 0.5 / panel.range().length();
  press(Qt::Key_Plus);
  EXPECT_NEAR(panel.range().upper() - panel.range().lower(), panel.range().length() / 2, 1e-9);
  EXPECT_NEAR((0.5 - panel.range().lower()) / (panel.range().upper() - panel.range().lower()), share, 1e-9);
  press(Qt::Key_Minus);
  EXPECT_NEAR(panel.range().upper(), panel.range().length(), 1e-9);
}

TEST_F(ChartsCursors, CtrlAltAndArrowsGoThroughWhatWasShown) {
  const double whole = panel.range().upper();
  panel.range().zoom(0.5, 0);
  panel.range().zoom(0.5, 0);  // one gesture
  press(Qt::Key_Left, Qt::ControlModifier | Qt::AltModifier);
  EXPECT_NEAR(panel.range().upper(), whole, 1e-9);
  press(Qt::Key_Right, Qt::ControlModifier | Qt::AltModifier);
  EXPECT_NEAR(panel.range().upper(), whole / 4, 1e-9);
  panel.chart(1).choose_values(Interval{-0.1, 0.2});
  press(Qt::Key_Left, Qt::ControlModifier | Qt::AltModifier);
  EXPECT_FALSE(panel.chart(1).chosen_values().has_value());
  EXPECT_NEAR(panel.range().upper(), whole / 4, 1e-9);
  press(Qt::Key_Right, Qt::ControlModifier | Qt::AltModifier);
  EXPECT_EQ(panel.chart(1).values(), (Interval{-0.1, 0.2}));
}

TEST_F(ChartsCursors, TheSecondStaysAtItsPlaceForAnotherRunOfTheProgram) {
  panel.set_second_cursor(0.5);
  const double s = trajectory().state(0.5).path_length;
  const auto slow = test::simulate_text(test::small_program, "cam").trajectory;
  cursor.set_trajectory(slow);
  panel.set_run(slow, std::make_shared<const Envelope>(slow), true);
  EXPECT_NEAR(slow->state(panel.second_cursor().value_or(0)).path_length, s, 1e-6);
}

void expect_texts_and_tips(const QList<QAction*>& actions, int& count) {
  for (const QAction* action : actions) {
    if (action->menu() != nullptr) {
      expect_texts_and_tips(action->menu()->actions(), count);
    } else if (!action->isSeparator()) {
      ++count;
      EXPECT_FALSE(action->text().isEmpty());
      EXPECT_TRUE(feedscope::test::has_own_tip(*action)) << action->text().toStdString();
    }
  }
}

TEST_F(ChartsCursors, EveryCommandHasATextAndATip) {
  int count = 0;
  QList<QAction*> commands = panel.panel_actions();
  commands.removeIf([](const QAction* action) { return action->text().startsWith("Curves of"); });
  expect_texts_and_tips(commands, count);
  EXPECT_GE(count, 15);
}

}  // namespace
}  // namespace feedscope::ui

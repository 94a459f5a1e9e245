#include "ui/scene_view/scene_view.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QMenu>
#include <QSignalSpy>
#include <QTest>
#include <QTimer>
#include <QToolTip>
#include <QWheelEvent>
#include <cmath>
#include <set>

#include "tests/ui/own_tip.h"
#include "tests/ui/run_fixture.h"
#include "ui/scene_view/scene_json.h"

namespace feedscope::ui {
namespace {

class SceneViewTest : public testing::Test {
 protected:
  SceneViewTest() : run_(test::simulate_text(test::small_program)) {
    view_.resize(800, 600);
    view_.scene().set_programmed(run_.path.toolpath);
    view_.scene().set_executed(run_.trajectory);
    view_.scene().set_standard_view(StandardView::top);
    view_.show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(&view_));
    settle();
  }

  void settle() {
    QTest::qWait(50);
    view_.grab();  // a frame is drawn, whatever the platform puts off
  }

  QPoint place_of(double time) {
    const Pixel pixel = view_.scene().pixel_of(run_.trajectory->state(time).position);
    const double ratio = view_.canvas().devicePixelRatioF();
    return {static_cast<int>(std::lround(pixel[0] / ratio)), static_cast<int>(std::lround(pixel[1] / ratio))};
  }

  feedscope::Run run_;
  SceneView view_;
};

TEST_F(SceneViewTest, ClickOnThePathPicksItsTime) {
  QSignalSpy picked(&view_, &SceneView::picked);
  const double duration = run_.trajectory->duration();
  for (const double time : {0.2 * duration, 0.5 * duration, 0.9 * duration}) {
    QTest::mouseClick(&view_.canvas(), Qt::LeftButton, {}, place_of(time));
    ASSERT_EQ(picked.count(), 1) << time;
    EXPECT_NEAR(picked.takeFirst().at(0).toDouble(), time, 0.01 * duration);
  }
}

TEST_F(SceneViewTest, ARightClickPicksOnlyForTheCommandThatIsChosen) {
  QAction annotate("Annotate");
  view_.set_place_actions({&annotate});
  QSignalSpy picked(&view_, &SceneView::picked);
  QSignalSpy annotated(&annotate, &QAction::triggered);
  const auto right_click = [&](bool choose) {
    QTimer::singleShot(50, &view_, [choose] {
      auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
      ASSERT_NE(menu, nullptr);
      QAction* first = menu->actions().first();
      EXPECT_EQ(first->text(), "Annotate");
      if (choose) {
        first->trigger();
      }
      menu->close();
    });
    QTest::mouseClick(&view_.canvas(), Qt::RightButton, {}, place_of(0.5 * run_.trajectory->duration()));
  };
  right_click(false);
  EXPECT_EQ(picked.count(), 0);
  right_click(true);
  ASSERT_EQ(picked.count(), 1);
  EXPECT_NEAR(picked.front().front().toDouble(), 0.5 * run_.trajectory->duration(), 0.02);
  EXPECT_EQ(annotated.count(), 1);
}

TEST_F(SceneViewTest, ClickBesideThePathPicksNothing) {
  QSignalSpy picked(&view_, &SceneView::picked);
  QTest::mouseClick(&view_.canvas(), Qt::LeftButton, {}, QPoint(100, 80));
  EXPECT_EQ(picked.count(), 0);
}

TEST_F(SceneViewTest, DragTurnsTheSceneAndPicksNothing) {
  QSignalSpy picked(&view_, &SceneView::picked);
  const double time = run_.trajectory->duration() / 2;
  const QPoint from = place_of(time);
  const Pixel before = view_.scene().pixel_of({60, 60, 0});
  QTest::mousePress(&view_.canvas(), Qt::LeftButton, {}, from);
  for (int step = 10; step <= 60; step += 10) {
    QTest::mouseMove(&view_.canvas(), from + QPoint(step, -step));
    QTest::qWait(5);
  }
  QTest::mouseRelease(&view_.canvas(), Qt::LeftButton, {}, from + QPoint(60, -60));
  const Pixel after = view_.scene().pixel_of({60, 60, 0});
  EXPECT_EQ(picked.count(), 0);
  EXPECT_GT(std::hypot(after[0] - before[0], after[1] - before[1]), 10);
}

TEST_F(SceneViewTest, WheelZoomsAndFitGoesBack) {
  const auto span = [&] {
    return std::abs(view_.scene().pixel_of({60, 0, 0})[0] - view_.scene().pixel_of({0, 0, 0})[0]);
  };
  const double before = span();
  const QPointF middle(400, 300);
  QWheelEvent wheel(middle, view_.canvas().mapToGlobal(middle), {}, QPoint(0, 120), Qt::NoButton,
                    Qt::NoModifier, Qt::NoScrollPhase, false);
  QApplication::sendEvent(&view_.canvas(), &wheel);
  EXPECT_GT(span(), 1.05 * before);
  view_.scene().fit();
  settle();
  EXPECT_NEAR(span(), before, 0.01 * before);
}

TEST_F(SceneViewTest, ShowsLinesTextAndColours) {
  const QImage image = view_.grab().toImage();
  std::set<QRgb> colours;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      colours.insert(image.pixel(x, y));
    }
  }
  EXPECT_GT(colours.size(), 150U);
  EXPECT_GT(qGray(image.pixel(5, image.height() - 5)), 245) << "light background, opaque";
}

TEST_F(SceneViewTest, MovesTheToolMarkerWithTheCursor) {
  const QImage without = view_.canvas().grab().toImage();
  view_.scene().set_cursor(run_.trajectory->state(0.5 * run_.trajectory->duration()).position);
  settle();
  const QImage with = view_.canvas().grab().toImage();
  EXPECT_NE(with, without);
  const QPoint tip = place_of(0.5 * run_.trajectory->duration());
  const QColor colour = with.pixelColor(tip * with.devicePixelRatio());
  EXPECT_GT(colour.red(), colour.blue() + 60) << "the tool is orange";
  view_.scene().set_cursor(std::nullopt);
  settle();
  EXPECT_EQ(view_.canvas().grab().toImage(), without);
}

QAction* action(const SceneView& view, const QString& text) {
  for (QAction* action : view.panel_actions()) {
    if (QString(action->text()).remove('&') == text) {
      return action;
    }
  }
  ADD_FAILURE() << "no command " << text.toStdString();
  return nullptr;
}

TEST_F(SceneViewTest, EveryCommandHasATextAndATip) {
  QStringList keys;
  for (const QAction* command : view_.panel_actions()) {
    EXPECT_FALSE(command->text().isEmpty());
    EXPECT_TRUE(test::has_own_tip(*command)) << command->text().toStdString();
    if (!command->shortcut().isEmpty()) {
      EXPECT_FALSE(keys.contains(command->shortcut().toString())) << command->text().toStdString();
      keys.append(command->shortcut().toString());
    }
  }
  EXPECT_GT(view_.panel_actions().size(), 30);
}

TEST_F(SceneViewTest, CommandsChangeTheScene) {
  action(view_, "Limiting cause")->trigger();
  EXPECT_EQ(view_.scene().colouring(), Colouring::cause);
  action(view_, "× 50")->trigger();
  EXPECT_EQ(view_.scene().exaggeration(), 50);
  action(view_, "Ball end mill")->trigger();
  EXPECT_EQ(view_.scene().tool().kind, ToolKind::ball);
  action(view_, "Perspective")->trigger();
  EXPECT_TRUE(view_.scene().perspective());
  action(view_, "Grid and axes")->trigger();
  EXPECT_TRUE(view_.scene().axes());
  action(view_, "Back")->trigger();
  EXPECT_NEAR(view_.scene().camera().azimuth, std::acos(0.0), 1e-12);
}

TEST_F(SceneViewTest, TheBarSaysWhatTheSceneShowsWhoeverChangedIt) {
  const SceneState first = view_.state();
  EXPECT_FALSE(action(view_, "Grid and axes")->isChecked());
  SceneState wanted = first;
  wanted.camera = {.azimuth = 0.4, .elevation = 0.2, .height = 30, .perspective = true};
  wanted.colouring = Colouring::jerk;
  wanted.exaggeration = 50;
  wanted.tool = {ToolKind::bull, 8.125, 1.5};
  wanted.axes = true;
  view_.set_state(wanted);
  EXPECT_NEAR((view_.state().camera.focal - wanted.camera.focal).norm(), 0, 1e-9);
  EXPECT_NEAR(view_.state().camera.height, 30, 1e-9);
  EXPECT_EQ(view_.state().tool, wanted.tool);
  for (const char* text : {"Jerk", "× 50", "Bull nose end mill", "Perspective", "Grid and axes"}) {
    EXPECT_TRUE(action(view_, text)->isChecked()) << text;
  }
  for (const char* text : {"Feed", "× 1", "Marker"}) {
    EXPECT_FALSE(action(view_, text)->isChecked()) << text;
  }
  view_.scene().set_exaggeration(3);
  EXPECT_FALSE(action(view_, "× 50")->isChecked()) << "none of the choices";
  view_.set_state(first);
  EXPECT_EQ(to_json(view_.state()), to_json(first)) << "as sessions keep it";
  EXPECT_TRUE(action(view_, "× 1")->isChecked());
  action(view_, "× 2")->trigger();
  EXPECT_FALSE(action(view_, "× 1")->isChecked()) << "one at a time";
}

TEST_F(SceneViewTest, MeasuresBetweenTwoClicksUntilEscape) {
  QSignalSpy measuring(&view_, &SceneView::measuring_changed);
  const QImage before = view_.canvas().grab().toImage();
  view_.canvas().setFocus();
  if (view_.isActiveWindow()) {
    QTest::keyClick(&view_.canvas(), Qt::Key_M);
  } else {  // a display without window manager activates no window
    action(view_, "Measure")->trigger();
  }
  ASSERT_EQ(measuring.count(), 1);
  const double duration = run_.trajectory->duration();
  QTest::mouseClick(&view_.canvas(), Qt::LeftButton, {}, place_of(0.2 * duration));
  QTest::mouseClick(&view_.canvas(), Qt::LeftButton, {}, place_of(0.8 * duration));
  settle();
  EXPECT_NE(view_.canvas().grab().toImage(), before);
  QTest::keyClick(&view_.canvas(), Qt::Key_Escape);
  EXPECT_EQ(measuring.count(), 2);
  EXPECT_FALSE(action(view_, "Measure")->isChecked());
  QTest::mouseMove(&view_.canvas(), QPoint(5, 5));
  settle();
  EXPECT_EQ(view_.canvas().grab().toImage(), before);
}

TEST_F(SceneViewTest, TheMouseOverThePathTellsWhatIsThere) {
  const double time = 0.4 * run_.trajectory->duration();
  QTest::mouseMove(&view_.canvas(), QPoint(5, 5));
  QTest::mouseMove(&view_.canvas(), place_of(time));
  const QString line = QString::number(run_.trajectory->state(time).line);
  EXPECT_TRUE(QTest::qWaitFor([&] { return QToolTip::text().contains("Line " + line); }, 3000))
      << QToolTip::text().toStdString();
  QTest::mouseMove(&view_.canvas(), QPoint(5, 5));
  EXPECT_TRUE(QTest::qWaitFor([&] { return !QToolTip::isVisible() || QToolTip::text().isEmpty(); }, 3000));
}

TEST_F(SceneViewTest, ABoxZoomsTheViewAndTheCharts) {
  QSignalSpy chosen(&view_, &SceneView::times_chosen);
  const QPoint middle = place_of(0.5 * run_.trajectory->duration());
  const auto span = [&] {
    return std::abs(view_.scene().pixel_of({60, 0, 0})[0] - view_.scene().pixel_of({0, 0, 0})[0]);
  };
  const double before = span();
  QTest::mousePress(&view_.canvas(), Qt::LeftButton, Qt::ControlModifier, middle - QPoint(40, 40));
  QTest::mouseMove(&view_.canvas(), middle);
  QTest::mouseMove(&view_.canvas(), middle + QPoint(40, 40));
  QTest::mouseRelease(&view_.canvas(), Qt::LeftButton, Qt::ControlModifier, middle + QPoint(40, 40));
  ASSERT_EQ(chosen.count(), 1);
  const double from = chosen.first().at(0).toDouble();
  const double to = chosen.first().at(1).toDouble();
  EXPECT_LT(from, 0.5 * run_.trajectory->duration());
  EXPECT_GT(to, 0.5 * run_.trajectory->duration());
  EXPECT_LT(to - from, 0.5 * run_.trajectory->duration());
  EXPECT_GT(span(), 2 * before);
}

TEST_F(SceneViewTest, AClickOnTheCubeTurnsTheView) {
  view_.scene().set_standard_view(StandardView::iso);
  settle();
  const double ratio = view_.canvas().devicePixelRatioF();
  const int width = view_.canvas().width();
  for (int y = 0; y < 80; y += 3) {
    for (int x = width - 80; x < width; x += 3) {
      if (view_.scene().cube_view({x * ratio, y * ratio}) == StandardView::front) {
        QTest::mouseClick(&view_.canvas(), Qt::LeftButton, {}, QPoint(x, y));
        EXPECT_EQ(view_.scene().camera().elevation, 0);
        EXPECT_NEAR(view_.scene().camera().azimuth, -std::acos(0.0), 1e-12);
        return;
      }
    }
  }
  FAIL() << "no front face";
}

TEST_F(SceneViewTest, MarksTheRangeOfTheChartsUnlessItIsAll) {
  const QImage before = view_.canvas().grab().toImage();
  const double duration = run_.trajectory->duration();
  view_.show_times(0.3 * duration, 0.6 * duration);
  settle();
  EXPECT_NE(view_.canvas().grab().toImage(), before);
  view_.show_times(0, duration);
  view_.rest();
  settle();
  EXPECT_EQ(view_.canvas().grab().toImage(), before);
}

TEST_F(SceneViewTest, HasSmoothEdgesAgainWhenItRests) {
  const QImage before = view_.canvas().grab().toImage();
  view_.scene().set_moving(true);
  settle();
  EXPECT_NE(view_.canvas().grab().toImage(), before) << "software draws what moves without smoothing edges";
  settle();
  view_.rest();
  settle();
  EXPECT_EQ(view_.canvas().grab().toImage(), before);
}

TEST_F(SceneViewTest, FollowsADarkPalette) {
  QPalette dark = view_.palette();
  dark.setColor(QPalette::Window, QColor(0x26, 0x29, 0x2d));
  view_.setPalette(dark);
  settle();
  const QImage image = view_.canvas().grab().toImage();
  EXPECT_LT(qGray(image.pixel(5, image.height() - 5)), 60);
}

TEST_F(SceneViewTest, SeveralViewsLiveInOneProcess) {
  SceneView second;
  second.resize(300, 200);
  second.show();
  EXPECT_TRUE(QTest::qWaitForWindowExposed(&second));
  second.grab();
  view_.grab();
}

}  // namespace
}  // namespace feedscope::ui

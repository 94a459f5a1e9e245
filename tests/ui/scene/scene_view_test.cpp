#include "ui/views/scene_view.h"

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>
#include <set>

#include "tests/ui/run_fixture.h"

namespace feedscope::ui {
namespace {

class SceneViewTest : public testing::Test {
 protected:
  SceneViewTest() : run_(test::simulate_text(test::small_program)) {
    view_.resize(800, 600);
    view_.scene().set_programmed(run_.input.toolpath);
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

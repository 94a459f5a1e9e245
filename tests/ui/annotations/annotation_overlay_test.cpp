#include "ui/annotations/annotation_overlay.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QPlainTextEdit>
#include <QSignalSpy>
#include <QTest>

#include "tests/ui/run_fixture.h"
#include "ui/annotations/annotations_view.h"
#include "ui/charts/charts_panel.h"
#include "ui/window/main_window.h"

namespace feedscope::ui {
namespace {

class AnnotationOverlayTest : public testing::Test {
 protected:
  AnnotationOverlayTest() {
    QLocale::setDefault(QLocale::c());
    window.resize(1280, 800);
    window.show();
    const LoadedProgram input =
        load_program(std::make_shared<const SourceText>("test.nc", test::small_program));
    model.show(simulate_run(input, make_setup({})));
    model.cursor().set_time(model.shown()->run.trajectory->duration() / 3);
  }

  QAction& action(AnnotationKind kind) {
    return *window.part<AnnotationsView>().panel_actions()[static_cast<qsizetype>(kind)];
  }
  const Annotation& only() const { return list.items().at(0); }
  /// The camera is that of the last frame.
  PlacedAnnotation placed() {
    window.scene().grab();
    return window.scene().annotations().placed().at(0);
  }
  void drag(const QPointF& from, const QPointF& to) {
    QWidget* canvas = &window.scene().canvas();
    QTest::mousePress(canvas, Qt::LeftButton, {}, from.toPoint());
    QTest::mouseMove(canvas, ((from + to) / 2).toPoint());
    QTest::mouseMove(canvas, to.toPoint());
    QTest::mouseRelease(canvas, Qt::LeftButton, {}, to.toPoint());
  }

  Workbench model{shipped_machines(), make_setup({})};
  MainWindow window{model, RenderBackend::software};
  AnnotationList& list = model.annotations();
};

TEST_F(AnnotationOverlayTest, ACalloutStandsAtTheCursorAndTellsItsValues) {
  action(AnnotationKind::callout).trigger();
  const State at = model.cursor().state();
  const PlacedAnnotation shown = placed();
  const Pixel pixel = window.scene().scene().pixel_of(at.position);
  EXPECT_NEAR(shown.anchor.x(), pixel[0], 0.5);
  EXPECT_NEAR(shown.anchor.y(), pixel[1], 0.5);
  ASSERT_EQ(shown.lines.size(), 3);
  EXPECT_EQ(shown.lines[0], QStringLiteral("%1 mm/min").arg(60 * at.speed, 0, 'f', 0));
}

/// Letters would be keys of the window else.
TEST_F(AnnotationOverlayTest, WhatIsTypedBehindANewLabelIsItsText) {
  window.activateWindow();
  window.scene().canvas().setFocus();
  action(AnnotationKind::callout).trigger();
  QWidget* focused = window.focusWidget();
  ASSERT_EQ(focused, window.part<AnnotationsView>().text());
  QTest::keyClicks(focused, "my label");
  EXPECT_EQ(only().text, QStringLiteral("my label")) << "the text that was there is replaced";
}

TEST_F(AnnotationOverlayTest, ADraggedLabelMovesInOneStepAndThePathStays) {
  action(AnnotationKind::callout).trigger();
  const PlacedAnnotation before = placed();
  const CameraState camera = window.scene().scene().camera();
  const QPointF target = before.label.center() + QPointF(-70, 90);
  drag(before.label.center(), target);
  const PlacedAnnotation after = placed();
  EXPECT_NEAR(after.label.center().x(), target.x(), 1.5);
  EXPECT_NEAR(after.label.center().y(), target.y(), 1.5);
  EXPECT_EQ(after.anchor, before.anchor);
  EXPECT_EQ(window.scene().scene().camera().azimuth, camera.azimuth);
  model.runs().history().undo();
  EXPECT_EQ(placed().label, before.label);
}

TEST_F(AnnotationOverlayTest, TheDotMovesAlongThePath) {
  action(AnnotationKind::arrow).trigger();
  const ProgrammedPlace before = only().place;
  const Trajectory& trajectory = *model.shown()->run.trajectory;
  const PlacedAnnotation at = placed();
  const Pixel target =
      window.scene().scene().pixel_of(trajectory.state(0.7 * trajectory.duration()).position);
  drag(at.anchor, QPointF(target[0], target[1]));
  EXPECT_FALSE(only().place == before);
  const PlacedAnnotation moved = placed();
  EXPECT_LT(QLineF(moved.anchor, QPointF(target[0], target[1])).length(), 3);
}

TEST_F(AnnotationOverlayTest, AClickBesideLabelsGoesToTheScene) {
  action(AnnotationKind::text).trigger();
  const double azimuth = window.scene().scene().camera().azimuth;
  const QPointF beside = placed().label.bottomRight() + QPointF(40, 60);
  drag(beside, beside + QPointF(60, 0));
  EXPECT_NE(window.scene().scene().camera().azimuth, azimuth);
  EXPECT_EQ(list.selected(), 0);
}

TEST_F(AnnotationOverlayTest, ADoubleClickGoesToTheTextAndTypingChangesIt) {
  action(AnnotationKind::text).trigger();
  const QPoint label = placed().label.center().toPoint();
  QTest::mouseDClick(&window.scene().canvas(), Qt::LeftButton, {}, label);
  window.part<AnnotationsView>().text()->selectAll();
  QTest::keyClicks(window.part<AnnotationsView>().text(), "Hello");
  EXPECT_EQ(only().text, QStringLiteral("Hello"));
  EXPECT_EQ(placed().lines, QStringList("Hello"));
}

TEST_F(AnnotationOverlayTest, DeleteRemovesTheSelectedOne) {
  action(AnnotationKind::text).trigger();
  QTest::keyClick(&window.scene().canvas(), Qt::Key_Delete);
  EXPECT_TRUE(list.items().empty());
}

TEST_F(AnnotationOverlayTest, DeleteInTheListRemovesTheOneChosenThere) {
  action(AnnotationKind::text).trigger();  // the keyboard goes to its text
  QTest::keyClick(window.part<AnnotationsView>().table(), Qt::Key_Delete);
  EXPECT_TRUE(list.items().empty());
}

TEST_F(AnnotationOverlayTest, LabelsStayInThePicture) {
  action(AnnotationKind::text).trigger();
  Annotation far = only();
  far.offset = {5000, -5000};
  list.change(far, "move");
  const QRectF picture(QPointF(), QSizeF(window.scene().canvas().size()));
  EXPECT_TRUE(picture.contains(placed().label));
}

TEST_F(AnnotationOverlayTest, ManyLabelsInASmallViewCoverNoOther) {
  constexpr int count = 5;
  const double duration = model.shown()->run.trajectory->duration();
  for (int i = 0; i < count; ++i) {
    model.cursor().set_time(duration * (i + 1) / (count + 1));
    action(AnnotationKind::callout).trigger();
  }
  window.scene().grab();
  const std::vector<PlacedAnnotation> all = window.scene().annotations().placed();
  ASSERT_EQ(all.size(), static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      EXPECT_FALSE(all[i].label.intersects(all[k].label)) << i << ' ' << k;
    }
  }
}

TEST_F(AnnotationOverlayTest, ADimensionGoesBetweenTheCursors) {
  const double second = model.shown()->run.trajectory->duration() / 2;
  window.part<ChartsPanel>().set_second_cursor(second);
  action(AnnotationKind::dimension).trigger();
  const Vec3 there = model.shown()->run.trajectory->state(second).position;
  const double distance = (there - model.cursor().state().position).norm();
  EXPECT_EQ(placed().lines.at(0), QStringLiteral("%1 mm").arg(distance, 0, 'f', 3));
}

TEST_F(AnnotationOverlayTest, ADimensionIsThatOfTheBlockWhileTheWholeRunIsVisible) {
  action(AnnotationKind::dimension).trigger();
  ASSERT_EQ(list.items().size(), 1U);
  const Annotation& item = list.items().front();
  const ProgrammedPlace here = programmed_place(*model.shown()->run.trajectory, model.cursor().state().time);
  EXPECT_EQ(item.place, (ProgrammedPlace{here.segment, 0}));
  EXPECT_EQ(item.until, (ProgrammedPlace{here.segment, 1}));
}

TEST_F(AnnotationOverlayTest, AnotherProgramHasNone) {
  action(AnnotationKind::callout).trigger();
  const LoadedProgram other = load_program(std::make_shared<const SourceText>("other.nc", "G1 F100 X1\n"));
  model.show(simulate_run(other, make_setup({})));
  EXPECT_TRUE(list.items().empty());
}

}  // namespace
}  // namespace feedscope::ui

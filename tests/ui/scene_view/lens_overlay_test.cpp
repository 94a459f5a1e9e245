#include "ui/scene_view/lens_overlay.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QPainter>
#include <QTest>

#include "tests/ui/report/recorded_text.h"
#include "tests/ui/run_fixture.h"
#include "ui/scene_view/side_by_side.h"
#include "ui/window/main_window.h"

namespace feedscope::ui {
namespace {

class LensOverlayTest : public testing::Test {
 protected:
  LensOverlayTest() {
    window.resize(1920, 1200);
    window.show();
    model.show(simulate_run(input, make_setup({})));
  }

  /// Another run, ticked, with its result.
  void add_run(double tolerance) {
    SetupState other = model.runs().items()[0].setup;
    other.set("contour_tolerance_mm", tolerance);
    model.runs().duplicate_as(0, other);
    for (const RunItem& item : model.runs().items()) {
      model.runs().set_result(item.id, make_shown(simulate_run(input, item.setup.setup())));
    }
    model.runs().select(0);
  }

  LoadedProgram input = load_program(std::make_shared<const SourceText>("test.nc", test::small_program));
  Workbench model{shipped_machines(), make_setup({})};
  MainWindow window{model, RenderBackend::software};
  LensOverlay& lens = window.scenes().lens();
};

TEST_F(LensOverlayTest, ShowsItselfWhileTwoRunsAreTicked) {
  EXPECT_FALSE(lens.isVisible());
  add_run(0.005);
  ASSERT_TRUE(lens.isVisible());
  EXPECT_TRUE(lens.action()->isChecked());
  EXPECT_EQ(lens.lens()->runs.size(), 2u);
  model.runs().set_visible(1, false);
  EXPECT_FALSE(lens.isVisible());
  lens.action()->trigger();
  ASSERT_TRUE(lens.isVisible()) << "with one run, too";
  EXPECT_EQ(lens.lens()->runs.size(), 1u);
  lens.action()->trigger();
  model.runs().set_visible(1, true);
  EXPECT_FALSE(lens.isVisible()) << "the user does not want it";
}

TEST_F(LensOverlayTest, FollowsTheCursor) {
  add_run(0.005);
  const feedscope::Run& run = model.shown()->run;
  const BlendRecord blend = run.trajectory->blend(0);
  const PathElement element = run.trajectory->path().element(blend.element);
  model.cursor().set_path_length(element.s + element.length / 2);
  EXPECT_EQ(lens.lens()->centre, blend.corner);
  const double error = lens.lens()->runs.front().error;
  EXPECT_NEAR(error, blend.epsilon * std::cos(blend.turn / 2), 1e-6);
}

TEST_F(LensOverlayTest, LiesInACornerOfTheViewAndGrowsThereByAClick) {
  add_run(0.005);
  for (int i = 0; i < 5; ++i) {
    QApplication::processEvents();  // a frame may choose the other corner
  }
  const QRect canvas = window.scene().canvas().geometry();
  const QRect small = lens.geometry();
  EXPECT_TRUE(canvas.contains(small));
  const bool left = small.center().x() < canvas.center().x();
  EXPECT_LT(left ? small.left() - canvas.left() : canvas.right() - small.right(), 20);
  EXPECT_GT(small.center().y(), canvas.center().y());
  QTest::mouseClick(&lens, Qt::LeftButton);
  EXPECT_GT(lens.width(), small.width());
  EXPECT_TRUE(canvas.contains(lens.geometry()));
  EXPECT_TRUE(lens.geometry().contains(small)) << "a second click finds it where the first did";
  QTest::mouseClick(&lens, Qt::LeftButton);
  EXPECT_EQ(lens.geometry(), small);
  window.resize(1024, 768);
  QApplication::processEvents();
  EXPECT_FALSE(lens.isVisible()) << "it would cover the path";
  lens.action()->trigger();
  ASSERT_TRUE(lens.isVisible());
  EXPECT_TRUE(window.scene().canvas().geometry().contains(lens.geometry()));
}

/// A picture is rarely square, and its title takes a part of it.
TEST_F(LensOverlayTest, SaysHowMuchThePictureStretches) {
  Lens flat;
  flat.along = Vec3::UnitX();
  flat.across = Vec3::UnitY();
  flat.width = 2;
  flat.height = 1;
  flat.deviates = true;
  const auto texts = [&](const QSizeF& size) {
    feedscope::test::RecordedText paper;
    QPainter painter(&paper);
    LensPicture(flat, {}, 1).paint(painter, QRectF(QPointF(), size), QApplication::palette());
    return paper.texts();
  };
  EXPECT_TRUE(texts({400, 223}).contains("across × 1.0")) << texts({400, 223}).join('|').toStdString();
  EXPECT_TRUE(texts({400, 423}).contains("across × 2.0"));
  EXPECT_TRUE(texts({800, 223}).contains("across × 0.50"));
}

}  // namespace
}  // namespace feedscope::ui

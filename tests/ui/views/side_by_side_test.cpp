#include "ui/views/side_by_side.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QComboBox>

#include "tests/ui/run_fixture.h"
#include "ui/main_window.h"

namespace feedscope::ui {
namespace {

class SideBySideTest : public testing::Test {
 protected:
  SideBySideTest() {
    window.resize(1280, 800);
    window.show();
    const LoadedProgram input =
        load_program(std::make_shared<const SourceText>("test.nc", test::small_program));
    model.show(simulate_run(input, make_setup({})));
    SetupState fine = model.runs().items()[0].setup;
    fine.set("contour_tolerance_mm", 0.005);
    model.runs().duplicate_as(0, fine);
    for (const RunItem& item : model.runs().items()) {
      model.runs().set_result(item.id, make_shown(simulate_run(input, item.setup.setup())));
    }
    views.panel_actions()[0]->trigger();
  }

  Workbench model{shipped_machines(), make_setup({})};
  MainWindow window{model, RenderBackend::software};
  SideBySide& views = window.scenes();
};

TEST_F(SideBySideTest, TheOtherRunIsShownAndFollowsTheChoice) {
  ASSERT_NE(views.second(), nullptr);
  EXPECT_EQ(views.choice()->count(), 1);  // the current run is on the left
  const auto other = model.runs().result(0);
  EXPECT_DOUBLE_EQ(views.second()->scene().duration(), other->run.trajectory->duration());
  model.runs().select(0);
  EXPECT_DOUBLE_EQ(views.second()->scene().duration(), model.runs().result(1)->run.trajectory->duration());
}

TEST_F(SideBySideTest, BothTurnAndColourAlike) {
  window.scene().scene().set_standard_view(StandardView::top);
  window.scene().scene().set_colouring(Colouring::cause);
  EXPECT_EQ(views.second()->state().colouring, Colouring::cause);
  EXPECT_EQ(views.second()->state().camera.elevation, window.scene().state().camera.elevation);
  views.second()->scene().orbit({40, -30});
  views.second()->scene().set_exaggeration(50);
  EXPECT_EQ(window.scene().state(), views.second()->state());
}

TEST_F(SideBySideTest, APlacePickedOnTheRightIsThatOfTheProgram) {
  const Trajectory& other = *model.runs().result(0)->run.trajectory;
  const double time = other.duration() / 2;
  emit views.second()->picked(time);
  EXPECT_EQ(model.cursor().state().line, other.state(time).line);
}

TEST_F(SideBySideTest, OffLeavesOneView) {
  views.panel_actions()[0]->trigger();
  EXPECT_EQ(views.second(), nullptr);
  model.runs().select(0);  // nothing follows any more
  window.scene().scene().fit();
}

}  // namespace
}  // namespace feedscope::ui

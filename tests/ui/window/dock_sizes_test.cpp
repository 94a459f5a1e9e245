#include "ui/window/panels/dock_sizes.h"

#include <gtest/gtest.h>

#include <QDockWidget>
#include <QTest>
#include <array>

#include "ui/charts/charts_panel.h"
#include "ui/decide/decide_view.h"
#include "ui/program_text/program_panel.h"
#include "ui/window/main_window.h"
#include "ui/window/menus/help_menu.h"

namespace feedscope::ui {
namespace {

class DockSizesTest : public testing::Test {
 protected:
  DockSizesTest() {
    window.resize(1280, 800);
    window.show();
    settle();
    before = panels();
  }
  static void settle() {
    for (int i = 0; i < 10; ++i) {
      QCoreApplication::processEvents();
    }
  }
  void resize(int width, int height) {
    window.resize(width, height);
    settle();
  }
  /// Sizes of the panels on the left, on the right and below.
  std::array<int, 3> panels() {
    return {window.part<ProgramPanel>().width(), window.part<DecideView>().width(),
            window.part<ChartsPanel>().height()};
  }

  Workbench model{shipped_machines(), make_setup({})};
  MainWindow window{model, RenderBackend::software};
  std::array<int, 3> before{};
};

TEST_F(DockSizesTest, ASmallWindowLeavesRoomForThe3dViewAndPanelsGetTheirsBack) {
  resize(800, 600);
  EXPECT_LE(window.width(), 800);
  EXPECT_LE(window.height(), 600);
  EXPECT_GE(window.scene().canvas().height(), 110);
  EXPECT_GE(window.scene().canvas().width(), 250);
  resize(1900, 800);
  for (const std::size_t i : {0, 2}) {
    EXPECT_NEAR(panels()[i], before[i], 3) << "panel " << i;
  }
  EXPECT_GT(panels()[1], before[1] + 30) << "a wider window has a wider inspector";
  resize(1280, 800);
  EXPECT_EQ(panels(), before);
}

TEST_F(DockSizesTest, WhatIsBelowGrowsWithTheWindowUntilTheUserSizesIt) {
  resize(1920, 1080);
  EXPECT_GT(panels()[2], before[2] + 60);
  EXPECT_GT(window.scene().canvas().height(), panels()[2]) << "most is the 3D view's";
  resize(1280, 800);
  EXPECT_EQ(panels(), before);
  window.resizeDocks({window.findChild<QDockWidget*>("charts")}, {300}, Qt::Vertical);
  settle();
  const int own = panels()[2];
  const QByteArray layout = window.saveState();
  window.restore_layout(layout);
  settle();
  resize(1920, 1080);
  EXPECT_NEAR(panels()[2], own, 3);
}

TEST_F(DockSizesTest, TheDefaultLayoutOfASmallWindowIsThatOfALargeOne) {
  resize(800, 600);
  for (const ListedAction& listed : window.part<HelpMenu>().commands()) {
    if (plain_text(listed.action->text()) == "Default layout") {
      listed.action->trigger();
    }
  }
  settle();
  resize(1280, 800);
  EXPECT_EQ(panels(), before);
}

TEST_F(DockSizesTest, ALayoutIsRestoredAsTheUserHadIt) {
  window.resizeDocks({window.findChild<QDockWidget*>("charts")}, {500}, Qt::Vertical);
  settle();
  const auto large = panels();
  EXPECT_GT(large[2], before[2] + 50);
  const QByteArray layout = window.saveState();
  resize(800, 600);
  window.resize(1280, 800);
  window.restore_layout(layout);
  settle();
  EXPECT_EQ(panels(), large);
  resize(1281, 801);
  EXPECT_NEAR(panels()[2], large[2], 2) << "more than usual, as the user wants it";
}

}  // namespace
}  // namespace feedscope::ui

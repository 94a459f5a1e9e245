#include <gtest/gtest.h>

#include <QLineEdit>
#include <QTabBar>
#include <QTableView>
#include <QTest>
#include <map>

#include "tests/ui/run_fixture.h"
#include "ui/window/main_window.h"
#include "ui/window/menus/help_menu.h"

namespace feedscope::ui {
namespace {

class WindowCommandsTest : public testing::Test {
 protected:
  WindowCommandsTest() {
    window.resize(1280, 800);
    window.show();
    model.show(test::simulate_text(test::small_program));
    QCoreApplication::processEvents();
  }

  Workbench model{shipped_machines(), make_setup({})};
  MainWindow window{model, RenderBackend::software};
};

TEST_F(WindowCommandsTest, EverydayWordsFindTheirCommands) {
  CommandPalette palette(&window);
  for (const auto& [words, name] : std::map<const char*, const char*>{{"report", "Report"},
                                                                      {"print", "Report"},
                                                                      {"export", "Report"},
                                                                      {"picture", "3D view"},
                                                                      {"screenshot", "3D view"},
                                                                      {"help", "Handbook"},
                                                                      {"manual", "Handbook"},
                                                                      {"spreadsheet", "Save the runs as CSV"},
                                                                      {"hide rapids", "Rapids"},
                                                                      {"about", "About Feedscope"}}) {
    palette.ask(window.part<HelpMenu>().commands());
    QTest::keyClicks(palette.input(), words);
    const QAbstractItemModel& found = *palette.list()->model();
    bool is_there = false;
    for (int row = 0; row < std::min(5, found.rowCount()); ++row) {
      is_there = is_there || found.index(row, ActionTable::name).data().toString().endsWith(name);
    }
    EXPECT_TRUE(is_there) << words;
  }
}

TEST_F(WindowCommandsTest, TabsOfThePanelsAreReadableAsTheyOpen) {
  for (const QTabBar* tabs : window.findChildren<QTabBar*>(Qt::FindDirectChildrenOnly)) {
    if (tabs->isVisible()) {
      const QRect last = tabs->tabRect(tabs->count() - 1);
      EXPECT_LE(last.right(), tabs->width()) << tabs->tabText(0).toStdString();
      for (int i = 0; i < tabs->count(); ++i) {
        EXPECT_FALSE(tabs->tabText(i).contains(QChar(0x2026)));
      }
    }
  }
}

}  // namespace
}  // namespace feedscope::ui

#include "ui/window/menus/command_palette.h"

#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QAction>
#include <QDockWidget>
#include <QLineEdit>
#include <QMainWindow>
#include <QTableView>
#include <QTest>
#include <array>

#include "ui/shared/panel_action.h"

namespace feedscope::ui {
namespace {

class CommandPaletteTest : public testing::Test {
 protected:
  CommandPaletteTest() {
    window.resize(800, 600);
    window.show();
    for (QAction* action : {&top, &fit, &off}) {
      QObject::connect(action, &QAction::triggered, [this, action] { triggered = action; });
    }
    fit.setShortcut(QKeySequence("Ctrl+0"));
    off.setEnabled(false);
  }
  QList<ListedAction> actions() { return {{"View", &top}, {"View › Charts", &fit}, {"Runs", &off}}; }

  QWidget window;
  CommandPalette palette{&window};
  QAction top{"&Top"};
  QAction fit{"&Fit charts …"};
  QAction off{"Remove"};
  QAction* triggered = nullptr;
};

TEST_F(CommandPaletteTest, ListsWhatCanBeDone) {
  palette.ask(actions());
  EXPECT_EQ(palette.list()->model()->rowCount(), 2);
  EXPECT_EQ(palette.list()->model()->index(1, ActionTable::name).data().toString(), "Fit charts");
  EXPECT_EQ(palette.list()->model()->index(1, ActionTable::keys).data().toString(), "Ctrl+0");
}

TEST_F(CommandPaletteTest, AnyWordsInAnyOrderFindACommandAndEnterRunsIt) {
  palette.ask(actions());
  QTest::keyClicks(palette.input(), "char vi");
  ASSERT_EQ(palette.list()->model()->rowCount(), 1);
  QTest::keyClick(palette.input(), Qt::Key_Return);
  EXPECT_EQ(triggered, &fit);
  EXPECT_FALSE(palette.isVisible());
}

TEST_F(CommandPaletteTest, EverydayWordsFindACommandAndItsNameComesFirst) {
  fit.setToolTip("Shows it all from the top");
  set_everyday_words(&top, "above bird");
  palette.ask(actions());
  QTest::keyClicks(palette.input(), "bird");
  ASSERT_EQ(palette.list()->model()->rowCount(), 1);
  palette.ask({{"Charts", &fit}, {"View", &top}});
  QTest::keyClicks(palette.input(), "top");
  ASSERT_EQ(palette.list()->model()->rowCount(), 2);
  QTest::keyClick(palette.input(), Qt::Key_Return);
  EXPECT_EQ(triggered, &top) << "not what only says so in its tip";
}

TEST_F(CommandPaletteTest, ArrowKeysChoose) {
  palette.ask(actions());
  QTest::keyClick(palette.input(), Qt::Key_Down);
  QTest::keyClick(palette.input(), Qt::Key_Down);  // no further than the last
  QTest::keyClick(palette.input(), Qt::Key_Return);
  EXPECT_EQ(triggered, &fit);
}

TEST_F(CommandPaletteTest, WordsThatFindNothingRunNothing) {
  palette.ask(actions());
  QTest::keyClicks(palette.input(), "(.*");
  EXPECT_EQ(palette.list()->model()->rowCount(), 0);
  QTest::keyClick(palette.input(), Qt::Key_Return);
  EXPECT_EQ(triggered, nullptr);
}

/// Its entry in a menu closes a panel that is open; who looks for it by name wants to see it.
TEST(CommandPalette, APanelThatIsFoundIsShown) {
  QMainWindow window;
  std::array<QDockWidget*, 2> panels{new QDockWidget("One", &window), new QDockWidget("Two", &window)};
  for (QDockWidget* panel : panels) {
    window.addDockWidget(Qt::BottomDockWidgetArea, panel);
  }
  window.tabifyDockWidget(panels[0], panels[1]);
  window.resize(800, 600);
  window.show();
  CommandPalette palette(&window);
  for (const int turn : {0, 1, 0, 0}) {
    QDockWidget* panel = panels[static_cast<std::size_t>(turn)];
    palette.ask({{"View", panel->toggleViewAction()}});
    QTest::keyClick(palette.input(), Qt::Key_Return);
    QCoreApplication::processEvents();
    EXPECT_TRUE(panel->isVisible());
    EXPECT_FALSE(panel->visibleRegion().isEmpty()) << "in front of the others";
  }
  panels[1]->close();
  palette.ask({{"View", panels[1]->toggleViewAction()}});
  QTest::keyClick(palette.input(), Qt::Key_Return);
  EXPECT_TRUE(panels[1]->isVisible());
}

TEST(ActionTable, IsASoundItemModel) {
  ActionTable table;
  const QAbstractItemModelTester tester(&table, QAbstractItemModelTester::FailureReportingMode::Fatal);
  QAction action("One");
  table.set_actions({{"Menu", &action}});
  table.set_actions({});
}

TEST(ActionTable, AMenuTextLosesItsMnemonicAndDots) {
  EXPECT_EQ(plain_text("Save && &close …"), "Save & close");
}

TEST(KeyListTest, OpensOverTheWindowAndEscClosesIt) {
  QWidget window;
  window.setGeometry(300, 200, 900, 700);
  window.show();
  QAction cancel("Cancel");
  cancel.setShortcut(Qt::Key_Escape);
  bool cancelled = false;
  QObject::connect(&cancel, &QAction::triggered, [&] { cancelled = true; });
  window.addAction(&cancel);
  KeyList list(&window);
  list.show_keys({{"Run", &cancel}});
  EXPECT_TRUE(window.geometry().contains(list.geometry().center()));
  EXPECT_TRUE(window.geometry().adjusted(-50, -50, 50, 50).contains(list.geometry()));
  auto* table = list.findChild<QTableView*>();
  table->setFocus();
  QTest::keyClick(table, Qt::Key_Escape);
  EXPECT_FALSE(list.isVisible());
  EXPECT_FALSE(cancelled) << "Esc was for the list";
}

}  // namespace
}  // namespace feedscope::ui

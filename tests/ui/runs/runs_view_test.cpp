#include "ui/runs/runs_view.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QAction>
#include <QClipboard>
#include <QGuiApplication>
#include <QLineEdit>
#include <QLocale>
#include <QTableView>
#include <QTest>

#include "tests/ui/run_fixture.h"

namespace feedscope::ui {
namespace {

class RunsViewTest : public testing::Test {
 protected:
  RunsViewTest() {
    QLocale::setDefault(QLocale::c());
    view.resize(900, 240);
    view.show();
  }
  void simulate() {
    const LoadedProgram input =
        load_program(std::make_shared<const SourceText>("test.nc", test::small_program));
    for (const RunItem& item : runs.items()) {
      runs.set_result(item.id, make_shown(simulate_run(input, item.setup.setup())));
    }
  }
  QPoint middle_of(int row, int column) {
    return view.table()->visualRect(view.results().index(row, column)).center();
  }

  RunList runs{make_setup({})};
  RunsView view{runs};
};

TEST_F(RunsViewTest, AClickOnARowMakesItTheCurrentRun) {
  runs.duplicate(0);
  QTest::mouseClick(view.table()->viewport(), Qt::LeftButton, {}, middle_of(0, RunTable::machine));
  EXPECT_EQ(runs.current(), 0U);
  runs.select(1);
  EXPECT_EQ(view.table()->currentIndex().row(), 1);
}

TEST_F(RunsViewTest, ARunIsRenamedByACommandAndTheKeyboard) {
  runs.duplicate(0);
  view.panel_actions()[1]->trigger();
  auto* editor = view.table()->viewport()->findChild<QLineEdit*>();
  ASSERT_NE(editor, nullptr);
  QTest::keyClick(editor, Qt::Key_A, Qt::ControlModifier);
  QTest::keyClicks(editor, "finishing");
  QTest::keyClick(editor, Qt::Key_Return);
  QCoreApplication::processEvents();
  EXPECT_EQ(runs.items()[1].name, "finishing");
  EXPECT_EQ(runs.items()[0].name, "");
}

TEST_F(RunsViewTest, CopyTakesTheWholeTable) {
  runs.duplicate(0);
  runs.rename(0, "one\ttwo");
  simulate();
  view.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&view));
  view.table()->setFocus();
  QTest::keyClick(view.table(), Qt::Key_C, Qt::ControlModifier);
  const QStringList lines = QGuiApplication::clipboard()->text().split('\n', Qt::SkipEmptyParts);
  ASSERT_EQ(lines.size(), 3);
  for (const QString& line : lines) {
    EXPECT_EQ(line.count('\t'), RunTable::columns - 1) << line.toStdString();
  }
  EXPECT_TRUE(lines[0].startsWith("Run\tMachine"));
  EXPECT_TRUE(lines[1].startsWith("A one two\tSpinner"));
}

TEST_F(RunsViewTest, CommandsActOnTheCurrentRun) {
  const QList<QAction*> actions = view.panel_actions();
  actions[0]->trigger();  // duplicate
  ASSERT_EQ(runs.items().size(), 2U);
  const int copy = runs.current_item().id;
  actions[3]->trigger();  // up
  EXPECT_EQ(runs.row_of(copy), 0U);
  actions[4]->trigger();  // down
  EXPECT_EQ(runs.row_of(copy), 1U);
  actions[2]->trigger();  // remove
  EXPECT_EQ(runs.items().size(), 1U);
}

TEST_F(RunsViewTest, ANameIsTypedIntoTheTable) {
  view.table()->edit(view.results().index(0, RunTable::name));
  auto* editor = view.table()->viewport()->findChild<QLineEdit*>();
  ASSERT_NE(editor, nullptr);
  QTest::keyClick(editor, Qt::Key_A, Qt::ControlModifier);
  QTest::keyClicks(editor, "roughing");
  QTest::keyClick(editor, Qt::Key_Return);
  QCoreApplication::processEvents();  // the delegate commits with the next turn of the event loop
  EXPECT_EQ(runs.items()[0].name, "roughing");
}

TEST_F(RunsViewTest, TheTableIsSavedWithTheNamesOfItsRuns) {
  EXPECT_EQ(view.csv(), "") << "nothing is simulated";
  runs.duplicate(0);
  runs.rename(1, "finer, in steel");
  simulate();
  const QStringList lines = QString::fromStdString(view.csv()).split('\n', Qt::SkipEmptyParts);
  ASSERT_EQ(lines.size(), 3);
  EXPECT_TRUE(lines[0].startsWith("machine,model,tolerance_mm,cycle_time_s,"));
  EXPECT_TRUE(lines[0].endsWith(",run"));
  EXPECT_TRUE(lines[2].endsWith(",\"finer, in steel\""));
}

}  // namespace
}  // namespace feedscope::ui

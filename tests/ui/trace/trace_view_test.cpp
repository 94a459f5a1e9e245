#include "ui/trace/trace_view.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QAbstractItemModel>
#include <QAction>
#include <QSignalSpy>
#include <QTest>
#include <QTreeView>

#include "tests/ui/patience.h"
#include "tests/ui/run_fixture.h"
#include "tests/ui/trace_fixture.h"
#include "ui/language/texts.h"
#include "ui/runs/run_table.h"
#include "ui/trace/trace_import_dialog.h"

namespace feedscope::ui {
namespace {

using testing::HasSubstr;

class TraceViewTest : public testing::Test {
 protected:
  TraceViewTest() {
    QLocale::setDefault(QLocale::c());
    view.resize(1200, 300);
    view.show();
    table.set_traces(model.traces());
  }
  bool wait() {
    return QTest::qWaitFor([this] { return !model.busy() && !view.busy(); }, patience);
  }
  static QString cell(QTreeView& list, int row, int column) {
    return list.model()->index(row, column).data().toString();
  }
  QString run_cell(int row, RunTable::Column column) { return table.index(row, column).data().toString(); }

  const feedscope::Run run = test::simulate_text(test::small_program);
  const feedscope::Run slow = [] {
    const feedscope::Setup setup = make_setup({"", "essid", 0.001, {}});
    return simulate_run(load_program(std::make_shared<const SourceText>("test.nc", test::small_program)),
                        setup);
  }();
  const test::WrittenFiles files;
  Workbench model{shipped_machines(), make_setup({})};
  TraceView view{model};
  RunTable table{model.runs()};
  QSignalSpy chosen{&view, &TraceView::place_chosen};
  QSignalSpy attention{&view, &TraceView::attention_wanted};
  QSignalSpy failed{&view, &TraceView::failed};
};

TEST_F(TraceViewTest, SaysHowWellTheRunAgrees) {
  model.show(run);
  view.open(files.write("machine.csv", test::trace_table(slow)));
  EXPECT_EQ(attention.size(), 1);
  ASSERT_TRUE(wait());
  EXPECT_THAT(view.verdict().toStdString(), HasSubstr("faster than the control"));
  EXPECT_EQ(cell(view.figures(), 0, 0), "Cycle time");
  EXPECT_THAT(cell(view.figures(), 0, 3).toStdString(), testing::StartsWith("−"));
  ASSERT_GT(view.places().model()->rowCount(), 0);
  EXPECT_EQ(view.corners().model()->rowCount(), 3) << "the arc is left at a corner too";
}

TEST_F(TraceViewTest, AClickGoesToAPlaceOfTheRun) {
  model.show(run);
  view.open(files.write("machine.csv", test::trace_table(slow)));
  ASSERT_TRUE(wait());
  for (QTreeView* list : {&view.places(), &view.corners()}) {
    chosen.clear();
    const QModelIndex index = list->model()->index(0, 0);
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualRect(index).center());
    ASSERT_EQ(chosen.size(), 1);
    const double time = chosen[0][0].toDouble();
    EXPECT_LT(chosen[0][1].toDouble(), time);
    EXPECT_GT(chosen[0][2].toDouble(), time);
    EXPECT_EQ(model.cursor().state().time, time);
    EXPECT_NEAR(model.cursor().state().line, cell(*list, 0, 0).toInt(), 1);
  }
}

TEST_F(TraceViewTest, TheTraceIsOneMoreRowOfTheRuns) {
  model.show(run);
  EXPECT_EQ(table.rowCount(), 1);
  view.open(files.write("machine.csv", test::trace_table(slow)));
  ASSERT_TRUE(wait());
  ASSERT_EQ(table.rowCount(), 2);
  EXPECT_EQ(table.trace_of(0), std::nullopt);
  EXPECT_EQ(table.trace_of(1), 0U);
  EXPECT_EQ(run_cell(1, RunTable::name), "machine.csv");
  EXPECT_EQ(run_cell(1, RunTable::cycle_time), clock_text(slow.summary.cycle_time));
  EXPECT_THAT(run_cell(1, RunTable::difference).toStdString(), testing::StartsWith("+"));
  EXPECT_TRUE(table.setData(table.index(1, RunTable::name), "before service", Qt::EditRole));
  EXPECT_EQ(model.traces().items()[0].name, "before service");
  EXPECT_TRUE(table.setData(table.index(1, RunTable::name), Qt::Unchecked, Qt::CheckStateRole));
  EXPECT_FALSE(model.traces().items()[0].visible);
  EXPECT_EQ(table.fastest(), std::vector<std::size_t>{0}) << "a trace is no run to choose";
}

TEST_F(TraceViewTest, APartOfTheProgramHasNoCycleTime) {
  model.show(run);
  std::string text = test::trace_table(slow, 0);
  text.resize(text.rfind('\n', text.size() / 3) + 1);
  view.open(files.write("part.csv", text));
  ASSERT_TRUE(wait());
  EXPECT_EQ(run_cell(1, RunTable::cycle_time), "–");
  EXPECT_EQ(cell(view.figures(), 0, 0), "Time of the part compared");
  EXPECT_THAT(view.verdict().toStdString(), HasSubstr("The trace covers "));
}

TEST_F(TraceViewTest, SaysOnceThatATraceIsOfAnotherProgram) {
  QSignalSpy noted(&view, &TraceView::noted);
  model.show(run);
  std::string text = "time [s],x [mm],y [mm],z [mm]\n";
  const MotionRecord record = record_of(*run.trajectory, 0.02);
  const std::size_t same = record.time.size() / 8;
  for (std::size_t i = 0; i < record.time.size(); ++i) {  // begins as the program, then runs across it
    const Vec3 off = record.place[i] - record.place[same];
    const Vec3 place = i < same ? record.place[i]
                                : record.place[same] + Vec3(off.y() - off.x() / 3, off.x() + off.y() / 4, 0);
    text += fmt::format("{:.6f},{:.5f},{:.5f},{:.5f}\n", record.time[i], place.x(), place.y(), place.z());
  }
  view.open(files.write("other.csv", text));
  ASSERT_TRUE(wait());
  EXPECT_THAT(view.verdict().toStdString(), HasSubstr("The trace does not belong to this program: "));
  ASSERT_GE(noted.size(), 2);
  EXPECT_THAT(noted[0][1].toString().toStdString(),
              testing::StartsWith("Trace other.csv: The trace does not belong to this program: "));
  EXPECT_THAT(noted[0][1].toString().toStdString(), HasSubstr(". Open the program that was recorded"));
  EXPECT_THAT(noted.back()[1].toString().toStdString(), HasSubstr("One sample each 20 ms"));
  const auto said = noted.size();
  model.show(slow);  // compared once more
  ASSERT_TRUE(wait());
  EXPECT_EQ(noted.size(), said);
}

TEST_F(TraceViewTest, AsksForTheColumnsOfATableThatDoesNotSayThem) {
  model.show(run);
  std::string text = test::trace_table(run);
  text = "a,b,c,d" + text.substr(text.find('\n'));
  const auto file = files.write("strange.csv", text);
  EXPECT_TRUE(TraceView::is_trace(file));
  view.open(file);
  auto* dialog = view.findChild<TraceImportDialog*>();
  ASSERT_NE(dialog, nullptr);
  EXPECT_TRUE(model.traces().items().empty());
  dialog->reject();
}

TEST_F(TraceViewTest, WantsTheProgramFirst) {
  view.open(files.write("machine.csv", test::trace_table(run)));
  ASSERT_EQ(failed.size(), 1);
  EXPECT_THAT(failed[0][0].toString().toStdString(), HasSubstr("open the program"));
  EXPECT_TRUE(model.traces().items().empty());
  EXPECT_FALSE(TraceView::is_trace(files.write("part.nc", test::small_program)));
}

TEST_F(TraceViewTest, CommandsThatNeedATraceWaitForOne) {
  const QList<QAction*> actions = view.panel_actions();
  EXPECT_TRUE(actions[0]->isEnabled());
  EXPECT_FALSE(actions.last()->isEnabled());
  model.show(run);
  view.open(files.write("machine.csv", test::trace_table(run)));
  ASSERT_TRUE(wait());
  EXPECT_TRUE(actions.last()->isEnabled());
  actions.last()->trigger();
  EXPECT_TRUE(model.traces().items().empty());
  EXPECT_EQ(table.rowCount(), 1);
}

}  // namespace
}  // namespace feedscope::ui

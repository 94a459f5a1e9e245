#include "ui/runs/run_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QLocale>

#include "tests/ui/locale_in_force.h"
#include "tests/ui/run_fixture.h"

namespace feedscope::ui {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

/// Three runs of one program with a contour tolerance of 0.1, 0.02 and 0.5 mm.
class RunTableTest : public testing::Test {
 protected:
  RunTableTest() {
    QLocale::setDefault(QLocale::c());
    for (const double tolerance : {0.02, 0.5}) {
      SetupState setup = runs.items()[0].setup;
      setup.set("contour_tolerance_mm", tolerance);
      runs.duplicate_as(runs.items().size() - 1, setup);
    }
  }
  void simulate() {
    const LoadedProgram input =
        load_program(std::make_shared<const SourceText>("test.nc", test::small_program));
    for (const RunItem& item : runs.items()) {
      runs.set_result(item.id, make_shown(simulate_run(input, item.setup.setup())));
    }
  }
  std::string text(int row, int column) const {
    return table.index(row, column).data().toString().toStdString();
  }

  RunList runs{make_setup({})};
  RunTable table{runs};
};

TEST_F(RunTableTest, IsASoundItemModel) {
  const QAbstractItemModelTester tester(&table, QAbstractItemModelTester::FailureReportingMode::Fatal);
  simulate();
  runs.duplicate(0);
  runs.move(0, 2);
  runs.remove(1);
  runs.history().undo();
  table.set_error_bound(0.05);
}

TEST_F(RunTableTest, AResultThatIsNotThereYetIsADot) {
  EXPECT_EQ(text(0, RunTable::cycle_time), "…");
  EXPECT_FALSE(table.best().has_value());
}

TEST_F(RunTableTest, TheFastestRunIsMarkedAndTheOthersSayHowMuchSlowerTheyAre) {
  simulate();
  EXPECT_EQ(table.best(), 2U);
  EXPECT_THAT(text(2, RunTable::cycle_time), StartsWith("★"));
  EXPECT_THAT(text(1, RunTable::difference), StartsWith("+"));
  EXPECT_EQ(text(2, RunTable::difference), "");
}

TEST_F(RunTableTest, ARunAboveTheErrorBoundDoesNotCompete) {
  simulate();
  table.set_error_bound(0.15);
  EXPECT_EQ(table.best(), 0U);
  EXPECT_THAT(table.index(2, 0).data(Qt::ToolTipRole).toString().toStdString(), HasSubstr("bound of 150.0"));
  table.set_error_bound(1e-6);
  EXPECT_FALSE(table.best().has_value());
}

TEST_F(RunTableTest, NameAndVisibilityAreEditedInPlace) {
  ASSERT_TRUE(table.setData(table.index(1, 0), "fine"));
  ASSERT_TRUE(table.setData(table.index(2, 0), Qt::Unchecked, Qt::CheckStateRole));
  EXPECT_EQ(runs.items()[1].name, "fine");
  EXPECT_FALSE(runs.items()[2].visible);
  EXPECT_FALSE(table.setData(table.index(1, RunTable::cycle_time), "1"));
}

TEST_F(RunTableTest, TheToleranceIsTheOneInForce) {
  PathControl fine;
  fine.contour_tolerance = 0.03;
  runs.set_feed_controls({fine});
  EXPECT_EQ(text(0, RunTable::tolerance), "0.03");
  EXPECT_THAT(table.index(0, 0).data(Qt::ToolTipRole).toString().toStdString(),
              HasSubstr("from the program"));
  SetupState off = runs.items()[1].setup;
  off.set("program_tolerance", std::string("off"));
  runs.set_setup(1, off, "off");
  EXPECT_EQ(text(1, RunTable::tolerance), "0.02");
}

TEST_F(RunTableTest, NumbersFollowTheLocale) {
  const test::LocaleInForce locale(QLocale(QLocale::German));
  EXPECT_EQ(text(1, RunTable::tolerance), "0,02");
}

}  // namespace
}  // namespace feedscope::ui

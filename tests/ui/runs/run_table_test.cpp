#include "ui/runs/run_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QLocale>

#include "tests/ui/locale_in_force.h"
#include "tests/ui/run_fixture.h"
#include "ui/workbench/decision.h"

namespace feedscope::ui {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
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
  runs.set_error_bound(0.05);
}

TEST_F(RunTableTest, AResultThatIsNotThereYetIsADot) {
  EXPECT_EQ(text(0, RunTable::cycle_time), "…");
  EXPECT_THAT(table.fastest(), IsEmpty());
}

TEST_F(RunTableTest, TheRunToTakeIsMarkedAndTheOthersSayHowMuchSlowerTheyAre) {
  simulate();
  EXPECT_THAT(table.fastest(), ElementsAre(2U));
  const auto taken = recommended(runs);
  ASSERT_TRUE(taken.has_value());
  for (int row = 0; row < 3; ++row) {
    EXPECT_EQ(text(row, RunTable::cycle_time).starts_with("★"), row == static_cast<int>(taken->run)) << row;
  }
  EXPECT_THAT(text(1, RunTable::difference), StartsWith("+"));
  EXPECT_EQ(text(2, RunTable::difference), "");
}

TEST_F(RunTableTest, AllThatAreEquallyFastHaveNoDifference) {
  runs.duplicate(2);
  simulate();
  EXPECT_THAT(table.fastest(), ElementsAre(2U, 3U));
  for (const int row : {2, 3}) {
    EXPECT_EQ(text(row, RunTable::difference), "");
  }
}

TEST_F(RunTableTest, ARunAboveTheErrorBoundDoesNotCompete) {
  simulate();
  runs.set_error_bound(0.15);
  EXPECT_THAT(table.fastest(), ElementsAre(0U));
  EXPECT_THAT(table.index(2, 0).data(Qt::ToolTipRole).toString().toStdString(), HasSubstr("bound of 150.0"));
  runs.set_error_bound(1e-6);
  EXPECT_THAT(table.fastest(), IsEmpty());
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
  const test::LocaleInForce locale{QLocale(QLocale::German)};
  EXPECT_EQ(text(1, RunTable::tolerance), "0,02");
}

/// The same program on two models of a machine, of which grbl takes none or not all of its lines.
class RefusedRunTest : public testing::Test {
 protected:
  RefusedRunTest() {
    QLocale::setDefault(QLocale::c());
    runs.duplicate_as(0, SetupState(make_setup({"grbl-router", "cam", {}, {}})));
  }
  void simulate(const std::string& program) {
    const LoadedProgram input = load_program(std::make_shared<const SourceText>("part.nc", program));
    for (const RunItem& item : runs.items()) {
      runs.set_result(item.id, make_shown(simulate_run(input, item.setup.setup())));
    }
  }
  std::string text(int row, int column) const {
    return table.index(row, column).data().toString().toStdString();
  }
  std::string tip(int row) const {
    return table.index(row, 0).data(Qt::ToolTipRole).toString().toStdString();
  }

  RunList runs{make_setup({"grbl-router", "grbl", {}, {}})};
  RunTable table{runs};
};

TEST_F(RefusedRunTest, HasNoFiguresAndDoesNotCompete) {
  simulate("G21 G90\nG0 X10\nG1 X100\nG1 Y100\n");  // grbl wants a feed
  EXPECT_EQ(text(0, RunTable::cycle_time), "refused");
  for (const int column : {RunTable::difference, RunTable::mean_feed, RunTable::contour_error}) {
    EXPECT_EQ(text(0, column), "–");
    EXPECT_NE(text(1, column), "–");
  }
  EXPECT_THAT(table.fastest(), ElementsAre(1U));
  EXPECT_THAT(tip(0), AllOf(HasSubstr("The control refuses the program"), HasSubstr("are not run: 2.")));
}

TEST_F(RefusedRunTest, WhatIsNotRunTakesNoTime) {
  simulate("G21 G90\nG1 X10 F1000\nG1 X200 H1\nX10\n");
  EXPECT_LT(runs.result(0)->run.summary.cycle_time, runs.result(1)->run.summary.cycle_time);
  EXPECT_THAT(table.fastest(), ElementsAre(1U));
  EXPECT_EQ(text(0, RunTable::difference), "–");
  EXPECT_THAT(tip(0), AllOf(HasSubstr("are not run: 1."), Not(HasSubstr("refuses the program"))));
}

}  // namespace
}  // namespace feedscope::ui

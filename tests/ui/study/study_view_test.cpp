#include "ui/study/study_view.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QCheckBox>
#include <QComboBox>
#include <QLocale>
#include <QTableView>
#include <QTest>

#include "tests/ui/patience.h"
#include "tests/ui/run_fixture.h"
#include "tests/ui/trace_fixture.h"
#include "ui/fields/number_box.h"
#include "ui/fields/whole_number_box.h"
#include "ui/study/study_curves.h"
#include "ui/study/study_table.h"

namespace feedscope::ui {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class StudyViewTest : public testing::Test {
 protected:
  StudyViewTest() {
    QLocale::setDefault(QLocale::c());
    view.resize(900, 400);
    view.show();
  }
  void open() {
    const LoadedProgram input =
        load_program(std::make_shared<const SourceText>("test.nc", feedscope::test::small_program));
    model.show(simulate_run(input, make_setup({})));
  }
  void study(const char* key, double from, double to, int count) {
    view.key()->setCurrentIndex(view.key()->findData(QString::fromLatin1(key)));
    view.from()->setValue(from);
    view.to()->setValue(to);
    view.count()->setValue(count);
    view.run();
    ASSERT_TRUE(QTest::qWaitFor([this] { return !view.busy(); }, patience));
  }

  Workbench model{shipped_machines(), make_setup({})};
  StudyView view{model};
};

TEST_F(StudyViewTest, TheResultsAreThoseOfSimulatingEachValue) {
  const QAbstractItemModelTester tester(view.table()->model(),
                                        QAbstractItemModelTester::FailureReportingMode::Fatal);
  open();
  study("tolerance", 0.01, 0.04, 3);
  ASSERT_EQ(view.chart()->study().curves.size(), 1U);
  const StudyCurve& curve = view.chart()->study().curves[0];
  ASSERT_EQ(curve.points.size(), 3U);
  for (const StudyPoint& point : curve.points) {
    SetupRequest request;
    request.tolerance = point.value;
    const Summary alone = simulate_run(model.shown_program().input, make_setup(request)).summary;
    EXPECT_EQ(point.time, alone.cycle_time) << point.value;
    EXPECT_EQ(point.error, alone.max_contour_error) << point.value;
  }
  EXPECT_EQ(view.table()->model()->rowCount(), 3);
  EXPECT_THAT(view.verdict().toStdString(), HasSubstr("Fastest within 10.0 µm: Contour tolerance"));
}

TEST_F(StudyViewTest, MarksAllValuesThatAreEquallyFastAndNoneWhereAllAre) {
  open();
  view.findChildren<QCheckBox*>().last()->setChecked(false);  // no bound of the error
  study("Z.velocity", 10, 20, 3);                             // nothing moves along Z
  EXPECT_THAT(view.chart()->study().curves[0].best, IsEmpty());
  EXPECT_THAT(view.verdict().toStdString(), HasSubstr("makes no difference to the cycle time"));
  const auto starred = [this] {
    int rows = 0;
    const QAbstractItemModel& rows_of = *view.table()->model();
    for (int row = 0; row < rows_of.rowCount(); ++row) {
      rows += rows_of.index(row, StudyTable::cycle_time).data().toString().startsWith("★") ? 1 : 0;
    }
    return rows;
  };
  EXPECT_EQ(starred(), 0);
  study("X.velocity", 0.5, 100, 3);  // no feed is above 50 m/min
  EXPECT_THAT(view.chart()->study().curves[0].best, ElementsAre(1U, 2U));
  EXPECT_EQ(starred(), 2);
}

TEST_F(StudyViewTest, ValuesAreOnesThatPeopleCanSetAndStayApart) {
  open();
  for (const int count : {3, 12, 40}) {
    study("tolerance", 0.005, 0.1, count);
    const std::vector<StudyPoint>& points = view.chart()->study().curves.at(0).points;
    ASSERT_EQ(points.size(), static_cast<std::size_t>(count));
    for (std::size_t i = 0; i < points.size(); ++i) {
      const int digits = count > 12 ? 3 : 2;
      EXPECT_EQ(points[i].value, QString::number(points[i].value, 'g', digits).toDouble());
      EXPECT_TRUE(i == 0 || points[i].value > points[i - 1].value) << points[i].value;
    }
    EXPECT_EQ(points.front().value, 0.005);
    EXPECT_EQ(points.back().value, 0.1);
  }
}

/// An axis from 0 showed times that differ by percents as one level line.
TEST_F(StudyViewTest, DifferencesOfTheCycleTimeAreSeen) {
  EXPECT_EQ(view.chart()->height_of_times(), 0) << "nothing to be seen yet";
  open();
  study("tolerance", 0.005, 0.1, 6);
  EXPECT_GT(view.chart()->height_of_times(), 0.5);
}

TEST_F(StudyViewTest, WhatWasRecordedOfTheProgramIsDrawnAcross) {
  open();
  study("tolerance", 0.01, 0.04, 3);
  EXPECT_TRUE(view.chart()->study().recorded.empty());
  const feedscope::test::WrittenFiles files;
  model.traces().add(files.write(
      "scope.csv", feedscope::test::trace_table(simulate_run(model.shown_program().input, make_setup({})))));
  ASSERT_TRUE(QTest::qWaitFor([this] { return !model.traces().busy(); }, patience));
  ASSERT_EQ(view.chart()->study().recorded.size(), 1U);
  const RecordedTime recorded = view.chart()->study().recorded[0];
  EXPECT_EQ(recorded.name, "scope.csv");
  EXPECT_NEAR(recorded.time, simulate_run(model.shown_program().input, make_setup({})).summary.cycle_time,
              5e-3);
  EXPECT_LT(recorded.error, 0.2);
  EXPECT_FALSE(view.chart()->grab().isNull());
  model.traces().set_visible(0, false);
  EXPECT_TRUE(view.chart()->study().recorded.empty());
  model.traces().set_visible(0, true);
  study("tolerance", 0.01, 0.05, 3);
  EXPECT_EQ(view.chart()->study().recorded.size(), 1U) << "a new study keeps it";
}

TEST_F(StudyViewTest, AnyValueBecomesARun) {
  open();
  study("X.jerk", 5, 20, 3);
  view.make_run(2);
  EXPECT_EQ(model.runs().items().size(), 2U);
  EXPECT_EQ(std::get<double>(model.setup().state().value("X.jerk")), 20);
  view.make_run(7);  // there is no such row
  EXPECT_EQ(model.runs().items().size(), 2U);
}

TEST_F(StudyViewTest, WithoutAProgramOrWithAWrongRangeItSaysSo) {
  view.run();
  EXPECT_FALSE(view.busy());
  open();
  view.from()->setValue(0);  // no logarithm
  view.run();
  EXPECT_FALSE(view.busy());
  EXPECT_EQ(view.table()->model()->rowCount(), 0);
}

TEST_F(StudyViewTest, KeysFollowTheModelAndHaveRangesOfTheirOwn) {
  EXPECT_GE(view.key()->findData("alpha"), 0);
  model.choose_model("cam");
  EXPECT_LT(view.key()->findData("alpha"), 0);
  view.key()->setCurrentIndex(view.key()->findData("X.jerk"));
  EXPECT_LT(view.from()->value(), view.to()->value());
}

TEST_F(StudyViewTest, ASettingWithoutAValueIsOfferedOnceItHasOne) {
  EXPECT_LT(view.key()->findData("tool_change_time_s"), 0);
  model.setup().set("tool_change_time_s", 4.0);
  model.choose_model("cam");
  EXPECT_GE(view.key()->findData("tool_change_time_s"), 0);
}

/// The first of two runs goes where the machine cannot, in half of the time.
TEST(StudyTableTest, ARunOutOfReachIsMarkedAndNeverTheFastest) {
  const auto study = std::make_shared<Study>();
  study->sweeps = {parse_sweep("part_angle_x_deg=1;2")};
  for (const double value : study->sweeps.front().values) {
    StudyRun& run = study->runs.emplace_back();
    run.setup = make_setup({});
    run.summary.cycle_time = value;
    run.swept = {value};
  }
  study->runs.front().out_of_reach = true;
  StudyTable table;
  table.set_study(study);
  const auto time = [&](int row) {
    return table.data(table.index(row, StudyTable::cycle_time)).toString().toStdString();
  };
  EXPECT_EQ(time(0), "out of reach");
  EXPECT_THAT(time(1), testing::StartsWith("★"));
  const StudyCurves curves = study_curves(*study);
  ASSERT_EQ(curves.curves.size(), 1U);
  ASSERT_EQ(curves.curves[0].points.size(), 1U);
  EXPECT_EQ(curves.curves[0].points[0].value, 2);
  EXPECT_THAT(curves.curves[0].best, ElementsAre(0U));
}

TEST_F(StudyViewTest, EndingWhileItRunsIsClean) {
  open();
  view.count()->setValue(500);
  view.run();
  EXPECT_TRUE(view.busy());
}

}  // namespace
}  // namespace feedscope::ui

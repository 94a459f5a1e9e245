#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QFont>
#include <QLocale>
#include <QTest>

#include "tests/ui/locale_in_force.h"
#include "tests/ui/patience.h"
#include "tests/ui/run_fixture.h"
#include "ui/contour/contour_job.h"
#include "ui/contour/contour_places_model.h"
#include "ui/contour/contour_texts.h"

namespace feedscope::ui {
namespace {

using testing::HasSubstr;

const std::string three_corners = "G21 G90 G94 F3000\nG1 X20 Y0\nG1 X40 Y15\nG1 X60 Y0\nG1 X60 Y30\n";

class ContourModels : public testing::Test {
 protected:
  ContourModels() { QLocale::setDefault(QLocale::c()); }
  void TearDown() override { QLocale::setDefault(QLocale::c()); }

  static std::shared_ptr<const ContourReport> report_of(const feedscope::Run& run) {
    return std::make_shared<const ContourReport>(contour_report(run, 10));
  }
  QString cell(int row, int column) const { return model.index(row, column).data().toString(); }

  feedscope::Run run = test::simulate_text(three_corners);
  std::shared_ptr<const ContourReport> report = report_of(run);
  ContourPlacesModel model;
};

TEST_F(ContourModels, ListThePlacesTheWorstFirst) {
  const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
  model.set_report(report);
  ASSERT_EQ(model.rowCount(), static_cast<int>(report->worst.size()));
  ASSERT_GE(model.rowCount(), 2);
  for (int row = 0; row < model.rowCount(); ++row) {
    const ContourFinding& found = report->worst[static_cast<std::size_t>(row)];
    EXPECT_EQ(cell(row, ContourPlacesModel::error), error_text(found.place.error));
    EXPECT_THAT(cell(row, ContourPlacesModel::spot).toStdString(), HasSubstr("inside"));
    EXPECT_FALSE(model.index(row, 0).data(Qt::FontRole).isValid()) << "bold without reason";
  }
  model.set_report(nullptr);
  EXPECT_EQ(model.rowCount(), 0);
  EXPECT_EQ(model.next_row(0, true), -1);
}

TEST_F(ContourModels, MarkWhatExceedsItsTolerance) {
  auto exceeded = std::make_shared<ContourReport>(*report);
  exceeded->worst[0].tolerance = exceeded->worst[0].place.error / 2;
  model.set_report(exceeded);
  EXPECT_TRUE(model.index(0, 0).data(Qt::FontRole).value<QFont>().bold());
  EXPECT_EQ(cell(0, ContourPlacesModel::share), "200");
  EXPECT_THAT(model.index(0, 0).data(Qt::ToolTipRole).toString().toStdString(), HasSubstr("is exceeded"));
  EXPECT_FALSE(model.index(1, 0).data(Qt::FontRole).isValid());
}

TEST_F(ContourModels, GoFromPlaceToPlaceInTheOrderOfTheProgram) {
  model.set_report(report);
  std::vector<double> times;
  for (const ContourFinding& found : report->worst) {
    times.push_back(found.place.time);
  }
  std::ranges::sort(times);
  double at = -1;
  for (const double time : times) {
    at = model.finding(model.next_row(at, true)).place.time;
    EXPECT_EQ(at, time);
  }
  EXPECT_EQ(model.finding(model.next_row(at, true)).place.time, times.front());
  EXPECT_EQ(model.finding(model.next_row(times.front(), false)).place.time, times.back());
}

TEST_F(ContourModels, SayHowLargeWhereAndAgainstWhat) {
  const std::string kept = verdict_text(*report).toStdString();
  EXPECT_THAT(kept, HasSubstr("Largest contour error " + error_text(report->largest).toStdString()));
  EXPECT_THAT(kept, HasSubstr("is kept."));
  ContourReport exceeded = *report;
  exceeded.tolerance = std::array{0.001, 0.001};
  EXPECT_THAT(verdict_text(exceeded).toStdString(), HasSubstr("is exceeded by"));
  exceeded.tolerance.reset();
  EXPECT_THAT(verdict_text(exceeded).toStdString(), HasSubstr("No contour tolerance applies."));
  exceeded.own_tolerances = true;
  EXPECT_THAT(verdict_text(exceeded).toStdString(), HasSubstr("within P of G64"));
  EXPECT_THAT(kept, testing::Not(HasSubstr("rapid")));
  exceeded.rapids = report->largest * 2;
  EXPECT_THAT(verdict_text(exceeded).toStdString(),
              HasSubstr("Rapids, which do not count here, leave the programmed path by up to " +
                        error_text(*exceeded.rapids).toStdString()));
  EXPECT_THAT(share_text(*report, true).toStdString(), testing::Not(HasSubstr("along Z")));
  exceeded.worst[0].place.side = 0;
  EXPECT_THAT(share_text(exceeded, true).toStdString(), HasSubstr("along Z"));
  EXPECT_THAT(share_text(exceeded, false).toStdString(), testing::Not(HasSubstr("along Z")));
  const ContourReport exact = *report_of(test::simulate_text(three_corners, "cam"));
  EXPECT_THAT(verdict_text(exact).toStdString(), HasSubstr("followed exactly"));
  EXPECT_TRUE(share_text(exact, true).isEmpty());
}

TEST_F(ContourModels, WriteNumbersByTheLocale) {
  const test::LocaleInForce locale{QLocale(QLocale::French)};
  EXPECT_EQ(error_text(0.0283), "28,3");
  EXPECT_EQ(error_text(0.00283), "2,83");
  EXPECT_EQ(error_text(0.0001), "0,100");
}

TEST_F(ContourModels, QuantilesAreThoseOfThePathLength) {
  ContourSpread spread;
  spread.step = 0.001;
  spread.amount = {80, 10, 9, 1};
  EXPECT_DOUBLE_EQ(error_quantile(spread, 0.0), 0.004);
  EXPECT_DOUBLE_EQ(error_quantile(spread, 0.01), 0.003);
  EXPECT_DOUBLE_EQ(error_quantile(spread, 0.1), 0.002);
  EXPECT_DOUBLE_EQ(error_quantile(spread, 1.0), 0);
}

TEST_F(ContourModels, ReportsAreMadeInTheBackgroundAndKeptAsLongAsTheirRuns) {
  ContourJob job;
  auto first = make_shown(feedscope::Run(run));
  auto second = make_shown(test::simulate_text(three_corners, "ward"));
  job.want({first, second});
  EXPECT_TRUE(job.busy());
  EXPECT_EQ(job.report(first), nullptr);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !job.busy(); }, patience));
  ASSERT_NE(job.report(first), nullptr);
  ASSERT_NE(job.report(second), nullptr);
  EXPECT_EQ(job.report(first)->largest, report->largest);
  const std::weak_ptr<const ContourReport> kept = job.report(first);
  job.want({});
  EXPECT_FALSE(kept.expired());
  first.reset();
  job.want({second});
  EXPECT_TRUE(kept.expired());
  EXPECT_FALSE(job.busy()) << "a report that is there is made again";
}

TEST_F(ContourModels, WhatIsNoLongerWantedIsGivenUp) {
  const auto shown = make_shown(feedscope::Run(run));
  ContourJob job;
  job.want({shown});
  job.want({});
  ASSERT_TRUE(QTest::qWaitFor([&] { return !job.busy(); }, patience));
  job.want({shown});
  ASSERT_TRUE(QTest::qWaitFor([&] { return !job.busy(); }, patience));
  EXPECT_NE(job.report(shown), nullptr);
}

}  // namespace
}  // namespace feedscope::ui

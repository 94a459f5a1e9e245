#include "ui/why/remedy_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QLocale>
#include <QSignalSpy>
#include <QTest>

#include "tests/ui/locale_in_force.h"
#include "tests/ui/patience.h"
#include "tests/ui/run_fixture.h"
#include "ui/language/texts.h"

namespace feedscope::ui {
namespace {

using testing::HasSubstr;

class RemedyTableTest : public testing::Test {
 protected:
  RemedyTableTest() { QLocale::setDefault(QLocale::c()); }

  std::string text(int row, int column) const {
    return table.index(row, column).data().toString().toStdString();
  }
  void begin() {
    const Remedy feed{{{"feed_override_percent", 120.0}}};
    table.begin(setup, {{{{"X.jerk", 22.5}}}, {{{"contour_tolerance_mm", 0.2}}}, feed}, {10, 2, {}});
  }

  feedscope::Setup setup = make_setup({"spinner-mvc850", "essid", 0.1, {}});
  RemedyTable table;
};

TEST_F(RemedyTableTest, IsASoundItemModel) {
  const QAbstractItemModelTester tester(&table, QAbstractItemModelTester::FailureReportingMode::Fatal);
  begin();
  table.set_trial(1, {9, 1.5, {}});
  table.set_trial(0, {9.5, 2, {}});
  table.set_trial(2, {0, 0, "no"});
  table.sort_by_gain();
  table.clear();
}

TEST_F(RemedyTableTest, ARowSaysWhatIsChangedAndWhatItGains) {
  begin();
  EXPECT_EQ(text(0, RemedyTable::change), "Jerk of X 15 → 22.5 m/s³");
  EXPECT_EQ(text(0, RemedyTable::gain), "…");
  table.set_trial(0, {9.5, 2.25, {}});
  EXPECT_EQ(text(0, RemedyTable::cycle_time), clock_text(9.5).toStdString());
  EXPECT_EQ(text(0, RemedyTable::gain), "−0.500 s\n−5.0 %");
  EXPECT_EQ(text(0, RemedyTable::here), "+0.250 s\n+12.5 %");
  table.set_trial(1, {9.999, 2, {}});
  EXPECT_EQ(text(1, RemedyTable::gain), "−0.001 s") << "no share of 0.0 %";
  EXPECT_EQ(text(2, RemedyTable::change), "Feed override 100 → 120 %");
}

TEST_F(RemedyTableTest, TheLargestGainComesFirstAndFailuresLast) {
  begin();
  table.set_trial(0, {9.5, 2, {}});
  table.set_trial(1, {0, 0, "too much"});
  table.set_trial(2, {9, 2, {}});
  const QPersistentModelIndex jerk = table.index(0, 0);
  table.sort_by_gain();
  EXPECT_EQ(text(0, RemedyTable::change), "Feed override 100 → 120 %");
  EXPECT_EQ(jerk.row(), 1);
  EXPECT_EQ(table.remedy(1)->changes.front().first, "X.jerk");
  EXPECT_EQ(text(2, RemedyTable::gain), "–");
  EXPECT_EQ(table.index(2, 0).data(Qt::ToolTipRole).toString().toStdString(), "too much");
  EXPECT_EQ(table.remedy(3), nullptr);
}

TEST_F(RemedyTableTest, NumbersFollowTheLocale) {
  const test::LocaleInForce locale{QLocale(QLocale::German)};
  begin();
  table.set_trial(0, {9.5, 2, {}});
  EXPECT_EQ(text(0, RemedyTable::gain), "−0,500 s\n−5,0 %");
  QLocale::setDefault(QLocale::c());
}

class RemedyJobTest : public testing::Test {
 protected:
  RemedyRequest request(const std::vector<Remedy>& list) const {
    return {run, list, {0, static_cast<std::uint32_t>(run.path->segments.size() - 1)}};
  }
  feedscope::Run run = test::simulate_text(test::small_program);
  RemedyJob job;
};

TEST_F(RemedyJobTest, TriesEveryChangeByItself) {
  std::vector<RemedyTrial> trials(2);
  QObject::connect(&job, &RemedyJob::tried,
                   [&](std::size_t i, const RemedyTrial& trial) { trials.at(i) = trial; });
  QSignalSpy finished(&job, &RemedyJob::finished);
  job.start(request({{{{"X.jerk", 30.0}}}, {}}));
  ASSERT_TRUE(finished.wait(patience));
  EXPECT_LT(trials[0].cycle_time, run.trajectory->duration());
  EXPECT_EQ(trials[1].cycle_time, run.trajectory->duration());
  EXPECT_NEAR(trials[1].passage_time, run.trajectory->duration(), 1e-9);
}

TEST_F(RemedyJobTest, AFaultyChangeSaysWhyAndTheOthersGoOn) {
  std::vector<RemedyTrial> trials(2);
  QObject::connect(&job, &RemedyJob::tried,
                   [&](std::size_t i, const RemedyTrial& trial) { trials.at(i) = trial; });
  QSignalSpy finished(&job, &RemedyJob::finished);
  job.start(request({{{{"X.jerk", -1.0}}}, {}}));
  ASSERT_TRUE(finished.wait(patience));
  EXPECT_THAT(trials[0].failure.toStdString(), HasSubstr("jerk"));
  EXPECT_GT(trials[1].cycle_time, 0);
}

TEST_F(RemedyJobTest, ANewRequestDropsTheOneUnderWay) {
  std::vector<std::size_t> tried;
  QObject::connect(&job, &RemedyJob::tried, [&](std::size_t i, const RemedyTrial&) { tried.push_back(i); });
  QSignalSpy finished(&job, &RemedyJob::finished);
  job.start(request(std::vector<Remedy>(50)));
  job.start(request({{}}));
  ASSERT_TRUE(finished.wait(patience));
  EXPECT_FALSE(job.busy());
  EXPECT_EQ(tried, std::vector<std::size_t>{0});
}

}  // namespace
}  // namespace feedscope::ui

#include "ui/decide/decide_view.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <QTreeWidget>
#include <fstream>

#include "core/base/error.h"
#include "tests/ui/patience.h"
#include "tests/ui/run_fixture.h"
#include "ui/decide/decision_chart.h"
#include "ui/decide/tolerance_dialog.h"

namespace feedscope::ui {
namespace {

using ::testing::HasSubstr;

class DecideViewTest : public ::testing::Test {
 protected:
  DecideViewTest() {
    QLocale::setDefault(QLocale::c());
    view.resize(300, 700);
    view.show();
    const std::filesystem::path file = std::filesystem::path(folder.path().toStdString()) / "part.nc";
    std::ofstream(file) << test::small_program;
    model.open(file);
    wait();
  }
  void wait() {
    ASSERT_TRUE(QTest::qWaitFor([this] { return !model.busy() && !model.time_findings().busy(); }, patience));
    for (int turn = 0; turn < 3; ++turn) {
      QCoreApplication::processEvents();
    }
  }
  void compare(const QString& tolerances) {
    view.compare_with(ToleranceDialog::setups(model.runs(), tolerances));
    wait();
  }
  double time(std::size_t row) { return model.runs().result(row)->run.summary.cycle_time; }
  double error(std::size_t row) { return deciding_error(model.runs().result(row)->run.summary); }

  QTemporaryDir folder;
  Workbench model{shipped_machines(), make_setup({})};
  DecideView view{model};
};

TEST_F(DecideViewTest, OfOneRunItSaysWhatIsLostAndOffersToCompare) {
  EXPECT_THAT(view.headline().toStdString(), HasSubstr("are lost"));
  EXPECT_FALSE(view.causes().rows().empty());
  EXPECT_FALSE(view.chart().isVisible());
  EXPECT_FALSE(view.table().isVisible());
  EXPECT_TRUE(view.compare()->isEnabled());
}

TEST_F(DecideViewTest, SaysWhyThereIsNothingToCompare) {
  const std::string usual = view.compare()->toolTip().toStdString();
  model.choose_model("grbl");
  wait();
  EXPECT_FALSE(view.compare()->isEnabled());
  EXPECT_THAT(view.compare()->toolTip().toStdString(), HasSubstr("no contour tolerance"));
  model.choose_model("essid");
  wait();
  EXPECT_EQ(view.compare()->toolTip().toStdString(), usual);
}

TEST_F(DecideViewTest, OfSeveralItNamesTheRunToTakeAndMakesItTheCurrentOne) {
  compare("0.01 0.02 0.05");
  const auto taken = recommended(model.runs());
  ASSERT_TRUE(taken.has_value());
  EXPECT_EQ(model.runs().current(), taken->run);
  const QString name = short_run_titles(model.runs().items(), {})[static_cast<qsizetype>(taken->run)];
  EXPECT_THAT(view.headline().toStdString(), HasSubstr(name.toStdString()));
  for (std::size_t row = 0; row < model.runs().items().size(); ++row) {  // the rule, by brute force
    const bool better =
        time(row) <= 1.01 * std::min({time(0), time(1), time(2), time(3)}) && error(row) < error(taken->run);
    EXPECT_FALSE(better) << row;
  }
  EXPECT_EQ(view.table().topLevelItemCount(), 4);
  EXPECT_EQ(view.chart().dots().size(), 4U);
}

TEST_F(DecideViewTest, ABoundRulesOutRunsEverywhere) {
  compare("0.01 0.02");
  view.findChild<QCheckBox*>()->setChecked(true);
  view.findChild<QDoubleSpinBox*>()->setValue(15);  // um
  wait();
  const auto taken = recommended(model.runs());
  ASSERT_TRUE(taken.has_value());
  EXPECT_LE(error(taken->run), 0.015);
  EXPECT_TRUE(view.chart().bound_x().has_value());
  view.findChild<QDoubleSpinBox*>()->setValue(0.1);
  wait();
  EXPECT_THAT(view.headline().toStdString(), HasSubstr("No run keeps a contour error of 0.1"));
}

TEST_F(DecideViewTest, TheTableChoosesTheCurrentRunAndWhatIsDrawn) {
  compare("0.01 0.02");
  view.table().setCurrentItem(view.table().topLevelItem(0));
  EXPECT_EQ(model.runs().current(), 0U);
  wait();
  view.table().topLevelItem(1)->setCheckState(0, Qt::Unchecked);
  EXPECT_FALSE(model.runs().items()[1].visible);
}

TEST_F(DecideViewTest, AToleranceThatARunHasIsNotAddedAgain) {
  EXPECT_EQ(ToleranceDialog::setups(model.runs(), "0.1 0.02 0,02; 0.05").size(), 2U) << "0.1 is there";
  compare("0.02 0.05");
  EXPECT_TRUE(ToleranceDialog::setups(model.runs(), "0.02 0.05").empty());
  EXPECT_THROW(ToleranceDialog::setups(model.runs(), "0.02 fine"), InputError);
  EXPECT_THROW(ToleranceDialog::setups(model.runs(), "-1"), InputError);
}

TEST_F(DecideViewTest, ATriedChangeBecomesARun) {
  ASSERT_TRUE(model.time_findings().tried());
  ASSERT_FALSE(view.tries().isEmpty());
  view.tries().front()->click();
  wait();
  ASSERT_EQ(model.runs().items().size(), 2U);
  EXPECT_LT(time(1), time(0));
}

TEST_F(DecideViewTest, SpeaksFrenchNumbers) {
  QLocale::setDefault(QLocale(QLocale::French));
  compare("0.01");
  EXPECT_THAT(view.headline().toStdString(), HasSubstr(","));
  EXPECT_THAT(view.headline().toStdString(), ::testing::Not(HasSubstr("0.01")));
  QLocale::setDefault(QLocale::c());
}

}  // namespace
}  // namespace feedscope::ui

#include "ui/contour/contour_view.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QAction>
#include <QCheckBox>
#include <QClipboard>
#include <QGuiApplication>
#include <QSignalSpy>
#include <QSplitter>
#include <QTest>
#include <QTreeView>

#include "tests/ui/patience.h"
#include "tests/ui/run_fixture.h"

namespace feedscope::ui {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

const std::string corners_of_three = "G21 G90 G94 F3000\nG1 X20 Y0\nG1 X40 Y15\nG1 X60 Y0\nG1 X60 Y30\n";

class ContourViewTest : public testing::Test {
 protected:
  ContourViewTest() {
    QLocale::setDefault(QLocale::c());
    view.resize(900, 300);
  }
  void open(const std::string& text = corners_of_three) {
    model.show(
        simulate_run(load_program(std::make_shared<const SourceText>("test.nc", text)), make_setup({})));
  }
  bool wait() {
    return QTest::qWaitFor(
        [this] { return !view.busy() && !model.busy() && view.places().report() != nullptr; }, patience);
  }
  double chosen_time() const { return chosen.last()[0].toDouble(); }
  const ContourFinding& worst(int row) { return view.places().finding(row); }

  Workbench model{shipped_machines(), make_setup({})};
  ContourView view{model};
  QSignalSpy chosen{&view, &ContourView::place_chosen};
  QSignalSpy close_up{&view, &ContourView::close_up_wanted};
  QSignalSpy attention{&view, &ContourView::attention_wanted};
};

TEST_F(ContourViewTest, IsFoundOnlyWhileItIsSeen) {
  open();
  EXPECT_FALSE(view.busy());
  view.set_on_screen(false);
  view.show();
  EXPECT_FALSE(view.busy());
  view.set_on_screen(true);
  EXPECT_TRUE(view.busy());
  ASSERT_TRUE(wait());
  EXPECT_THAT(view.verdict().toStdString(), HasSubstr("Largest contour error"));
  EXPECT_EQ(view.chart().curves().runs.size(), 1U);
}

TEST_F(ContourViewTest, AClickAndEnterGoToAPlace) {
  view.show();
  open();
  ASSERT_TRUE(wait());
  ASSERT_GE(view.places().rowCount(), 2);
  const QRect row = view.list().visualRect(view.places().index(1, ContourPlacesModel::error));
  QTest::mouseClick(view.list().viewport(), Qt::LeftButton, {}, row.center());
  ASSERT_EQ(chosen.size(), 1);
  EXPECT_EQ(chosen_time(), worst(1).place.time);
  EXPECT_LT(chosen[0][1].toDouble(), chosen_time());
  EXPECT_GT(chosen[0][2].toDouble(), chosen_time());
  EXPECT_EQ(close_up.size(), 1);
  QTest::keyClick(&view.list(), Qt::Key_Up);
  QTest::keyClick(&view.list(), Qt::Key_Return);
  EXPECT_EQ(chosen_time(), worst(0).place.time);
}

TEST_F(ContourViewTest, StepsGoThroughThePlacesFromTheCursorOn) {
  view.show();
  open();
  ASSERT_TRUE(wait());
  QAction& next = *view.step_actions()[0];
  EXPECT_EQ(next.shortcut(), QKeySequence(Qt::Key_F6));
  model.cursor().set_time(0);
  double before = 0;
  for (int i = 0; i < view.places().rowCount(); ++i) {
    next.trigger();
    EXPECT_GT(chosen_time(), before);
    before = chosen_time();
  }
  view.step_actions()[1]->trigger();
  EXPECT_LT(chosen_time(), before);
}

TEST_F(ContourViewTest, AStepBringsTheHiddenPanelUpAndGoesOnceThePlacesAreThere) {
  open();
  view.step_actions()[0]->trigger();
  EXPECT_EQ(attention.size(), 1);
  EXPECT_TRUE(chosen.isEmpty());
  view.show();
  ASSERT_TRUE(wait());
  EXPECT_EQ(chosen.size(), 1);
}

TEST_F(ContourViewTest, OtherRunsAreDrawnWhileTheyAreVisible) {
  view.show();
  open();
  ASSERT_TRUE(wait());
  model.runs().duplicate(0);
  model.set_tolerance(0.02);
  ASSERT_TRUE(QTest::qWaitFor([this] { return view.chart().curves().runs.size() == 2; }, patience));
  ASSERT_TRUE(wait());
  const ContourCurves& curves = view.chart().curves();
  EXPECT_LT(curves.runs[0].largest, curves.runs[1].largest);
  EXPECT_EQ(curves.tolerance, (std::array{0.02, 0.02}));
  model.runs().set_visible(0, false);
  EXPECT_EQ(view.chart().curves().runs.size(), 1U);
}

TEST_F(ContourViewTest, SidesAreTakenWhereTheDeviationLiesInXy) {
  view.show();
  open();
  ASSERT_TRUE(wait());
  EXPECT_TRUE(view.sides().isChecked());
  const auto* flat = view.places().report();
  open("G21 G18 G90 G94 F3000\nG1 X20 Z0\nG1 X40 Z15\nG1 X60 Z0\n");
  ASSERT_TRUE(QTest::qWaitFor(
      [&] { return !view.busy() && view.places().report() != nullptr && view.places().report() != flat; },
      patience));
  EXPECT_FALSE(view.sides().isChecked());
  view.sides().setChecked(true);
  EXPECT_TRUE(view.chart().curves().sides);
}

TEST_F(ContourViewTest, TheListGoesToTheClipboard) {
  view.show();
  open();
  ASSERT_TRUE(wait());
  view.panel_actions()[2]->trigger();
  const std::string text = QGuiApplication::clipboard()->text().toStdString();
  EXPECT_THAT(text, StartsWith("rank,line,"));
  EXPECT_EQ(std::ranges::count(text, '\n'), view.places().rowCount() + 1);
}

TEST_F(ContourViewTest, ChartAndListStandAboveEachOtherInANarrowDock) {
  view.show();
  auto* splitter = view.findChild<QSplitter*>();
  EXPECT_EQ(splitter->orientation(), Qt::Horizontal);
  view.resize(300, 700);
  EXPECT_EQ(splitter->orientation(), Qt::Vertical);
  EXPECT_LE(view.minimumSizeHint().width(), 300);
}

TEST_F(ContourViewTest, WithoutAProgramSaysSo) {
  view.show();
  EXPECT_THAT(view.verdict().toStdString(), HasSubstr("Open a program"));
  view.step_actions()[0]->trigger();
  open();
  ASSERT_TRUE(wait());
  EXPECT_TRUE(chosen.isEmpty());
}

}  // namespace
}  // namespace feedscope::ui

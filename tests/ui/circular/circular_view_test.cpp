#include "ui/circular/circular_view.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QJsonArray>
#include <QLocale>
#include <QTableView>
#include <QTest>

#include "core/base/units.h"
#include "tests/ui/patience.h"
#include "tests/ui/run_fixture.h"
#include "ui/circular/circular_table.h"
#include "ui/circular/polar_plot.h"
#include "ui/fields/number_box.h"
#include "ui/fields/number_list_field.h"
#include "ui/shared/row_copy.h"

namespace feedscope::ui {
namespace {

using testing::HasSubstr;

class CircularViewTest : public testing::Test {
 protected:
  explicit CircularViewTest(const char* machine = "mikron-ucp710")
      : model(shipped_machines(), make_setup({machine, "", {}})) {
    QLocale::setDefault(QLocale::c());
    view.resize(700, 600);
    view.show();
  }
  void test() {
    view.run();
    ASSERT_TRUE(QTest::qWaitFor([this] { return !view.busy(); }, patience));
  }

  Workbench model;
  CircularView view{model};
};

TEST_F(CircularViewTest, ShowsWhatTheCommandComputes) {
  view.radii()->setText("2.5");
  view.feeds()->setText("6000");
  test();
  ASSERT_EQ(view.plot()->tests().size(), 1U);
  const CircularTest& shown = view.plot()->tests().front();
  CircularRequest request;
  request.radius = 2.5;
  request.feed = 100;
  request.sweep = 2 * units::pi;
  EXPECT_EQ(shown.both->zone, run_circular_test(request, make_setup({"mikron-ucp710", "", {}})).both->zone);
  EXPECT_THAT(view.message().toStdString(), HasSubstr("Actual path"));
}

TEST_F(CircularViewTest, EntryArcAndPlaneAreThoseOfTheFields) {
  view.with_entry()->setChecked(true);
  view.entry()->setValue(20);
  view.plane()->setCurrentIndex(1);
  test();
  const CircularRequest& request = view.plot()->tests().front().request;
  EXPECT_EQ(request.entry_radius, 20);
  EXPECT_EQ(request.plane, CirclePlane::zx);
}

TEST_F(CircularViewTest, WhatIsWrongIsSaid) {
  view.radii()->setText("0");
  test();
  EXPECT_TRUE(view.plot()->tests().empty());
  EXPECT_THAT(view.message().toStdString(), HasSubstr("radius = 0 mm is out of bounds"));
  view.panel_actions()[1]->trigger();
  EXPECT_THAT(view.message().toStdString(), HasSubstr("no circular test yet"));
}

TEST_F(CircularViewTest, AnotherMachineOrControlForgetsTheResult) {
  test();
  ASSERT_FALSE(view.plot()->tests().empty());
  model.setup().set("X.kv", 30.0);
  EXPECT_TRUE(view.plot()->tests().empty());
  test();
  EXPECT_FALSE(view.plot()->tests().empty());
}

TEST_F(CircularViewTest, ValuesGoToTheClipboard) {
  test();
  view.panel_actions()[1]->trigger();
  EXPECT_EQ(QApplication::clipboard()->text(), rows_text(*view.table()));
  EXPECT_EQ(QApplication::clipboard()->text().count(QLatin1Char('\n')), 3);
}

TEST_F(CircularViewTest, SeveralRadiiAndFeedsMakeATableWhoseSelectedRowIsDrawn) {
  view.radii()->setText("2,5; 30");
  view.feeds()->setText("3000 6000 9000");
  test();
  ASSERT_EQ(view.table()->rowCount(), 12);
  EXPECT_EQ(view.plot()->tests().front().request.radius, 2.5);
  view.list()->selectRow(10);
  ASSERT_EQ(view.plot()->tests().size(), 1U);
  EXPECT_EQ(view.plot()->tests().front().request.radius, 30);
  EXPECT_NEAR(units::to_mm_min(view.plot()->tests().front().request.feed), 9000, 1e-9);
  EXPECT_TRUE(view.list()->isColumnHidden(CircularTable::line));
}

TEST_F(CircularViewTest, WrongListsAreNamed) {
  view.feeds()->setText("3000 fast");
  test();
  EXPECT_THAT(view.message().toStdString(), HasSubstr("Feeds: “fast” is not a number"));
  view.feeds()->setText("");
  test();
  EXPECT_THAT(view.message().toStdString(), HasSubstr("Type one number or several"));
  QString many;
  for (int i = 1; i <= 101; ++i) {
    many += QString::number(i) + ' ';
  }
  view.feeds()->setText(many);
  test();
  EXPECT_THAT(view.message().toStdString(), HasSubstr("101 tests; a table has at most 100"));
}

TEST_F(CircularViewTest, CirclesOfTheProgramAreThoseOfTheShownRun) {
  view.source()->setCurrentIndex(1);
  EXPECT_THAT(view.message().toStdString(), HasSubstr("Open a program"));
  EXPECT_FALSE(view.radii()->isVisible());
  const feedscope::Run run =
      test::simulate_text("G21 G90 G17 G94 F6000\nG0 X30 Y0\nG3 I-30 J0\nG2 I-30 J0\nG0 X20\nG3 I-20\nM30\n",
                          "tapie", "mikron-ucp710");
  model.show(run);
  ASSERT_TRUE(QTest::qWaitFor([this] { return view.table()->rowCount() == 3; }, patience));
  EXPECT_EQ(view.table()->index(1, CircularTable::line).data().toString(), "4");
  EXPECT_EQ(view.table()->index(2, CircularTable::both).data().toString(), "–");
  EXPECT_FALSE(view.list()->isColumnHidden(CircularTable::line));
  view.list()->selectRow(2);
  EXPECT_EQ(view.plot()->tests().front().passes.size(), 1U);
  model.show(test::simulate_text("G21 G1 X20 F3000\n", "tapie", "mikron-ucp710"));
  ASSERT_TRUE(QTest::qWaitFor([this] { return !view.busy() && view.table()->rowCount() == 0; }, patience));
  EXPECT_THAT(view.message().toStdString(), HasSubstr("The program has no full circle"));
}

TEST_F(CircularViewTest, FieldsAreKeptAndGivenBack) {
  const CircularState state{true, {2.5, 30}, {3000, 6000}, CirclePlane::yz, true, 2};
  view.set_state(state);
  EXPECT_EQ(view.state(), state);
  CircularState read;
  read_json(to_json(state), read);
  EXPECT_EQ(read, state);
  read_json({{"source", "other"}, {"radii_mm", QJsonArray{-1}}, {"plane", "XX"}}, read);
  EXPECT_EQ(read, state);
}

class CircularViewWithoutDrivesTest : public CircularViewTest {
 protected:
  CircularViewWithoutDrivesTest() : CircularViewTest("spinner-mvc850") {}
};

TEST_F(CircularViewWithoutDrivesTest, SaysThatTheSetPathIsJudged) {
  test();
  EXPECT_THAT(view.message().toStdString(), HasSubstr("this machine has no drives"));
}

}  // namespace
}  // namespace feedscope::ui

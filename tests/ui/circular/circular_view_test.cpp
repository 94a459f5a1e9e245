#include "ui/circular/circular_view.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QLocale>
#include <QTest>

#include "core/base/units.h"
#include "tests/ui/patience.h"
#include "ui/circular/polar_plot.h"
#include "ui/fields/number_box.h"

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
  view.radius()->setValue(2.5);
  view.feed()->setValue(6000);
  test();
  ASSERT_EQ(view.plot()->tests().size(), 1U);
  const CircularTest& shown = view.plot()->tests().front();
  CircularRequest request;
  request.radius = 2.5;
  request.feed = 100;
  request.sweep = 2 * units::pi;
  EXPECT_EQ(shown.both.zone, run_circular_test(request, make_setup({"mikron-ucp710", "", {}})).both.zone);
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
  view.radius()->setValue(0);
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
  EXPECT_EQ(QApplication::clipboard()->text(), circular_values(view.plot()->tests().front()).join('\n'));
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

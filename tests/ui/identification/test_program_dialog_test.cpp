#include "ui/identification/test_program_dialog.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QComboBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QTreeWidget>

#include "core/analysis/run/run.h"
#include "tests/ui/trace_fixture.h"
#include "ui/fields/number_box.h"

namespace feedscope::ui {
namespace {

using testing::HasSubstr;

class TestProgramDialogTest : public testing::Test {
 protected:
  TestProgramDialogTest() { QLocale::setDefault(QLocale::c()); }

  const test::WrittenFiles files;
  TestProgramDialog dialog{Dialect::sinumerik, make_setup({}), {}};
};

TEST_F(TestProgramDialogTest, WritesWhatItsFieldsSay) {
  EXPECT_EQ(dialog.proposed_name(), "feedscope-test.mpf");
  dialog.side().setValue(100);
  dialog.feed().setValue(6000);
  EXPECT_EQ(dialog.request().size, 100);
  EXPECT_DOUBLE_EQ(dialog.request().feed_max, 100);
  const std::filesystem::path file = files.write("test.mpf", "");
  EXPECT_FALSE(dialog.open_button().isEnabled());
  ASSERT_TRUE(dialog.write(file));
  EXPECT_THAT(dialog.state().toStdString(), HasSubstr("test.mpf is written. Run it"));
  const LoadedProgram read = load_program(file);
  EXPECT_EQ(read.program->dialect, Dialect::sinumerik);
  EXPECT_LE(read.toolpath->bounds.max.x(), 50);
  QSignalSpy wanted(&dialog, &TestProgramDialog::open_wanted);
  EXPECT_TRUE(dialog.open_button().isEnabled());
  dialog.open_button().click();
  EXPECT_EQ(wanted.size(), 1);
}

TEST_F(TestProgramDialogTest, SaysWhatEachPartTells) {
  ASSERT_EQ(dialog.parts().topLevelItemCount(), 7);
  EXPECT_EQ(dialog.parts().topLevelItem(0)->text(1), "SINGLE MOVES OF X");
  EXPECT_THAT(dialog.parts().topLevelItem(0)->text(3).toStdString(), HasSubstr("Velocity, acceleration"));
}

TEST_F(TestProgramDialogTest, SaysHowLongEachPartTakesOnTheMachineOfTheWindow) {
  const auto time = [this] {
    return dialog.parts().topLevelItem(0)->text(2).section(QChar::Nbsp, 0, 0).toDouble();
  };
  const double usual = time();
  EXPECT_GT(usual, 5) << "ten sections between pauses of half a second";
  dialog.side().setValue(1000);
  EXPECT_GT(time(), usual);
}

TEST_F(TestProgramDialogTest, WhatWasWrittenIsNotThatOfOtherFields) {
  ASSERT_TRUE(dialog.write(files.write("test.mpf", "")));
  dialog.dialect().setCurrentIndex(0);
  EXPECT_FALSE(dialog.open_button().isEnabled());
  EXPECT_EQ(dialog.proposed_name(), "feedscope-test.nc");
  EXPECT_FALSE(dialog.write("/no/such/folder/test.nc"));
  EXPECT_THAT(dialog.state().toStdString(), HasSubstr("/no/such/folder/test.nc cannot be written"));
}

}  // namespace
}  // namespace feedscope::ui

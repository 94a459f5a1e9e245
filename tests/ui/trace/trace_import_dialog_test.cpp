#include "ui/trace/trace_import_dialog.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QComboBox>
#include <QDialogButtonBox>
#include <QPushButton>
#include <QTableWidget>

#include "core/trace/read_trace.h"
#include "tests/ui/trace_fixture.h"
#include "ui/trace/trace_import_fields.h"
#include "ui/trace/trace_presets.h"

namespace feedscope::ui {
namespace {

using testing::HasSubstr;

/// No titles that say anything, decimal commas, times in milliseconds, X mirrored.
std::string strange_table() {
  std::string text = "Kanal 1;Kanal 2;Kanal 3\n";
  for (int i = 0; i < 50; ++i) {
    text += fmt::format("{};{},5;{},25\n", 4 * i, -i, 2 * i);
  }
  return text;
}

class TraceImportDialogTest : public testing::Test {
 protected:
  ~TraceImportDialogTest() override { forget_trace_preset("lathe"); }
  static bool may_import(TraceImportDialog& dialog) {
    return dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok)->isEnabled();
  }
  static QComboBox* box(TraceImportDialog& dialog, const char* name) {
    for (auto* found : dialog.findChildren<QComboBox*>()) {
      if (found->accessibleName() == name) {
        return found;
      }
    }
    return nullptr;
  }
  static void choose(TraceImportDialog& dialog, const char* name, const QString& data) {
    QComboBox* found = box(dialog, name);
    found->setCurrentIndex(found->findData(data));
  }

  const test::WrittenFiles files;
  const std::filesystem::path file = files.write("strange.csv", strange_table());
};

TEST_F(TraceImportDialogTest, ShowsTheRowsAndImportsNothingUntilItKnowsAPosition) {
  TraceImportDialog dialog(file, {}, "no position");
  EXPECT_EQ(dialog.preview().columnCount(), 3);
  EXPECT_EQ(dialog.preview().horizontalHeaderItem(1)->text(), "2: Kanal 2");
  EXPECT_FALSE(may_import(dialog));
  choose(dialog, "Column of Time", "1");
  choose(dialog, "Unit of Time", "ms");
  choose(dialog, "Column of X", "2");
  choose(dialog, "Unit of X", "mm");
  EXPECT_TRUE(may_import(dialog)) << dialog.outcome().toStdString();
  EXPECT_EQ(dialog.specification(), "time=1:ms,x=2:mm");
  EXPECT_THAT(dialog.outcome().toStdString(), HasSubstr("One sample each 4 ms"));
}

TEST_F(TraceImportDialogTest, AnAxisMayBeShifted) {
  TraceImportDialog dialog(file, "time=1:ms,x=2:-mm:100,y=3::-0.5", {});
  EXPECT_EQ(dialog.specification(), "time=1:ms,x=2:-mm:100,y=3::-0.5");
  const Trace trace = read_trace(file, parse_trace_columns(dialog.specification().toStdString()));
  EXPECT_NEAR(trace.place[0][10], 110.5, 1e-9);
  EXPECT_NEAR(trace.place[1][10], 19.75, 1e-9);
}

TEST_F(TraceImportDialogTest, WhatIsChosenReadsTheFileAsItWasMeant) {
  TraceImportDialog dialog(file, "time=1:ms,x=2:-mm,y=3:um,decimal=comma,separator=semicolon,skip=0", {});
  EXPECT_EQ(dialog.specification(), "time=1:ms,x=2:-mm,y=3:um,separator=semicolon,decimal=comma");
  const Trace trace = read_trace(file, parse_trace_columns(dialog.specification().toStdString()));
  EXPECT_NEAR(trace.period, 0.004, 1e-9);
  EXPECT_NEAR(trace.place[0][10], 10.5, 1e-9);
  EXPECT_NEAR(trace.place[1][10], 0.02025, 1e-9);
}

TEST_F(TraceImportDialogTest, APresetIsKeptUnderItsNameAndUsedAgain) {
  {
    TraceImportDialog dialog(file, "time=1:ms,x=2:mm,y=3:mm", {});
    EXPECT_FALSE(dialog.keep_as(" ").isEmpty());
    EXPECT_FALSE(dialog.keep_as("linuxcnc").isEmpty()) << "that of the program";
    EXPECT_TRUE(dialog.keep_as("lathe").isEmpty());
  }
  TraceImportDialog dialog(file, {}, {});
  const int index = dialog.presets().findText("lathe");
  ASSERT_GT(index, 0);
  dialog.presets().setCurrentIndex(index);
  emit dialog.presets().activated(index);
  EXPECT_EQ(dialog.specification(), "time=1:ms,x=2:mm,y=3:mm");
  EXPECT_TRUE(may_import(dialog));
}

TEST_F(TraceImportDialogTest, SaysWhatIsWrong) {
  TraceImportDialog dialog(file, "time=1:ms,x=2:mm", {});
  choose(dialog, "Column of Y", "");
  choose(dialog, "Columns parted by", "tab");
  EXPECT_FALSE(may_import(dialog));
  EXPECT_THAT(dialog.outcome().toStdString(), HasSubstr("strange.csv"));
}

}  // namespace
}  // namespace feedscope::ui

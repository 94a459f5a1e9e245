#include "ui/program_text/reading_dialog.h"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QDialogButtonBox>
#include <QPushButton>
#include <QSpinBox>
#include <QTableWidget>

namespace feedscope::ui {
namespace {

/// Sinumerik; two edges of one tool whose radii nobody knows, one that the program sets.
Program two_edges() {
  ReadOptions options;
  options.dialect = Dialect::sinumerik;
  return read_program(std::make_shared<const SourceText>("part.mpf",
                                                         "$TC_DP6[4,1]=3\n"
                                                         "T4 D1\nG41 G1 X10 F100\nG40 X20\n"
                                                         "D2\nG41 G1 X30\nG40 X40\n"),
                      nullptr, options);
}

QTableWidget& cutters(const ReadingDialog& dialog) {
  return *dialog.findChild<QTableWidget*>();
}

bool may_accept(const ReadingDialog& dialog) {
  return dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok)->isEnabled();
}

TEST(ReadingDialog, GivesBackWhatItWasGiven) {
  ReadOptions options;
  EXPECT_EQ(ReadingDialog(options, nullptr).options(), options);
  options.dialect = Dialect::heidenhain;
  options.skip_deleted_blocks = true;
  options.repeat_limit = 7;
  options.call_depth = 3;
  options.radii.set("MILL 10", 4.995);
  options.tool_table = "/tables/tool.t";
  options.table_unit = 25.4;
  options.offsets.set("G55", Vec3(100, -2.5, 0));
  options.wear_only = true;
  EXPECT_EQ(ReadingDialog(options, nullptr).options(), options);
  options.simulate_cut_off = true;
  EXPECT_EQ(ReadingDialog(options, nullptr).options(), options);
  for (const LengthUnit unit : {LengthUnit::inch, LengthUnit::mm}) {
    options.unit = unit;
    EXPECT_EQ(ReadingDialog(options, nullptr).options(), options);
  }
}

TEST(ReadingDialog, ListsTheCuttersThatTheProgramAsksFor) {
  const Program program = two_edges();
  ReadingDialog dialog({}, &program);
  QTableWidget& table = cutters(dialog);
  ASSERT_EQ(table.rowCount(), 2);
  EXPECT_EQ(table.item(0, 0)->text(), "4");
  EXPECT_EQ(table.item(0, 1)->text(), "");
  EXPECT_EQ(table.item(0, 2)->text(), "program: 3 mm");
  EXPECT_EQ(table.item(1, 0)->text(), "4,2");
  EXPECT_EQ(table.item(1, 2)->text(), "unknown: the programmed contour is shown");
}

TEST(ReadingDialog, TakesARadiusWithPointOrComma) {
  const Program program = two_edges();
  ReadingDialog dialog({}, &program);
  cutters(dialog).item(0, 1)->setText("2.5");
  cutters(dialog).item(1, 1)->setText(" 1,25 ");
  ReadOptions expected;
  expected.radii.set("4", 2.5);
  expected.radii.set("4,2", 1.25);
  EXPECT_EQ(dialog.options(), expected);
  EXPECT_TRUE(may_accept(dialog));
}

TEST(ReadingDialog, RefusesWhatIsNoRadius) {
  const Program program = two_edges();
  ReadingDialog dialog({}, &program);
  for (const char* text : {"wide", "-1", "1e99", "nan", "1,2,3"}) {
    cutters(dialog).item(1, 1)->setText(text);
    EXPECT_FALSE(dialog.valid()) << text;
    EXPECT_FALSE(may_accept(dialog)) << text;
  }
  cutters(dialog).item(1, 1)->setText("");
  EXPECT_TRUE(may_accept(dialog));
}

/// Uses G54 and G55; the cells of the second are typed in.
TEST(ReadingDialog, TakesWorkOffsetsThatTheProgramUses) {
  ReadOptions fanuc;
  fanuc.dialect = Dialect::fanuc;
  const Program program = read_program(
      std::make_shared<const SourceText>("two.nc", "G54 G0 X1 Y1 Z1\nG55 X1 Y1 Z1\n"), nullptr, fanuc);
  ReadingDialog dialog(fanuc, &program);
  auto& table = *dialog.findChild<WorkOffsetsTable*>();
  ASSERT_EQ(table.rowCount(), 2);
  EXPECT_EQ(table.item(1, 0)->text(), "G55");
  EXPECT_TRUE(table.item(1, 4)->text().contains("assumed as zero")) << table.item(1, 4)->text().toStdString();
  table.item(1, 1)->setText("100.5");
  table.item(1, 2)->setText(" -2,25 ");
  EXPECT_TRUE(may_accept(dialog));
  ReadOptions expected = fanuc;
  expected.offsets.set("G55", Vec3(100.5, -2.25, 0));
  EXPECT_EQ(dialog.options(), expected);
  for (const char* text : {"far", "1e99", "1,000", "nan"}) {
    table.item(1, 3)->setText(text);
    EXPECT_FALSE(may_accept(dialog)) << text;
  }
  dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::RestoreDefaults)->click();
  EXPECT_EQ(dialog.options(), ReadOptions());
}

TEST(ReadingDialog, KnowsTheLanguageThatWasRecognised) {
  const Program program = two_edges();
  const ReadingDialog dialog({}, &program);
  const auto* list = dialog.findChild<QComboBox*>();
  EXPECT_TRUE(list->currentText().contains("Sinumerik")) << list->currentText().toStdString();
  EXPECT_EQ(list->count(), 1 + static_cast<int>(all_dialects().size()));
}

TEST(ReadingDialog, GoesBackToTheUsualWay) {
  ReadOptions options;
  options.dialect = Dialect::grbl;
  options.call_depth = 3;
  options.radii.set("4", 1);
  const Program program = two_edges();
  const ReadingDialog dialog(options, &program);
  dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::RestoreDefaults)->click();
  EXPECT_EQ(dialog.options(), ReadOptions());
}

}  // namespace
}  // namespace feedscope::ui

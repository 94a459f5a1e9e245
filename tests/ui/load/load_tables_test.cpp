#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QLocale>

#include "ui/load/load_figures_table.h"
#include "ui/load/load_places_table.h"
#include "ui/load/load_texts.h"

namespace feedscope::ui {
namespace {

LoadTotals totals() {
  LoadTotals totals;
  totals.cutting_time = 2;
  totals.predicted[3] = {480, 1.25, 17, 300};
  totals.programmed[3] = {640, 1.25, 17, 620};
  return totals;
}

TEST(LoadFiguresTable, HasARowForEachLoadAndNoneWithoutCutting) {
  QLocale::setDefault(QLocale::c());
  LoadFiguresTable table;
  const QAbstractItemModelTester tester(&table, QAbstractItemModelTester::FailureReportingMode::Fatal);
  table.set_totals(totals());
  ASSERT_EQ(table.rowCount(), 6);
  const auto cell = [&](int column) { return table.data(table.index(3, column)).toString(); };
  EXPECT_EQ(cell(LoadFiguresTable::quantity), "Peak cutting force");
  EXPECT_EQ(cell(LoadFiguresTable::largest), "480 N");
  EXPECT_EQ(cell(LoadFiguresTable::line), "17");
  EXPECT_EQ(cell(LoadFiguresTable::mean), "300 N");
  EXPECT_EQ(cell(LoadFiguresTable::programmed_largest), "640 N");
  EXPECT_EQ(cell(LoadFiguresTable::programmed_mean), "620 N");
  EXPECT_EQ(table.time_of(3), 1.25);
  table.set_totals(LoadTotals());
  EXPECT_EQ(table.rowCount(), 0);
}

TEST(LoadPlacesTable, ListsThePlacesOfAllBoundsInTheOrderOfTime) {
  QLocale::setDefault(QLocale::c());
  LoadPlacesTable table;
  const QAbstractItemModelTester tester(&table, QAbstractItemModelTester::FailureReportingMode::Fatal);
  LimitFigures chip{LoadLimit::least_chip, 0.5, 0, 1, {{0, 2, 2.5, 12, 14, 0.004}}};
  LimitFigures force{LoadLimit::max_force, 0.25, 1, 1, {{0, 1, 1.25, 8, 8, 700}}};
  table.set_limits({chip, force});
  ASSERT_EQ(table.rowCount(), 2);
  const auto cell = [&](int row, int column) { return table.data(table.index(row, column)).toString(); };
  EXPECT_EQ(cell(0, LoadPlacesTable::worst), "700 N");
  EXPECT_EQ(cell(0, LoadPlacesTable::lines), "8");
  EXPECT_EQ(cell(1, LoadPlacesTable::worst), QStringLiteral("4.0 µm"));
  EXPECT_EQ(cell(1, LoadPlacesTable::duration), "0.500 s");
  EXPECT_EQ(table.place(1).from, 2);
}

TEST(LoadTexts, SayWhatIsBeyondABoundAndWhatHasNoLoad) {
  QLocale::setDefault(QLocale::c());
  LoadFigures load;
  load.all = totals();
  load.limits = {{LoadLimit::least_chip, 0.5, 0.125, 3, {}}, {LoadLimit::max_force, 0, 0, 0, {}}};
  const QStringList sentences = limits_text(load);
  ASSERT_EQ(sentences.size(), 2);
  EXPECT_TRUE(sentences[0].contains("0.500 s in 3 places") && sentences[0].contains("0.125 s"))
      << sentences[0].toStdString();
  EXPECT_TRUE(sentences[1].endsWith("nowhere"));
  EXPECT_TRUE(without_load_text(load).isEmpty());
  load.time[static_cast<std::size_t>(LoadState::plunge)] = 1.5;
  EXPECT_TRUE(without_load_text(load).contains("1.500 s of plunging"));
  Engagement operation;
  EXPECT_EQ(operation_text(operation), "all tools");
  operation.tool = "4";
  operation.lines = {{10, 20}};
  EXPECT_EQ(operation_text(operation), QStringLiteral("tool 4, lines 10–20"));
}

}  // namespace
}  // namespace feedscope::ui

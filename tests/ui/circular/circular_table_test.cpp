#include "ui/circular/circular_table.h"

#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QLocale>

#include "core/base/units.h"

namespace feedscope::ui {
namespace {

CircularTest test_of(double deviation, std::size_t passes, std::uint32_t line) {
  CircularTest test;
  test.request = {10, 50, CirclePlane::zx, 0, 2 * units::pi, 0};
  test.center = {1, 2, -3};
  for (std::size_t i = 0; i < passes; ++i) {
    CirclePass& pass = test.passes.emplace_back();
    pass.counter_clockwise = i == 0;
    pass.first_line = line;
    pass.last_line = line + 1;
    pass.circularity.largest = deviation;
    pass.circularity.mean_radius = 10 + deviation;
  }
  if (passes > 1) {
    test.both = test.passes.front().circularity;
  }
  return test;
}

class CircularTableTest : public testing::Test {
 protected:
  CircularTableTest() { QLocale::setDefault(QLocale::c()); }
  QString cell(int row, int column) const { return table.index(row, column).data().toString(); }
  CircularTable table;
};

TEST_F(CircularTableTest, HasARowForEachDirection) {
  const QAbstractItemModelTester tester(&table, QAbstractItemModelTester::FailureReportingMode::Fatal);
  table.set_tests({test_of(0.0421, 2, 12), test_of(-0.01, 1, 20)});
  ASSERT_EQ(table.rowCount(), 3);
  EXPECT_EQ(cell(0, CircularTable::direction), "ccw");
  EXPECT_EQ(cell(1, CircularTable::direction), "cw");
  EXPECT_EQ(cell(0, CircularTable::line), "12–13");
  EXPECT_EQ(cell(0, CircularTable::largest), "42.10");
  EXPECT_EQ(cell(0, CircularTable::mean), "42.10");
  EXPECT_EQ(cell(1, CircularTable::d), "42.10");
  EXPECT_EQ(cell(2, CircularTable::d), "–");
  EXPECT_EQ(cell(2, CircularTable::both), "–");
  EXPECT_EQ(cell(2, CircularTable::largest), "−10.00");
  EXPECT_EQ(cell(2, CircularTable::center), "1.000 / 2.000 / −3.000");
  EXPECT_EQ(cell(2, CircularTable::radius), "10.000 ZX");
  EXPECT_EQ(&table.test_of(1), &table.tests()[0]);
  EXPECT_EQ(&table.test_of(2), &table.tests()[1]);
  table.set_tests({});
  EXPECT_EQ(table.rowCount(), 0);
}

TEST_F(CircularTableTest, EveryColumnHasATitleAndATip) {
  for (int column = 0; column < CircularTable::columns; ++column) {
    EXPECT_FALSE(table.headerData(column, Qt::Horizontal, Qt::DisplayRole).toString().isEmpty());
    EXPECT_FALSE(table.headerData(column, Qt::Horizontal, Qt::ToolTipRole).toString().isEmpty());
  }
}

}  // namespace
}  // namespace feedscope::ui

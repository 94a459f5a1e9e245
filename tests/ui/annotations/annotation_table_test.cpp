#include "ui/annotations/annotation_table.h"

#include <gtest/gtest.h>

#include <QAbstractItemModelTester>

namespace feedscope::ui {
namespace {

class AnnotationTableTest : public testing::Test {
 protected:
  QString cell(int row, int column) const { return table.data(table.index(row, column)).toString(); }

  QUndoStack history;
  AnnotationList list{history};
  AnnotationTable table{list};
  QAbstractItemModelTester tester{&table, QAbstractItemModelTester::FailureReportingMode::Fatal};
};

TEST_F(AnnotationTableTest, FollowsTheList) {
  Annotation callout;
  callout.text = "one\ntwo";
  callout.place.segment = 1;
  const int id = list.add(callout);
  ASSERT_EQ(table.rowCount(), 1);
  EXPECT_EQ(cell(0, AnnotationTable::kind), QStringLiteral("Callout"));
  EXPECT_EQ(cell(0, AnnotationTable::text), QStringLiteral("one · two"));
  EXPECT_EQ(cell(0, AnnotationTable::line), QString());
  list.remove(id);
  EXPECT_EQ(table.rowCount(), 0);
  history.undo();
  EXPECT_EQ(table.rowCount(), 1);
}

TEST_F(AnnotationTableTest, TellsValuesAndKeepsWhatWasWrittenAsTip) {
  Annotation callout;
  callout.text = "feed {feed}\nhere";
  list.add(callout);
  EXPECT_EQ(cell(0, AnnotationTable::text), "feed {feed} · here");
  QString feed = QStringLiteral("900 mm/min");
  table.set_teller([&feed](const Annotation& told) { return QString(told.text).replace("{feed}", feed); });
  EXPECT_EQ(cell(0, AnnotationTable::text), "feed 900 mm/min · here");
  feed = QStringLiteral("450 mm/min");  // another run
  table.refresh_texts();
  EXPECT_EQ(cell(0, AnnotationTable::text), "feed 450 mm/min · here");
  EXPECT_EQ(table.data(table.index(0, AnnotationTable::text), Qt::ToolTipRole).toString(), callout.text);
}

TEST_F(AnnotationTableTest, TellsTheLineOfThePlace) {
  Toolpath toolpath;
  toolpath.segments.resize(2);
  toolpath.segments[1].line = 42;
  table.set_toolpath(std::make_shared<const Toolpath>(toolpath));
  Annotation annotation;
  annotation.place.segment = 1;
  list.add(annotation);
  EXPECT_EQ(cell(0, AnnotationTable::line), QStringLiteral("42"));
}

}  // namespace
}  // namespace feedscope::ui

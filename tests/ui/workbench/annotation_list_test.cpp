#include "ui/workbench/annotation_list.h"

#include <gtest/gtest.h>

#include <QSignalSpy>

namespace feedscope::ui {
namespace {

class AnnotationListTest : public testing::Test {
 protected:
  Annotation with_text(int id, const QString& text) {
    Annotation changed = *list.find(id);
    changed.text = text;
    return changed;
  }

  QUndoStack history;
  AnnotationList list{history};
};

TEST_F(AnnotationListTest, WhatIsAddedIsSelectedAndCanBeTakenBack) {
  const int id = list.add({});
  EXPECT_EQ(list.selected(), id);
  history.undo();
  EXPECT_TRUE(list.items().empty());
  EXPECT_EQ(list.selected(), 0);
  history.redo();
  ASSERT_NE(list.find(id), nullptr);
}

TEST_F(AnnotationListTest, ChangesOfOneKindAreOneStepUntilItEnds) {
  const int id = list.add({});
  list.end_step();
  list.change(with_text(id, "a"), "text");
  list.change(with_text(id, "ab"), "text");
  list.end_step();
  list.change(with_text(id, "abc"), "text");
  history.undo();
  EXPECT_EQ(list.find(id)->text, QStringLiteral("ab"));
  history.undo();
  EXPECT_EQ(list.find(id)->text, QString());
  EXPECT_EQ(history.index(), 1);
}

TEST_F(AnnotationListTest, ChangesOfTwoAnnotationsAreTwoSteps) {
  const int first = list.add({});
  const int second = list.add({});
  list.change(with_text(first, "a"), "text");
  list.change(with_text(second, "b"), "text");
  history.undo();
  EXPECT_EQ(list.find(first)->text, QStringLiteral("a"));
  EXPECT_EQ(list.find(second)->text, QString());
}

TEST_F(AnnotationListTest, WhatChangesNothingIsNoStep) {
  const int id = list.add({});
  QSignalSpy changed(&list, &AnnotationList::changed);
  list.change(*list.find(id), "text");
  list.remove(id + 1);
  EXPECT_EQ(changed.count(), 0);
  EXPECT_EQ(history.count(), 1);
}

TEST_F(AnnotationListTest, RemovingTheSelectedOneSelectsNothing) {
  const int id = list.add({});
  list.remove(id);
  EXPECT_EQ(list.selected(), 0);
  history.undo();
  EXPECT_NE(list.find(id), nullptr);
}

TEST_F(AnnotationListTest, ReplacingIsNoStepAndGivesIds) {
  list.replace({Annotation{}, Annotation{}});
  EXPECT_EQ(history.count(), 0);
  EXPECT_NE(list.items()[0].id, list.items()[1].id);
  EXPECT_NE(list.items()[0].id, 0);
}

}  // namespace
}  // namespace feedscope::ui

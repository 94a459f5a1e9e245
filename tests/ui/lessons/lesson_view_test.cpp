#include "ui/lessons/lesson_view.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QAction>
#include <QComboBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QTextBrowser>
#include <QTextCursor>
#include <QToolButton>

#include "tests/ui/own_tip.h"
#include "tests/ui/patience.h"

namespace feedscope::ui {
namespace {

using testing::HasSubstr;
using testing::Not;

class LessonViewTest : public testing::Test {
 protected:
  LessonViewTest() {
    view.resize(360, 700);
    QSignalSpy listed(&desk, &LessonDesk::listed);
    view.show();
    EXPECT_TRUE(listed.wait(patience)) << "the list is read when the panel is shown";
  }

  /// With the keyboard, as in any list.
  void choose_lesson(int row) {
    QSignalSpy opened(&desk, &LessonDesk::opened);
    view.lessons().setFocus();
    view.lessons().setCurrentIndex(row - 1);
    QTest::keyClick(&view.lessons(), Qt::Key_Down);
    ASSERT_TRUE(opened.wait(patience));
  }
  static void click(QAbstractButton* button) { QTest::mouseClick(button, Qt::LeftButton); }
  void wait_for(const std::string& value) {
    EXPECT_TRUE(QTest::qWaitFor(
        [&] { return !model.busy() && view.measured().contains(QString::fromStdString(value)); }, patience))
        << view.measured().toStdString();
  }
  std::string question() { return view.question().toPlainText().toStdString(); }

  Workbench model{shipped_machines(), make_setup({})};
  LessonDesk desk{model};
  LessonView view{desk};
};

TEST_F(LessonViewTest, ListsLessonsAndShowsTheOneChosen) {
  EXPECT_EQ(view.lessons().count(), static_cast<int>(shipped_lessons().size()) + 1);
  EXPECT_EQ(view.lessons().itemText(4), "4. Why a small circle is slow (25 min)");
  EXPECT_FALSE(view.set_up_button().isEnabled());
  EXPECT_THAT(view.text().toPlainText().toStdString(), HasSubstr("Why a programmed feed is not reached"))
      << "the contents, while no lesson is open";
  choose_lesson(4);
  const std::string text = view.text().toPlainText().toStdString();
  EXPECT_THAT(text, HasSubstr("Why a small circle is slow"));
  EXPECT_THAT(text, HasSubstr("2.008 m/min"));
  EXPECT_THAT(text, Not(HasSubstr("**")));
  EXPECT_THAT(question(), HasSubstr("Which feed does each of them reach?"));
  EXPECT_EQ(view.lessons().currentIndex(), 4);
}

TEST_F(LessonViewTest, TheContentsLeadToTheLessons) {
  QSignalSpy opened(&desk, &LessonDesk::opened);
  const QTextCursor title = view.text().document()->find("7. The look-ahead horizon");
  ASSERT_FALSE(title.isNull());
  view.text().setTextCursor(title);
  view.text().ensureCursorVisible();
  QTest::mouseClick(view.text().viewport(), Qt::LeftButton, {},
                    view.text().cursorRect(title).center() - QPoint(8, 0));
  ASSERT_TRUE(opened.wait(patience));
  EXPECT_EQ(desk.lesson()->id, "07_look_ahead");
  EXPECT_EQ(view.lessons().currentIndex(), 7);
}

TEST_F(LessonViewTest, AnswersAQuestionByMovingTheControl) {
  choose_lesson(6);
  click(&view.set_up_button());
  wait_for("3000 mm/min");
  ASSERT_EQ(view.values().size(), 3);
  EXPECT_EQ(view.values()[0]->text(), "0.001");
  click(view.values()[0]);
  wait_for("6000 mm/min");
}

TEST_F(LessonViewTest, ShowsHintAndAnswerOnDemand) {
  choose_lesson(6);
  EXPECT_THAT(question(), Not(HasSubstr("Half the period gives twice the feed")));
  click(&view.answer_button());
  EXPECT_THAT(question(), HasSubstr("Half the period gives twice the feed, 6000 mm/min"));
  click(&view.answer_button());
  EXPECT_THAT(question(), Not(HasSubstr("Half the period gives twice the feed")));
  QAction* hint = view.panel_actions()[3];
  hint->trigger();
  EXPECT_THAT(question(), HasSubstr("mind the units"));
}

TEST_F(LessonViewTest, StepsThroughTheQuestions) {
  choose_lesson(6);
  QAction* before = view.panel_actions()[1];
  QAction* after = view.panel_actions()[2];
  EXPECT_FALSE(before->isEnabled());
  click(&view.answer_button());
  after->trigger();
  EXPECT_THAT(question(), HasSubstr("Switch compaction on."));
  EXPECT_FALSE(view.answer_button().isChecked()) << "the next question hides its answer";
  EXPECT_EQ(view.values().size(), 5);
  after->trigger();
  EXPECT_TRUE(after->isEnabled());
  after->trigger();
  EXPECT_FALSE(after->isEnabled());
  before->trigger();
  before->trigger();
  EXPECT_THAT(question(), HasSubstr("Switch compaction on."));
}

TEST_F(LessonViewTest, SpeaksTheLanguageOfItsDesk) {
  LessonDesk french(model, "fr");
  LessonView other(french);
  QSignalSpy listed(&french, &LessonDesk::listed);
  other.show();
  ASSERT_TRUE(listed.wait(patience));
  EXPECT_EQ(other.lessons().itemText(7), "7. L’horizon d’anticipation (15 min)");
  QSignalSpy opened(&french, &LessonDesk::opened);
  french.open(find_lesson("7"));
  ASSERT_TRUE(opened.wait(patience));
  EXPECT_THAT(other.text().toPlainText().toStdString(), HasSubstr("anticipe 8 blocs"));
  EXPECT_THAT(other.question().toPlainText().toStdString(), HasSubstr("Quelle avance"));
  EXPECT_THAT(other.measured().toStdString(), HasSubstr("avance maximale"));
}

TEST_F(LessonViewTest, ShowsWhereTheControlIs) {
  choose_lesson(3);
  QSignalSpy wanted(&view, &LessonView::setting_wanted);
  for (QToolButton* button : view.findChildren<QToolButton*>()) {
    if (button->text() == "Show setting") {
      click(button);
    }
  }
  ASSERT_EQ(wanted.count(), 1);
  EXPECT_EQ(wanted[0][0].toString(), "X.acceleration");
}

TEST_F(LessonViewTest, EveryActionSaysWhatItDoes) {
  for (const QAction* action : view.panel_actions()) {
    EXPECT_FALSE(action->text().isEmpty());
    EXPECT_TRUE(test::has_own_tip(*action)) << action->text().toStdString();
  }
}

}  // namespace
}  // namespace feedscope::ui

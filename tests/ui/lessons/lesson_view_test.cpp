#include "ui/lessons/lesson_view.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QAction>
#include <QClipboard>
#include <QGuiApplication>
#include <QLabel>
#include <QLayout>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTest>
#include <QTextBrowser>
#include <QTextCursor>
#include <QToolButton>

#include "tests/ui/own_tip.h"
#include "tests/ui/patience.h"
#include "ui/fields/number_box.h"
#include "ui/lessons/tries_table.h"

namespace feedscope::ui {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class LessonViewTest : public testing::Test {
 protected:
  LessonViewTest() {
    desk.unlock(true);
    view.resize(360, 700);
    QSignalSpy listed(&desk, &LessonDesk::listed);
    view.show();
    EXPECT_TRUE(listed.wait(patience)) << "the list is read when the panel is shown";
  }

  /// With the keyboard: Tab goes from link to link.
  void choose_lesson(int number) {
    QSignalSpy opened(&desk, &LessonDesk::opened);
    view.activateWindow();
    QAction& all = *view.panel_actions()[5];
    all.trigger();
    view.list().setFocus();
    for (int i = 0; i < number; ++i) {
      QTest::keyClick(&view.list(), Qt::Key_Tab);
    }
    QTest::keyClick(&view.list(), Qt::Key_Return);
    ASSERT_TRUE(opened.wait(patience));
    ASSERT_EQ(desk.lesson()->file, desk.entries()[static_cast<std::size_t>(number - 1)].file);
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

TEST_F(LessonViewTest, TheListTakesThePanelUntilALessonIsChosen) {
  EXPECT_TRUE(view.shows_list());
  EXPECT_GT(view.list().height(), view.height() * 9 / 10);
  const std::string list = view.list().toPlainText().toStdString();
  EXPECT_THAT(list, HasSubstr("8. Small circles and approaches (20 min)"));
  EXPECT_THAT(list, HasSubstr("Estimate the feed that a radius allows"));
  EXPECT_THAT(list, HasSubstr("A course of half a day: 1, 2, 3, 4, 5, 8, 12."));
  EXPECT_FALSE(view.set_up_button().isVisible());
  choose_lesson(8);
  EXPECT_FALSE(view.shows_list());
  const std::string text = view.text().toPlainText().toStdString();
  EXPECT_THAT(text, HasSubstr("Small circles and approaches"));
  EXPECT_THAT(text, HasSubstr("spreads the jump over one period t of 12 ms"));
  EXPECT_THAT(text, HasSubstr("Before you look"));
  EXPECT_THAT(text, Not(HasSubstr("On my machine"))) << "after the last question";
  EXPECT_THAT(text, Not(HasSubstr("**")));
  EXPECT_THAT(question(), HasSubstr("Which feed do the circles of radius 2.5 mm reach"));
  view.panel_actions()[5]->trigger();
  EXPECT_TRUE(view.shows_list()) << "and back";
}

TEST_F(LessonViewTest, TheListLeadsToTheLessons) {
  QSignalSpy opened(&desk, &LessonDesk::opened);
  const QTextCursor title = view.list().document()->find("7. Lines, arcs, splines");
  ASSERT_FALSE(title.isNull());
  view.list().setTextCursor(title);
  view.list().ensureCursorVisible();
  QTest::mouseClick(view.list().viewport(), Qt::LeftButton, {},
                    view.list().cursorRect(title).center() - QPoint(8, 0));
  ASSERT_TRUE(opened.wait(patience));
  EXPECT_EQ(desk.lesson()->id, "07_lines_arcs_splines");
}

TEST_F(LessonViewTest, TheFieldForThePredictionIsInPlaceOfTheQuestions) {
  desk.unlock(false);
  choose_lesson(6);
  EXPECT_TRUE(view.own_prediction().isVisible());
  EXPECT_FALSE(view.question().isVisible());
  EXPECT_FALSE(view.set_up_button().isEnabled());
  EXPECT_FALSE(view.panel_actions()[4]->isEnabled()) << "the answer";
  EXPECT_FALSE(view.predict_button().isEnabled()) << "nothing is written";
  EXPECT_TRUE(view.predict_text().isVisible());
  EXPECT_THAT(view.predict_text().toPlainText().toStdString(), HasSubstr("Both rows are straight."));
  EXPECT_EQ(view.predict_text().verticalScrollBar()->maximum(), 0) << "in full";
  EXPECT_THAT(view.text().toPlainText().toStdString(), Not(HasSubstr("Both rows are straight.")));
  QTest::keyClicks(&view.own_prediction(), "3 < 6 m/min");
  choose_lesson(12);
  EXPECT_EQ(view.own_prediction().toPlainText(), "");
  choose_lesson(6);
  EXPECT_EQ(view.own_prediction().toPlainText(), "3 < 6 m/min");
  click(&view.predict_button());
  wait_for("3000 mm/min");
  EXPECT_FALSE(view.own_prediction().isVisible());
  EXPECT_TRUE(view.question().isVisible());
  EXPECT_THAT(view.text().toPlainText().toStdString(),
              AllOf(HasSubstr("Both rows are straight."), HasSubstr("Your prediction: 3 < 6 m/min")));
}

TEST_F(LessonViewTest, ATeacherShowsTheRunByOneCommand) {
  desk.unlock(false);
  choose_lesson(6);
  view.unlock_action()->trigger();
  wait_for("3000 mm/min");
  EXPECT_TRUE(desk.unlocked());
  EXPECT_TRUE(view.question().isVisible());
}

TEST_F(LessonViewTest, AStepReadsATextToItsEndFirst) {
  desk.unlock(false);
  view.resize(360, 420);
  choose_lesson(6);
  QScrollBar& bar = *view.text().verticalScrollBar();
  ASSERT_TRUE(QTest::qWaitFor([&] { return bar.maximum() > 0; }, patience));
  view.step(true);
  EXPECT_TRUE(desk.awaits_prediction());
  EXPECT_GT(bar.value(), 0);
  for (int i = 0; i < 20 && bar.value() < bar.maximum(); ++i) {
    view.step(true);
  }
  EXPECT_TRUE(desk.awaits_prediction());
  view.step(true);
  EXPECT_FALSE(desk.awaits_prediction());
}

TEST_F(LessonViewTest, StepsGoThroughRunQuestionsAndAnswers) {
  desk.unlock(false);
  view.resize(360, 2400);  // room for all texts
  choose_lesson(6);
  view.step(false);
  EXPECT_TRUE(desk.awaits_prediction());
  view.step(true);
  EXPECT_FALSE(desk.awaits_prediction());
  wait_for("3000 mm/min");
  const std::vector<std::pair<std::size_t, bool>> steps{{0, true}, {1, false}, {1, true}};
  for (const auto& [question, answer] : steps) {
    view.step(true);
    EXPECT_EQ(desk.question(), question);
    EXPECT_EQ(view.answer_button().isChecked(), answer);
    EXPECT_FALSE(view.transfer().isVisible());
  }
  for (int i = 0; i < 2; ++i) {
    view.step(true);
    EXPECT_TRUE(view.transfer().isVisible()) << "the last step";
    EXPECT_FALSE(view.question().isVisible());
  }
  const std::vector<std::pair<std::size_t, bool>> back{
      {1, true}, {1, false}, {0, true}, {0, false}, {0, false}};
  for (const auto& [question, answer] : back) {
    view.step(false);
    EXPECT_EQ(desk.question(), question);
    EXPECT_EQ(view.answer_button().isChecked(), answer);
  }
}

/// So that a question has the whole column.
TEST_F(LessonViewTest, BeforeAClassOneThingIsShownAtATime) {
  desk.unlock(false);
  view.resize(360, 2400);  // room for all texts
  view.set_presenting(true);
  choose_lesson(6);
  struct Shown {
    bool text, prediction, question, answer, transfer;
    bool operator==(const Shown&) const = default;
  };
  const auto shown = [&] {
    constexpr int laid_out = 20;  // [ms]
    QTest::qWait(laid_out);
    return Shown{view.text().isVisible(), view.own_prediction().isVisible(), view.question().isVisible(),
                 view.expected().isVisible(), view.transfer().isVisible()};
  };
  const std::vector<Shown> covered{{.text = true}, {.prediction = true}};
  const std::vector<Shown> uncovered{
      {.text = true},
      {.question = true},
      {.question = true, .answer = true},
      {.question = true},
      {.question = true, .answer = true},
      {.transfer = true},
  };
  EXPECT_EQ(shown(), covered[0]);
  view.step(true);
  EXPECT_EQ(shown(), covered[1]);
  view.step(false);
  EXPECT_EQ(shown(), covered[0]);
  view.step(true);
  view.step(true);
  EXPECT_FALSE(desk.awaits_prediction());
  for (std::size_t i = 1; i < uncovered.size(); ++i) {
    EXPECT_EQ(shown(), uncovered[i]) << "forward, " << i;
    view.step(true);
  }
  for (std::size_t i = uncovered.size() - 1; i > 0; --i) {
    EXPECT_EQ(shown(), uncovered[i]) << "back, " << i;
    view.step(false);
  }
  EXPECT_EQ(shown(), uncovered[0]);
  view.step(false);
  EXPECT_EQ(shown(), uncovered[0]);
  view.set_presenting(false);
  EXPECT_TRUE(view.text().isVisible());
  EXPECT_TRUE(view.question().isVisible());
}

/// Rows of the values tried, as they are copied: tabs between the cells.
std::string copied_tries(LessonView& view) {
  view.panel_actions()[6]->trigger();
  return QGuiApplication::clipboard()->text().toStdString();
}

TEST_F(LessonViewTest, KeepsEachValueTriedWithWhatItChanges) {
  choose_lesson(6);
  EXPECT_FALSE(view.tries().isVisible());
  click(&view.set_up_button());
  wait_for("3000 mm/min");
  ASSERT_TRUE(QTest::qWaitFor([&] { return view.tries().rowCount() == 1; }, patience))
      << "what the lesson begins with";
  click(view.values()[2]);
  wait_for("1500 mm/min");
  ASSERT_TRUE(QTest::qWaitFor([&] { return view.tries().rowCount() == 2; }, patience));
  EXPECT_EQ(view.tries().item(1, 0)->text(), "4");
  EXPECT_EQ(view.tries().item(1, 3)->text(), "1500");
  EXPECT_EQ(view.tries().item(1, 4)->text(), "−50.0");
  EXPECT_EQ(view.tries().item(0, 4)->text(), "reference") << "what the others are compared with";
  const std::string rows = copied_tries(view);
  EXPECT_THAT(rows, HasSubstr("4\t"));
  EXPECT_THAT(rows, HasSubstr("\t1500\t−50.0\n"));
  click(view.values()[2]);
  wait_for("1500 mm/min");
  EXPECT_EQ(view.tries().rowCount(), 2) << "a value has one row";
}

/// A narrow column has no room for columns of their own; what is copied has them all the same.
TEST_F(LessonViewTest, ChangesStandBelowTheNumbersInANarrowPanel) {
  choose_lesson(6);
  click(&view.set_up_button());
  wait_for("3000 mm/min");
  click(view.values()[2]);
  wait_for("1500 mm/min");
  ASSERT_TRUE(QTest::qWaitFor([&] { return view.tries().rowCount() == 2; }, patience));
  constexpr QSize wide(700, 700);
  view.resize(wide);
  QCoreApplication::processEvents();
  EXPECT_FALSE(view.tries().isColumnHidden(4));
  const int height = view.tries().rowHeight(1);
  constexpr QSize narrow(250, 700);
  view.resize(narrow);
  QCoreApplication::processEvents();
  EXPECT_TRUE(view.tries().isColumnHidden(2));
  EXPECT_TRUE(view.tries().isColumnHidden(4));
  EXPECT_GT(view.tries().rowHeight(1), height * 3 / 2);
  EXPECT_THAT(copied_tries(view), HasSubstr("\t1500\t−50.0\n"));
}

TEST_F(LessonViewTest, ATryLeavesTheButtonsInPlace) {
  choose_lesson(6);
  click(&view.set_up_button());
  wait_for("3000 mm/min");
  ASSERT_TRUE(QTest::qWaitFor([&] { return view.tries().rowCount() == 1; }, patience));
  constexpr int laid_out = 50;  // [ms]
  QTest::qWait(laid_out);
  const auto place = [this] { return view.values()[2]->mapTo(&view, QPoint()).y(); };
  const int before = place();
  for (const std::size_t value : {std::size_t{2}, std::size_t{1}}) {
    const int rows = view.tries().rowCount();
    click(view.values()[value]);
    ASSERT_TRUE(QTest::qWaitFor([&] { return view.tries().rowCount() > rows; }, patience));
    QTest::qWait(laid_out);
    EXPECT_EQ(place(), before) << "after " << rows << " values";
  }
}

TEST_F(LessonViewTest, TheFirstTryLeavesTheButtonsInPlace) {
  choose_lesson(4);
  view.panel_actions()[2]->trigger();
  constexpr int laid_out = 50;  // [ms]
  QTest::qWait(laid_out);
  ASSERT_EQ(view.tries().rowCount(), 0);
  const auto place = [this] { return view.values()[3]->mapTo(&view, QPoint()); };
  const QPoint before = place();
  click(view.values()[0]);
  ASSERT_TRUE(QTest::qWaitFor([&] { return view.tries().rowCount() == 1; }, patience));
  QTest::qWait(laid_out);
  EXPECT_EQ(place(), before) << "the next one is met by the same click";
}

TEST_F(LessonViewTest, TheFirstValueHasItsRoomAfterThePrediction) {
  constexpr QSize as_docked(292, 650);
  view.resize(as_docked);
  desk.unlock(false);
  QSignalSpy opened(&desk, &LessonDesk::opened);
  desk.open(find_lesson("3"), true);
  ASSERT_TRUE(opened.wait(patience));
  view.own_prediction().setPlainText("by a half");
  click(&view.predict_button());
  ASSERT_TRUE(QTest::qWaitFor([&] { return view.tries().rowCount() == 1; }, patience));
  constexpr int laid_out = 50;  // [ms]
  QTest::qWait(laid_out);
  const QWidget& tried = *view.tries().parentWidget();
  EXPECT_GE(tried.height(), tried.layout()->totalHeightForWidth(tried.width()));
}

TEST_F(LessonViewTest, TriesLastUntilTheyAreCleared) {
  choose_lesson(6);
  click(&view.set_up_button());
  wait_for("3000 mm/min");
  click(view.values()[2]);
  wait_for("1500 mm/min");
  const std::string rows = copied_tries(view);
  view.panel_actions()[2]->trigger();
  wait_for("–");
  view.panel_actions()[1]->trigger();
  wait_for("1500 mm/min");
  EXPECT_EQ(copied_tries(view), rows) << "of another question and back";
  choose_lesson(4);
  choose_lesson(6);
  EXPECT_EQ(copied_tries(view), rows) << "of another lesson and back";
  model.runs().history().undo();
  wait_for("3000 mm/min");
  EXPECT_EQ(copied_tries(view), rows) << "undoing a setting";
  view.panel_actions()[7]->trigger();
  EXPECT_THAT(QGuiApplication::clipboard()->text().toStdString(),
              testing::StartsWith("block_time_ms,cycle_time_s,change_percent,"));
  view.panel_actions()[8]->trigger();
  EXPECT_EQ(view.tries().rowCount(), 0);
  EXPECT_FALSE(view.panel_actions()[8]->isEnabled());
}

TEST_F(LessonViewTest, ClearingTheTriesCanBeUndone) {
  choose_lesson(6);
  click(&view.set_up_button());
  wait_for("3000 mm/min");
  ASSERT_TRUE(QTest::qWaitFor([&] { return view.tries().rowCount() == 1; }, patience));
  const std::string rows = copied_tries(view);
  view.own_answer().setPlainText("shorter periods");
  view.panel_actions()[8]->trigger();
  ASSERT_EQ(view.tries().rowCount(), 0);
  EXPECT_EQ(view.own_answer().toPlainText(), "shorter periods");
  EXPECT_EQ(model.runs().history().undoText(), "clear the values tried");
  model.runs().history().undo();
  EXPECT_EQ(copied_tries(view), rows);
  model.runs().history().redo();
  EXPECT_EQ(view.tries().rowCount(), 0);
  click(view.values()[2]);
  wait_for("1500 mm/min");
  ASSERT_TRUE(QTest::qWaitFor([&] { return view.tries().rowCount() == 1; }, patience));
  model.runs().history().undo();
  wait_for("3000 mm/min");
  model.runs().history().undo();
  EXPECT_EQ(copied_tries(view).substr(0, rows.size()), rows) << "the first ones in front";
  EXPECT_EQ(view.tries().rowCount(), 2) << "with what was tried meanwhile";
}

/// What has been tried since the tries were cleared is kept, whichever way the history goes.
TEST_F(LessonViewTest, UndoingAndRedoingAClearingKeepsWhatWasTriedSince) {
  choose_lesson(6);
  click(&view.set_up_button());
  wait_for("3000 mm/min");
  ASSERT_TRUE(QTest::qWaitFor([&] { return view.tries().rowCount() == 1; }, patience));
  const LessonWork before = desk.all_work();
  const auto place = before.begin()->first;
  LessonWork newer = before;
  view.panel_actions()[8]->trigger();
  newer[place].tries.front().cycle_time += 1;  // the same value again, of a changed lesson
  newer[place].tries.push_back({"0.5", 2, std::nullopt});
  desk.set_all_work(newer);
  model.runs().history().undo();
  EXPECT_EQ(desk.all_work().at(place).tries, newer[place].tries) << "each value with its newest result";
  model.runs().history().redo();
  EXPECT_EQ(desk.all_work().at(place).tries, newer[place].tries) << "those were not cleared";
}

TEST_F(LessonViewTest, AValueOfOnesOwnIsTriedAsTheSuggestedOnes) {
  choose_lesson(6);
  click(&view.set_up_button());
  wait_for("3000 mm/min");
  auto* field = view.own_value().findChild<QLineEdit*>();
  field->selectAll();
  QTest::keyClicks(field, "2.5");
  QTest::keyClick(field, Qt::Key_Return);
  wait_for("2400 mm/min");
  ASSERT_TRUE(QTest::qWaitFor([&] { return view.tries().rowCount() == 2; }, patience));
  EXPECT_EQ(view.tries().item(1, 0)->text(), "2.5");
  EXPECT_EQ(field->text(), "2.5\u00a0ms") << "without zeros after it";
  field->selectAll();
  QTest::keyClicks(field, "4");
  QTest::mouseClick(view.own_value().parentWidget()->findChild<QToolButton*>(), Qt::LeftButton);
  ASSERT_TRUE(QTest::qWaitFor([&] { return view.tries().rowCount() == 3; }, patience));
  EXPECT_EQ(view.tries().item(2, 0)->text(), "4") << "typed without Enter";
}

TEST_F(LessonViewTest, ALessonOfTheListClosesWhatWasShownWhileItAsksForAPrediction) {
  choose_lesson(6);
  click(&view.set_up_button());
  wait_for("3000 mm/min");
  ASSERT_NE(model.program(), nullptr);
  desk.unlock(false);
  choose_lesson(2);
  EXPECT_TRUE(desk.awaits_prediction());
  EXPECT_EQ(model.program(), nullptr) << "a run of another lesson";
}

/// A run with other changes than the question's is no try of it.
TEST_F(LessonViewTest, OnlyTheQuestionsSettingIsTried) {
  choose_lesson(6);
  click(&view.set_up_button());
  wait_for("3000 mm/min");
  ASSERT_TRUE(QTest::qWaitFor([&] { return view.tries().rowCount() == 1; }, patience));
  model.setup().set("compaction_mm", 0.01);
  ASSERT_TRUE(QTest::qWaitFor([&] { return model.busy(); }, patience));
  ASSERT_TRUE(QTest::qWaitFor([&] { return !model.busy(); }, patience));
  QTest::qWait(100);
  EXPECT_EQ(view.tries().rowCount(), 1);
}

TEST_F(LessonViewTest, AnAnswerOfOnesOwnStaysWithItsQuestion) {
  choose_lesson(6);
  view.own_answer().setFocus();
  QTest::keyClicks(&view.own_answer(), "Twice the feed.");
  view.panel_actions()[2]->trigger();
  EXPECT_EQ(view.own_answer().toPlainText(), "");
  QTest::keyClicks(&view.own_answer(), "No.");
  choose_lesson(4);
  EXPECT_EQ(view.own_answer().toPlainText(), "");
  choose_lesson(6);
  EXPECT_EQ(view.own_answer().toPlainText(), "Twice the feed.");
  ASSERT_EQ(desk.answers().size(), 2U);
}

TEST_F(LessonViewTest, TheSentenceToCompleteComesAfterTheLastQuestion) {
  choose_lesson(6);
  QAction* after = view.panel_actions()[2];
  after->trigger();
  after->trigger();
  EXPECT_TRUE(view.transfer().isVisible());
  EXPECT_FALSE(after->isEnabled());
  EXPECT_FALSE(view.panel_actions()[4]->isEnabled()) << "it has no answer";
  const QString sentence = view.transfer().toPlainText();
  EXPECT_THAT(sentence.toStdString(), testing::StartsWith("My control has a block processing time of … ms"));
  EXPECT_TRUE(desk.answers().empty());
  for (const int width : {360, 200}) {
    view.resize(width, 700);
    EXPECT_TRUE(
        QTest::qWaitFor([&] { return view.transfer().verticalScrollBar()->maximum() == 0; }, patience))
        << "in full";
  }
  view.transfer().setPlainText("My control has 2 ms.");
  choose_lesson(4);
  choose_lesson(6);
  EXPECT_FALSE(view.transfer().isVisible());
  EXPECT_EQ(view.transfer().toPlainText(), "My control has 2 ms.");
  EXPECT_EQ(work_on(*desk.lesson(), desk.all_work()).transfer, "My control has 2 ms.");
  view.transfer().setPlainText(sentence);
  EXPECT_TRUE(desk.answers().empty()) << "nothing is completed";
}

TEST_F(LessonViewTest, ValuesToSetHaveAUnit) {
  choose_lesson(6);
  EXPECT_EQ(view.own_value().suffix(), QStringLiteral("\u00a0ms"));
  click(&view.set_up_button());
  wait_for("3000 mm/min");
  ASSERT_TRUE(QTest::qWaitFor([&] { return view.tries().rowCount() == 1; }, patience));
  EXPECT_TRUE(view.tries().horizontalHeaderItem(0)->text().endsWith("[ms]"));
  bool named = false;
  for (const QLabel* label : view.findChildren<QLabel*>()) {
    named = named || label->text().contains("[ms]");
  }
  EXPECT_TRUE(named) << "above the buttons";
}

TEST_F(LessonViewTest, AnswersAQuestionByMovingTheControl) {
  choose_lesson(6);
  click(&view.set_up_button());
  wait_for("3000 mm/min");
  ASSERT_EQ(view.values().size(), 3);
  EXPECT_EQ(view.values()[0]->text(), "1");
  click(view.values()[2]);
  wait_for("1500 mm/min");
}

TEST_F(LessonViewTest, ShowsHintAndAnswerOnDemand) {
  choose_lesson(6);
  EXPECT_FALSE(view.expected().isVisible());
  EXPECT_EQ(view.expected().toPlainText(), "");
  constexpr QSize too_low(360, 420);
  view.resize(too_low);
  view.panel_actions()[4]->trigger();
  EXPECT_TRUE(view.expected().isVisible());
  EXPECT_THAT(view.expected().toPlainText().toStdString(),
              HasSubstr("with twice that the feed is half as high, 1500 mm\u2060/\u2060min"));
  EXPECT_GT(view.expected().mapTo(&view, QPoint()).y(), view.own_answer().mapTo(&view, QPoint()).y())
      << "below one's own";
  EXPECT_TRUE(
      QTest::qWaitFor([&] { return !view.expected().viewport()->visibleRegion().isEmpty(); }, patience))
      << "the panel scrolls to it";
  click(&view.answer_button());
  EXPECT_EQ(view.expected().toPlainText(), "");
  QAction* hint = view.panel_actions()[3];
  hint->trigger();
  EXPECT_THAT(view.expected().toPlainText().toStdString(), HasSubstr("mind the units"));
  EXPECT_THAT(question(), Not(HasSubstr("mind the units"))) << "the buttons below it stay in place";
}

TEST_F(LessonViewTest, StepsThroughTheQuestions) {
  choose_lesson(6);
  QAction* before = view.panel_actions()[1];
  QAction* after = view.panel_actions()[2];
  EXPECT_FALSE(before->isEnabled());
  click(&view.answer_button());
  after->trigger();
  EXPECT_THAT(question(), HasSubstr("The second row"));
  EXPECT_FALSE(view.answer_button().isChecked()) << "the next question hides its answer";
  EXPECT_EQ(view.values().size(), 5);
  EXPECT_TRUE(after->isEnabled()) << "the sentence follows";
  before->trigger();
  EXPECT_THAT(question(), HasSubstr("Which feed does the first row reach"));
}

TEST_F(LessonViewTest, SpeaksTheLanguageOfItsDesk) {
  LessonDesk french(model, "fr");
  french.unlock(true);
  LessonView other(french);
  QSignalSpy listed(&french, &LessonDesk::listed);
  other.show();
  ASSERT_TRUE(listed.wait(patience));
  EXPECT_THAT(other.list().toPlainText().toStdString(), HasSubstr("7. Droites, arcs, splines (20 min)"));
  QSignalSpy opened(&french, &LessonDesk::opened);
  french.open(find_lesson("6"));
  ASSERT_TRUE(opened.wait(patience));
  EXPECT_THAT(other.text().toPlainText().toStdString(), HasSubstr("anticipe 8 blocs"));
  EXPECT_THAT(other.question().toPlainText().toStdString(), HasSubstr("Quelle avance"));
  EXPECT_THAT(other.measured().toStdString(), HasSubstr("avance maximale"));
}

TEST_F(LessonViewTest, ShowsWhereTheControlIs) {
  choose_lesson(2);
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

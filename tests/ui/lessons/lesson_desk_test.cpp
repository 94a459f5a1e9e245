#include "ui/lessons/lesson_desk.h"
#include "tests/ui/patience.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QLocale>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <fstream>

namespace feedscope::ui {
namespace {

using testing::HasSubstr;

class LessonDeskTest : public testing::Test {
 protected:
  LessonDeskTest() { desk.unlock(true); }
  void open(const std::string& id) {
    QSignalSpy opened(&desk, &LessonDesk::opened);
    desk.open(find_lesson(id));
    ASSERT_TRUE(opened.wait(patience));
  }
  /// Until everything is simulated and `desk` has measured it.
  void wait_for(const QString& value) {
    EXPECT_TRUE(QTest::qWaitFor([&] { return !model.busy() && desk.value() == value; }, patience))
        << desk.value().toStdString() << " instead of " << value.toStdString();
  }

  Workbench model{shipped_machines(), make_setup({})};
  LessonDesk desk{model};
};

TEST_F(LessonDeskTest, ListsTheShippedLessons) {
  QSignalSpy listed(&desk, &LessonDesk::listed);
  desk.list();
  EXPECT_TRUE(desk.entries().empty()) << "they are read on another thread";
  ASSERT_TRUE(listed.wait(patience));
  ASSERT_EQ(desk.entries().size(), shipped_lessons().size());
  EXPECT_EQ(desk.entries()[3].title, "Chord tolerance and control tolerance");
  EXPECT_EQ(desk.entries()[3].minutes, 20);
  EXPECT_TRUE(desk.entries()[3].half_day);
  EXPECT_FALSE(desk.entries()[5].half_day);
}

TEST_F(LessonDeskTest, OpensALessonWithItsNumbersAndLeavesTheWindow) {
  open("8");
  EXPECT_THAT(desk.filled(desk.lesson()->text).toStdString(),
              HasSubstr("four full circles of radius 2.5\u00a0mm"));
  EXPECT_EQ(model.program(), nullptr);
  EXPECT_EQ(desk.value(), "");
}

TEST_F(LessonDeskTest, SetsUpProgramRunsAndView) {
  open("2");
  QSignalSpy view(&desk, &LessonDesk::view_wanted);
  desk.set_up_window();
  wait_for("0.767 s");
  EXPECT_EQ(model.file().filename(), "lesson_lines.nc");
  ASSERT_EQ(model.runs().items().size(), 4U);
  EXPECT_EQ(model.runs().current(), 0U);
  EXPECT_EQ(model.runs().items()[1].setup.file().model->info().id, "essid");
  EXPECT_EQ(std::get<double>(model.runs().items()[1].setup.value("X.acceleration")), 10);
  EXPECT_FALSE(model.runs().history().canUndo());
  EXPECT_EQ(view.count(), 1) << "once, when the first result is there";
}

TEST_F(LessonDeskTest, SetsUpTheWindowAtOnceIfAsked) {
  desk.open(find_lesson("6"), true);
  wait_for("3000 mm/min");
  EXPECT_EQ(model.file().filename(), "lesson_short_blocks.nc");
}

TEST_F(LessonDeskTest, TheStartIsWrittenAsEditsOfTheMachineFile) {
  open("6");
  desk.set_up_window();
  wait_for("3000 mm/min");
  const auto& edits = model.setup().state().edits();
  ASSERT_EQ(edits.size(), 2U);
  EXPECT_EQ(std::get<double>(edits.at("compaction_mm")), 0);
  EXPECT_EQ(std::get<double>(edits.at("block_time_ms")), 1);
}

TEST_F(LessonDeskTest, MovingTheControlChangesTheRunAndWhatItMeasures) {
  QLocale::setDefault(QLocale::c());
  open("6");
  desk.set_up_window();
  wait_for("3000 mm/min");
  desk.move_control("4");
  wait_for("1500 mm/min");
  model.runs().history().undo();
  wait_for("3000 mm/min");
}

TEST_F(LessonDeskTest, AQuestionMayNeedAnotherProgram) {
  open("6");
  desk.set_up_window();
  wait_for("3000 mm/min");
  desk.choose_question(1);
  QTest::qWait(50);
  EXPECT_EQ(desk.value(), "") << "of " << model.file();
  desk.move_control("4");
  EXPECT_TRUE(QTest::qWaitFor(
      [&] {
        return !model.busy() && model.file().filename() == "lesson_lookahead.nc" &&
               desk.value() == "2.38 m/min";
      },
      patience))
      << desk.value().toStdString();
}

TEST_F(LessonDeskTest, TheRunOfAQuestionHasNoNumberForTheNext) {
  QLocale::setDefault(QLocale::c());
  open("1");
  desk.set_up_window();
  wait_for("1.81");
  desk.move_control("cam");
  wait_for("1.00");
  desk.choose_question(1);
  QTest::qWait(50);
  EXPECT_EQ(desk.value(), "") << "the time of CAM is not that of an override";
  desk.move_control("100");
  wait_for("113.085 s");
  desk.choose_question(0);
  desk.move_control("ward");
  wait_for("1.81");
}

/// Whatever program another lesson or the user has left in the window, no number of it is the lesson's.
TEST_F(LessonDeskTest, ANumberIsOfTheLessonsOwnProgramOrNone) {
  open("6");
  desk.set_up_window();
  wait_for("3000 mm/min");
  open("12");
  EXPECT_EQ(desk.value(), "") << "of " << model.file();
  emit model.run_changed();
  QTest::qWait(50);
  EXPECT_EQ(desk.value(), "") << "of " << model.file();
  desk.set_up_window();
  wait_for("2.115 s");
  const QTemporaryDir folder;
  const std::filesystem::path own = folder.filePath("own.nc").toStdString();
  std::ofstream(own) << "G21 G90 G94 F1000\nG1 X10\nG1 X10 Y10\nM30\n";
  model.open(own);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !model.busy() && model.shown() != nullptr; }, patience));
  QTest::qWait(50);
  EXPECT_EQ(desk.value(), "") << "of " << model.file();
}

TEST_F(LessonDeskTest, QuestionsStayWithinTheLesson) {
  open("6");
  desk.choose_question(2);
  EXPECT_EQ(desk.question(), 0U);
  desk.choose_question(1);
  EXPECT_EQ(desk.question(), 1U);
  open("7");
  EXPECT_EQ(desk.question(), 0U);
}

TEST_F(LessonDeskTest, ThePredictionComesBeforeTheRun) {
  desk.unlock(false);
  model.open(std::filesystem::path(FEEDSCOPE_SOURCE_DIR) / "resources/programs/tapie_circle_30.nc");
  ASSERT_TRUE(QTest::qWaitFor([&] { return !model.busy() && model.shown() != nullptr; }, patience));
  QSignalSpy begins(&desk, &LessonDesk::set_up_begins);
  QSignalSpy opened(&desk, &LessonDesk::opened);
  desk.open(find_lesson("6"), true);
  ASSERT_TRUE(opened.wait(patience));
  EXPECT_TRUE(desk.awaits_prediction());
  EXPECT_EQ(begins.count(), 1) << "what was in the window is set aside";
  EXPECT_EQ(model.program(), nullptr) << "neither path nor charts of anything";
  EXPECT_TRUE(model.file().empty());
  EXPECT_EQ(model.setup().setup().machine.id, "huron-kx10") << "the lesson's, of which the text speaks";
  EXPECT_EQ(std::get<double>(model.setup().state().value("block_time_ms")), 1);
  desk.set_up_window();
  desk.move_control("1");
  desk.predict("  ");
  EXPECT_FALSE(model.busy());
  EXPECT_TRUE(desk.awaits_prediction());
  desk.predict("3 m/min\n");
  EXPECT_FALSE(desk.awaits_prediction());
  EXPECT_EQ(desk.prediction(), "3 m/min");
  wait_for("3000 mm/min");
  desk.predict("6 m/min");
  EXPECT_EQ(desk.prediction(), "3 m/min") << "it has been written down";
  EXPECT_EQ(desk.answers().size(), 1U) << "so that it is asked for before it is lost";
  desk.open(find_lesson("6"), true);
  ASSERT_TRUE(opened.wait(patience));
  wait_for("3000 mm/min");
}

TEST_F(LessonDeskTest, ATeacherShowsTheRunOfOneLessonOrOfAllWithoutAPrediction) {
  desk.unlock(false);
  QSignalSpy opened(&desk, &LessonDesk::opened);
  desk.open(find_lesson("6"), true);
  ASSERT_TRUE(opened.wait(patience));
  desk.reveal();
  EXPECT_FALSE(desk.awaits_prediction());
  wait_for("3000 mm/min");
  desk.open(find_lesson("12"), true);
  ASSERT_TRUE(opened.wait(patience));
  EXPECT_TRUE(desk.awaits_prediction()) << "that was one lesson";
  desk.open(find_lesson("6"), true);
  ASSERT_TRUE(opened.wait(patience));
  EXPECT_FALSE(desk.awaits_prediction()) << "it stays shown";
  desk.open(find_lesson("12"), true);
  ASSERT_TRUE(opened.wait(patience));
  desk.unlock(true);
  EXPECT_FALSE(desk.awaits_prediction());
  desk.set_up_window();
  wait_for("2.115 s");
  EXPECT_TRUE(desk.answers().empty());
}

TEST_F(LessonDeskTest, APredictionThatIsNotWrittenDownYetIsThereAgainWithItsLesson) {
  desk.unlock(false);
  const auto open_again = [&](LessonDesk& in, const char* number) {
    QSignalSpy again(&in, &LessonDesk::opened);
    in.open(find_lesson(number));
    ASSERT_TRUE(again.wait(patience));
  };
  open_again(desk, "6");
  desk.set_draft("3 m/m");
  open_again(desk, "12");
  EXPECT_EQ(desk.draft(), "");
  open_again(desk, "6");
  EXPECT_EQ(desk.draft(), "3 m/m");
  EXPECT_TRUE(desk.awaits_prediction());
  EXPECT_TRUE(desk.answers().empty());

  LessonDesk french(model, "fr");
  french.set_covers(desk.covers());
  open_again(french, "6");
  EXPECT_EQ(french.draft(), "3 m/m") << "the window in another language";
  french.predict("3 m/min");
  EXPECT_EQ(french.draft(), "");
}

TEST_F(LessonDeskTest, WorkOnALessonIsForItsSheet) {
  open("6");
  LessonWork work;
  work[{"06_blocks_too_short", prediction}].answer = "3 m/min ";
  work[{"06_blocks_too_short", 1}] = {"17", "lookahead_blocks", "peak_feed_m_min", {{"17", 2, 6}}};
  work[{"06_blocks_too_short", 0}] = {"half", "another_setting", "peak_feed_mm_min", {{"17", 2, 6}}};
  work[{"07_lines_arcs_splines", 0}].answer = "of another lesson";
  const LearnersWork made = work_on(*desk.lesson(), work);
  EXPECT_EQ(made.prediction, "3 m/min");
  ASSERT_EQ(made.answers.size(), 2U);
  EXPECT_EQ(made.answers[0].text, "half");
  EXPECT_TRUE(made.answers[0].tries.empty()) << "of an older version of the lesson";
  EXPECT_EQ(made.answers[1].text, "17");
  EXPECT_EQ(made.answers[1].tries.size(), 1U);
}

class FrenchLessonDesk : public LessonDeskTest {
 protected:
  FrenchLessonDesk() { french.unlock(true); }
  LessonDesk french{model, "fr"};
};

TEST_F(FrenchLessonDesk, ListsOpensAndMeasuresInFrench) {
  QSignalSpy listed(&french, &LessonDesk::listed);
  french.list();
  ASSERT_TRUE(listed.wait(patience));
  EXPECT_EQ(french.entries()[3].title, "Tolérance de corde et tolérance de commande");
  EXPECT_TRUE(french.entries()[3].learn.startsWith("Choisir ensemble"));
  french.open(find_lesson("12"), true);
  EXPECT_TRUE(QTest::qWaitFor([&] { return french.value() == "2,115\u00a0s"; }, patience))
      << french.value().toStdString();
  EXPECT_EQ(french.watched(), "temps de cycle, ligne 4");
  EXPECT_THAT(french.filled(french.lesson()->text).toStdString(), HasSubstr("met 2,1155\u00a0s"));
}

TEST_F(LessonDeskTest, SaysWhatIsWrongWithAFile) {
  const QTemporaryDir folder;
  const auto file = std::filesystem::path(folder.path().toStdString()) / "wrong.toml";
  std::ofstream(file) << "titel = \"x\"\n";
  QSignalSpy failed(&desk, &LessonDesk::failed);
  desk.open(file);
  ASSERT_TRUE(failed.wait(patience));
  EXPECT_THAT(failed[0][0].toString().toStdString(), HasSubstr("did you mean 'title'?"));
  EXPECT_EQ(desk.lesson(), nullptr);
  desk.set_up_window();
  desk.move_control("1");
  desk.choose_question(1);
  EXPECT_EQ(desk.question(), 0U);
}

TEST_F(LessonDeskTest, GoesWhileItReads) {
  desk.list();
  desk.open(find_lesson("2"));
  desk.open(find_lesson("4"));
}

}  // namespace
}  // namespace feedscope::ui

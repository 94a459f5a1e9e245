#include "tests/app/command_line.h"

namespace feedscope::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

class LessonsCommand : public CommandLine {
 protected:
  /// A lesson of one claim.
  void write_lesson(const std::string& bound, const std::string& answer = "It is {time}.") const {
    write("mine.toml",
          "title = \"Mine\"\nlearn = \"A corner.\"\nminutes = 5\nsources = [\"Nobody\"]\n"
          "text = \"A *corner*.\\n\\n- one\\n- two\\n\"\n"
          "[start]\nprogram = \"corner.nc\"\nmachine = \"spinner-mvc850\"\nmodel = \"cam\"\n"
          "[numbers]\ntime = { measure = \"cycle_time_s\" }\n"
          "[[question]]\ntext = \"How long?\"\ncontrol = { key = \"model\", values = [\"cam\"] }\n"
          "watch = { measure = \"cycle_time_s\" }\nanswer = \"" +
              answer + "\"\n[[question.claim]]\nmeasure = \"cycle_time_s\"\nless_than = " + bound + "\n");
  }
};

TEST_F(LessonsCommand, ListsLessons) {
  const Result result = run("lessons");
  EXPECT_EQ(result.code, 0);
  EXPECT_THAT(result.out, AllOf(HasSubstr("08_small_circle: Small circles and approaches (20 min, half day)"),
                                HasSubstr("09_trochoid_or_slot: Trochoid or full slot (20 min)"),
                                HasSubstr("Half a day, 140 minutes: lessons 1, 2, 3, 4, 5, 8, 12")));
}

TEST_F(LessonsCommand, ShowsOneWithMeasuredNumbersAndAnswers) {
  const Result result = run("lessons 04_small_circle");  // as it was called before
  EXPECT_EQ(result.code, 0);
  EXPECT_THAT(
      result.out,
      AllOf(HasSubstr("Small circles and approaches (20 minutes)"), HasSubstr("2.01 m/min"),
            HasSubstr("Before you look"), HasSubstr("Question 2"), HasSubstr("X.jerk: 5, 10"),
            HasSubstr("On my control"), HasSubstr("Answers"), HasSubstr("Sources"), Not(HasSubstr("{"))));
}

TEST_F(LessonsCommand, ShowsALessonFileBesideItsProgram) {
  write_lesson("0.9");
  const Result result = run("lessons mine.toml");
  EXPECT_EQ(result.code, 0);
  EXPECT_THAT(result.out, AllOf(HasSubstr("A corner.\n\n- one\n- two\n"), HasSubstr("It is 0.800 s.")));
}

TEST_F(LessonsCommand, ChecksClaims) {
  write_lesson("0.9");
  const Result holds = run("lessons mine.toml --check");
  EXPECT_EQ(holds.code, 0);
  EXPECT_THAT(holds.out, AllOf(HasSubstr("holds"), Not(HasSubstr("FAILS")), Not(HasSubstr("note"))));

  write_lesson("0.7");
  const Result fails = run("lessons mine.toml --check");
  EXPECT_EQ(fails.code, 1);
  EXPECT_THAT(fails.out, AllOf(HasSubstr("FAILS"), HasSubstr("0.80000 s, expected less than 0.7 s"),
                               HasSubstr("mine.toml:17:"), HasSubstr("1 claim does not hold")));
}

TEST_F(LessonsCommand, NotesNumbersThatNothingChecks) {
  write_lesson("0.9", "It is 0.8 s.");
  const Result result = run("lessons mine.toml --check");
  EXPECT_EQ(result.code, 0);
  EXPECT_THAT(result.out, HasSubstr("note   nothing checks the number 0.8 in the answer of question 1"));
}

TEST_F(LessonsCommand, SpeaksFrench) {
  EXPECT_THAT(run("lessons --language fr").out,
              HasSubstr("08_small_circle: Petits cercles et approches (20 min, demi-journée)"));
  const Result result = run("lessons 8 --language fr");
  EXPECT_EQ(result.code, 0);
  EXPECT_THAT(result.out, AllOf(HasSubstr("2,01\u00a0m/min"), HasSubstr("Indice    Cliquez sur les"),
                                HasSubstr("Observer  avance maximale, ligne 16"), HasSubstr("Réponses"),
                                Not(HasSubstr("{"))));
  EXPECT_EQ(run("lessons 2 --language fr --out handout.html").code, 0);
  EXPECT_THAT(contents(folder_ / "handout.html"),
              AllOf(HasSubstr("lang=\"fr\""), HasSubstr("2,115\u00a0s"), HasSubstr(">Réponses</h1>")));
  expect_wrong_use("lessons 4 --language de", "--language: de not in {en,fr}");
}

/// A lesson of one's own needs no translation; one that has begun with it is told what is missing.
TEST_F(LessonsCommand, ALessonWithoutTranslationIsShownInEnglish) {
  write_lesson("0.9");
  EXPECT_THAT(run("lessons mine.toml --language fr").out,
              AllOf(HasSubstr("It is 0.800 s."), HasSubstr("Answers")))
      << "headings as well";
  EXPECT_THAT(run("lessons mine.toml --check").out, Not(HasSubstr("note")));
}

TEST_F(LessonsCommand, ChecksTranslations) {
  write_lesson("0.9");
  std::string lesson = contents(folder_ / "mine.toml");
  lesson.replace(lesson.find("[start]"), 7, "[fr]\ntext = \"Il faut 0,8 s.\"\n[start]");
  write("mine.toml", lesson);
  const Result result = run("lessons mine.toml --check");
  EXPECT_EQ(result.code, 0);
  EXPECT_THAT(result.out, AllOf(HasSubstr("note   nothing checks the number 0,8 in the text (fr)"),
                                HasSubstr("note   no translation of 'title' of the file (fr)"),
                                HasSubstr("note   no translation of 'answer' of question 1 (fr)"),
                                Not(HasSubstr("'hint'"))));
}

TEST_F(LessonsCommand, WritesAHandOut) {
  const Result result = run("lessons 2 --out handout.html");
  EXPECT_EQ(result.code, 0);
  EXPECT_EQ(result.out, "");
  EXPECT_THAT(contents(folder_ / "handout.html"),
              AllOf(HasSubstr("<!DOCTYPE html>"), HasSubstr("2.115\u00a0s")));
  EXPECT_EQ(run("lessons 2 --out -").out, contents(folder_ / "handout.html"));
}

#ifdef FEEDSCOPE_WITH_UI
TEST_F(LessonsCommand, WritesAHandOutOnPages) {
  EXPECT_EQ(run("lessons 2 --out handout.pdf").code, 0);
  const std::string pdf = contents(folder_ / "handout.pdf");
  EXPECT_THAT(pdf, StartsWith("%PDF-"));
  run("lessons 2 --out again.pdf");
  EXPECT_EQ(contents(folder_ / "again.pdf"), pdf);
}

TEST_F(LessonsCommand, TheWindowOpensWithALesson) {
  expect_wrong_use("--lesson small_circel", "did you mean '08_small_circle'?");
  EXPECT_THAT(run("--lesson 4", no_display).err, HasSubstr("the window needs a display"));
}
#endif

TEST_F(LessonsCommand, AHandOutIsForItsReader) {
  EXPECT_EQ(run("lessons 2 --for learners --out sheet.html").code, 0);
  EXPECT_THAT(contents(folder_ / "sheet.html"), AllOf(HasSubstr("Question 1"), Not(HasSubstr("Answer"))));
  EXPECT_EQ(run("lessons 2 --for teacher --out key.html").code, 0);
  write("work.feedscope",
        "{\"format\": \"feedscope-session\", \"version\": 1, \"predictions\": {\"02_data_sheet\": \"A "
        "guess.\"}, \"transfers\": {\"02_data_sheet\": \"My machine has 0.4 g.\"}, "
        "\"lessons\": []}");
  EXPECT_EQ(run("lessons 2 --for learners --session work.feedscope --out mine.html").code, 0);
  EXPECT_THAT(contents(folder_ / "mine.html"),
              AllOf(HasSubstr("A guess."), HasSubstr("My machine has 0.4 g."), Not(HasSubstr("________"))));
  expect_wrong_use("lessons 2 --for teacher --session work.feedscope --out x.html", "--for learners");
  expect_wrong_use("lessons 2 --session none.feedscope --out x.html", "none.feedscope");
  EXPECT_THAT(contents(folder_ / "key.html"), AllOf(HasSubstr("Answer"), HasSubstr("Computed")));
  expect_wrong_use("lessons 8 --for pupils --out x.html",
                   "--for: pupils not in {everybody,learners,teacher}");
  expect_wrong_use("lessons 8 --for learners", "--for requires --out");
}

TEST_F(LessonsCommand, SaysWhatIsWrong) {
  expect_wrong_use("lessons nothing_like_it", "unknown lesson 'nothing_like_it': no id and no file");
  expect_wrong_use("lessons smal_circle", "did you mean '08_small_circle'?");
  expect_wrong_use("lessons --out x.html", "--out writes one lesson: give its ID");
  expect_wrong_use("lessons corner.nc", "not valid TOML");
  expect_wrong_use("lessons 4 --out nowhere/x.html", "nowhere/x.html");
  expect_wrong_use("lessons 4 --out x.docx", "--out 'x.docx' does not state the format");
  expect_wrong_use("lessons 4 --out x", "--out 'x' does not state the format");
  expect_wrong_use("lessons 0", "unknown lesson '0': no id and no file; numbers 1 to 12, or ids: ");
  write_lesson("\"x\"");
  expect_wrong_use("lessons mine.toml", "mine.toml:19:13: 'less_than' in claim 1 of question 1 is 'x'");
  write_lesson("0.9");
  expect_wrong_use("lessons mine.toml --out mine.toml", "mine.toml");
  write("corner.nc", "G1 X20 F3000\nfoo\n");
  expect_wrong_use("lessons mine.toml", "has an error on line 2");
}

}  // namespace
}  // namespace feedscope::test

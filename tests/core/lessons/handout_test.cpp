#include "core/lessons/handout.h"

#include "core/base/error.h"
#include "core/base/markdown.h"
#include "core/lessons/lesson_runs.h"
#include "tests/core/lessons/lesson_folder.h"

namespace feedscope {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class Handout : public test::LessonFolder {};

TEST_F(Handout, MarkdownBecomesHtml) {
  EXPECT_EQ(markdown_as_html("A *b* **c** `d`"), "<p>A <em>b</em> <strong>c</strong> <code>d</code></p>\n");
  EXPECT_EQ(markdown_as_html("- x < y"), "<ul>\n<li>x &lt; y</li>\n</ul>\n");
  EXPECT_THAT(markdown_as_html("<script>alert(1)</script>"), Not(HasSubstr("<script>")));
}

TEST_F(Handout, HoldsTheLessonAndItsAnswersAtTheEnd) {
  const Lesson lesson = read_lesson(changed("title = \"Test\"", "title = \"A < B & C\""));
  const std::string html =
      handout_html(lesson, {HandoutReader::everybody,
                            {{"time", "1.23 s"}, {"less", "12 %"}, {"feed", "3000 mm/min"}},
                            {},
                            {},
                            {},
                            {}});
  EXPECT_THAT(html, AllOf(HasSubstr("<h1>A &lt; B &amp; C</h1>"),
                          HasSubstr("It takes 1.23\u00a0s at 3000\u00a0mm/min."), HasSubstr("How long?"),
                          HasSubstr("tolerance: 0.05, 0.1"), HasSubstr("time limited by axis jerk [s]"),
                          HasSubstr("<b>First set</b> lookahead_blocks: 4"), HasSubstr("Look."),
                          HasSubstr("Nobody 2020"), HasSubstr("lesson_right_angle.nc"),
                          HasSubstr("Spinner MVC 850")));
  EXPECT_THAT(html, Not(HasSubstr("http"))) << "nothing is loaded from elsewhere";
  const std::size_t answers = html.find(">Answers</h1>");
  ASSERT_NE(answers, std::string::npos);
  EXPECT_GT(html.find("12\u00a0% less."), answers);
  EXPECT_LT(html.find("How long?"), answers);
}

TEST_F(Handout, LearnersGetThePredictionFirstThenRoomForTheirValuesAndNoHelp) {
  const Lesson lesson = read_lesson(find_lesson("small_circle"));
  LessonRuns runs(lesson);
  const HandoutContents contents = handout_contents(lesson, runs, HandoutReader::learners);
  EXPECT_TRUE(contents.claims.empty());
  const std::string html = handout_html(lesson, contents);
  EXPECT_THAT(html, AllOf(HasSubstr("Which feed do the circles of"), HasSubstr("class=\"lines\""),
                          HasSubstr("<th width=\"34%\">X.jerk</th>"), HasSubstr("<td>my value:</td>")));
  EXPECT_LT(html.find("Before you look"), html.find("Question 1"));
  EXPECT_GT(html.find("On my control"), html.find("Question 2"));
  EXPECT_THAT(html, AllOf(HasSubstr("a radius of __________ mm allows"), Not(HasSubstr("…"))));
  EXPECT_THAT(html, AllOf(Not(HasSubstr("All four of")), Not(HasSubstr("Answer")), Not(HasSubstr("Hint")),
                          Not(HasSubstr("Sources"))));
}

TEST_F(Handout, ALearnersOwnSheetHasWhatWasWrittenAndTried) {
  const Lesson lesson = read_lesson(find_lesson("small_circle"));
  LessonRuns runs(lesson);
  HandoutContents contents = handout_contents(lesson, runs, HandoutReader::learners);
  const std::string blank = handout_html(lesson, contents);
  contents.work.prediction = "2 m/min <\nand 10";
  contents.work.answers = {{}, {"A root.", {{"10", 12.0964, 5.8791}, {"7.5", 13.5, {}}}}};
  const std::string html = handout_html(lesson, contents);
  EXPECT_THAT(
      html, AllOf(HasSubstr("2 m/min &lt;<br>and 10"), HasSubstr("A root."),
                  HasSubstr("<td>10</td><td>12.096</td><td>5.88</td>"), HasSubstr("<td>my value: 7.5</td>")));
  const auto lines = [](const std::string& text) {
    std::size_t count = 0;
    for (std::size_t at = 0; (at = text.find("class=\"lines\"", at)) != std::string::npos; ++at) {
      ++count;
    }
    return count;
  };
  EXPECT_EQ(lines(html), lines(blank) - 2) << "room to write only where nothing is written";
}

TEST_F(Handout, CallsSettingsAsItIsTold) {
  const Lesson lesson = read_lesson(find_lesson("small_circle"));
  LessonRuns runs(lesson);
  HandoutContents contents = handout_contents(lesson, runs, HandoutReader::learners);
  contents.words.title = [](const std::string& key) { return "<" + key + ">"; };
  const std::string html = handout_html(lesson, contents);
  EXPECT_THAT(html,
              AllOf(HasSubstr("<th width=\"34%\">&lt;X.jerk&gt;</th>"), HasSubstr("&lt;X.jerk&gt;: 5, 10")));
}

TEST_F(Handout, FormulasAndUnitsAreNotParted) {
  const Lesson lesson = read_lesson(find_lesson("data_sheet"));
  LessonRuns runs(lesson);
  const std::string html = handout_html(lesson, handout_contents(lesson, runs, HandoutReader::teacher));
  EXPECT_THAT(html, AllOf(HasSubstr("Δv\u00a0≤ A²\u00a0/\u00a0J"), HasSubstr("100\u00a0mm at 3\u00a0m/min")));
}

TEST_F(Handout, TheChartsFollowThePrediction) {
  const Lesson lesson = read_lesson(find_lesson("small_circle"));
  LessonRuns runs(lesson);
  HandoutContents contents = handout_contents(lesson, runs, HandoutReader::teacher);
  contents.figures = "PATH";
  contents.charts = "CHARTS";
  const std::string html = handout_html(lesson, contents);
  EXPECT_LT(html.find("PATH"), html.find("Before you look"));
  EXPECT_LT(html.find("Before you look"), html.find("CHARTS"));
  EXPECT_LT(html.find("CHARTS"), html.find("Question 1"));
}

TEST_F(Handout, TheTeacherGetsAnswersAndWhatTheyBuildOn) {
  const Lesson lesson = read_lesson(find_lesson("small_circle"), "fr");
  LessonRuns runs(lesson);
  const std::string html = handout_html(lesson, handout_contents(lesson, runs, HandoutReader::teacher));
  EXPECT_THAT(html, AllOf(HasSubstr("atteignent 2,01\u00a0m/min"), HasSubstr("Calculé"), HasSubstr("Indice"),
                          HasSubstr("Sources"), HasSubstr("environ 2,01\u00a0m/min, à 0,5\u00a0% près"),
                          HasSubstr(">2,008\u00a0m/min</td>"), HasSubstr("divisé par la valeur avec")));
  EXPECT_THAT(html, AllOf(Not(HasSubstr("class=\"lines\"")), Not(HasSubstr("non vérifié"))));
}

TEST_F(Handout, SaysWhatNoLongerHolds) {
  const Lesson lesson = read_lesson(find_lesson("small_circle"));
  LessonRuns runs(lesson);
  HandoutContents contents = handout_contents(lesson, runs, HandoutReader::teacher);
  contents.claims[0][0].holds = false;
  EXPECT_THAT(handout_html(lesson, contents), HasSubstr("does not hold"));
}

TEST_F(Handout, ReadersHaveNames) {
  EXPECT_EQ(handout_reader("teacher"), HandoutReader::teacher);
  EXPECT_EQ(handout_reader("everybody"), HandoutReader::everybody);
  EXPECT_THROW(handout_reader("pupils"), InputError);
}

}  // namespace
}  // namespace feedscope

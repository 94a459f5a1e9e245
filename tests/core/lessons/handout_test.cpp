#include "core/lessons/handout.h"

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
      handout_html(lesson, {{"time", "1.23 s"}, {"less", "12 %"}, {"feed", "3000 mm/min"}});
  EXPECT_THAT(html, AllOf(HasSubstr("<h1>A &lt; B &amp; C</h1>"),
                          HasSubstr("It takes 1.23 s at 3000 mm/min."), HasSubstr("How long?"),
                          HasSubstr("tolerance: 0.05, 0.1"), HasSubstr("time limited by axis jerk [s]"),
                          HasSubstr("<b>First set</b> <code>lookahead_blocks=4"), HasSubstr("Look."),
                          HasSubstr("Nobody 2020"), HasSubstr("lesson_right_angle.nc"),
                          HasSubstr("Spinner MVC 850")));
  EXPECT_THAT(html, Not(HasSubstr("http"))) << "nothing is loaded from elsewhere";
  const std::size_t answers = html.find(">Answers</h1>");
  ASSERT_NE(answers, std::string::npos);
  EXPECT_GT(html.find("12 % less."), answers);
  EXPECT_LT(html.find("How long?"), answers);
}

}  // namespace
}  // namespace feedscope

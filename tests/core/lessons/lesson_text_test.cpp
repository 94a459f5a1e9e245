#include "core/lessons/lesson_text.h"

#include "tests/core/lessons/lesson_folder.h"

namespace feedscope {
namespace {

using testing::ElementsAre;

class LessonText : public test::LessonFolder {};

TEST_F(LessonText, NumbersArePutIntoTheirPlaces) {
  EXPECT_EQ(filled("{a} and {b}, {{c}", {{"a", "1 s"}, {"b", "2 mm"}}), "1 s and 2 mm, {c}");
  EXPECT_EQ(filled("", WrittenNumbers()), "");
}

TEST_F(LessonText, ClaimsAreSaidInWords) {
  const Lesson lesson = read_lesson(write(good_lesson));
  const auto& claims = lesson.questions[0].claims;
  EXPECT_EQ(quantity_text(claims[0].quantity), "cycle time with tolerance=0.2");
  EXPECT_EQ(expectation_text(claims[0]), "less than that with tolerance=0.1");
  EXPECT_EQ(quantity_text(claims[1].quantity), "largest feed, line 4 as the lesson begins");
  EXPECT_EQ(expectation_text(claims[1]), "about 3000 mm/min, within 1 %");
  EXPECT_EQ(expectation_text(claims[2]), "between 0.1 m/min and 1 m/min");
  EXPECT_EQ(quantity_text(lesson.numbers.at("less")),
            "cycle time with model=cam, in percent less than that as the lesson begins");
  EXPECT_EQ(value_text(lesson.numbers.at("less"), 12.34), "12 %");
  EXPECT_EQ(value_text(lesson.numbers.at("time"), 1.2345), "1.23 s");
  EXPECT_EQ(control_text(lesson.questions[0].control), "tolerance: 0.05, 0.1");
}

TEST_F(LessonText, SettingsAreCalledAsPeopleDo) {
  const Lesson lesson = read_lesson(write(good_lesson));
  const auto& claims = lesson.questions[0].claims;
  SettingWords words;
  words.title = [](const std::string& key) { return key == "tolerance" ? "Contour tolerance [mm]" : key; };
  words.value = [](const std::string&, const std::string& value) { return "(" + value + ")"; };
  EXPECT_EQ(quantity_text(claims[0].quantity, "en", words), "cycle time with Contour tolerance [mm]: 0.2");
  EXPECT_EQ(expectation_text(claims[0], "en", words), "less than that with Contour tolerance [mm]: 0.1");
  EXPECT_EQ(quantity_text(lesson.numbers.at("less"), "en", words),
            "cycle time with model: (cam), in percent less than that as the lesson begins");
  EXPECT_EQ(control_text(lesson.questions[0].control, "fr", words),
            "Contour tolerance [mm]\u00a0: 0,05\u00a0; 0,1");
  EXPECT_EQ(change_text("lookahead=off", "en", words), "lookahead: (off)");
}

TEST_F(LessonText, SettingsOfTheQuestionAreNotRepeated) {
  const Lesson lesson = read_lesson(write(good_lesson));
  LessonQuantity quantity = lesson.numbers.at("less");
  SettingWords words;
  words.title = [](const std::string& key) { return key; };
  words.of_question = {"model=cam", "X.kv=30"};
  quantity.with = {"model=cam", "X.kv=30", "tolerance=0.2"};
  quantity.against = Changes{"model=cam", "X.kv=30"};
  EXPECT_EQ(quantity_text(quantity, "en", words),
            "cycle time with the question's settings and tolerance: 0.2, in percent less than that as the "
            "question begins");
  quantity.with = {"model=cam", "tolerance=0.2"};  // only a part of them
  EXPECT_EQ(quantity_text(quantity, "en", words),
            "cycle time with model: cam; tolerance: 0.2, in percent less than that as the question begins");
}

TEST_F(LessonText, NumbersThatNothingChecksAreFound) {
  EXPECT_THAT(unchecked_numbers(read_lesson(write(good_lesson))), testing::IsEmpty());
  EXPECT_THAT(unchecked_numbers(read_lesson(changed("\"Look.\"", "\"It takes 4.2 s, or 12 blocks.\""))),
              ElementsAre("4.2 in the hint of question 1", "12 in the hint of question 1"));
  EXPECT_THAT(unchecked_numbers(read_lesson(changed("\"Look.\"", "\"It takes 7 s.\""))),
              ElementsAre("7 in the hint of question 1"));
  // A value of the control, a year of the sources, a count, a name.
  EXPECT_THAT(unchecked_numbers(read_lesson(changed(
                  "\"Look.\"", "\"At 0.05 mm, Nobody 2020 saw 3 of them on the 840D, as R^(2/3).\""))),
              testing::IsEmpty());
}

}  // namespace
}  // namespace feedscope

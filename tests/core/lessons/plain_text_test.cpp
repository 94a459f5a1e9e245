#include "core/lessons/plain_text.h"

#include <gmock/gmock.h>

#include <regex>

#include "core/base/markdown.h"
#include "core/lessons/handout.h"
#include "core/lessons/lesson.h"

namespace feedscope {
namespace {

using testing::ElementsAre;
using testing::Field;
using testing::HasSubstr;
using testing::Not;

TEST(PlainText, MarksOfMarkdownAreGone) {
  EXPECT_EQ(plain_line("A *b* **c** `d_e` [f](g.html)\nh"), "A b c d_e f h");
  EXPECT_EQ(plain_line("2 * 3 * 4 < 5 & x_1_2"), "2 * 3 * 4 < 5 & x_1_2");
}

TEST(PlainText, ListsAndCodeAreBlocksOfTheirOwn) {
  const auto blocks = plain_blocks("Two:\n\n1. one\n   more\n2. *two*\n\nEnd\n\n    v = x * y\n    w\n");
  EXPECT_THAT(blocks, ElementsAre(Field(&PlainBlock::text, "Two:"), Field(&PlainBlock::text, "one more"),
                                  Field(&PlainBlock::text, "two"), Field(&PlainBlock::text, "End"),
                                  Field(&PlainBlock::text, "v = x * y"), Field(&PlainBlock::text, "w")));
  EXPECT_EQ(blocks[1].marker, "1. ");
  EXPECT_EQ(blocks[1].indent, 3U);
  EXPECT_FALSE(blocks[1].follows);
  EXPECT_TRUE(blocks[2].follows);
  EXPECT_TRUE(blocks[4].code && blocks[5].code);
  EXPECT_TRUE(blocks[5].follows && !blocks[4].follows);
}

std::string letters(const std::string& text) {
  static const std::regex blanks("\\s+");
  return std::regex_replace(text, blanks, "");
}

/// What a browser shows of it, without blanks and the marks of lists.
std::string shown_letters(const std::string& markdown) {
  static const std::regex tags("<[^>]*>");
  std::string text = std::regex_replace(markdown_as_html(markdown), tags, "");
  for (const auto& [entity, sign] :
       {std::pair{"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&amp;", "&"}}) {
    text = std::regex_replace(text, std::regex(entity), sign);
  }
  return letters(text);
}

TEST(PlainText, SaysWhatTheHandOutSaysForEveryText) {
  std::size_t marked = 0;
  for (const auto& file : shipped_lessons()) {
    const Lesson lesson = read_lesson(file);
    std::vector<std::string> texts{lesson.text};
    for (const Question& question : lesson.questions) {
      texts.insert(texts.end(), {question.text, question.hint, question.answer});
    }
    for (const std::string& text : texts) {
      std::string plain;
      for (const PlainBlock& block : plain_blocks(text)) {
        plain += block.text;
      }
      EXPECT_EQ(letters(plain), shown_letters(text)) << lesson.id;
      EXPECT_THAT(plain, Not(HasSubstr("**"))) << lesson.id;
      marked += text.find("**") != std::string::npos ? 1U : 0U;
    }
  }
  EXPECT_GE(marked, 5U) << "the lessons have something to show";
}

}  // namespace
}  // namespace feedscope

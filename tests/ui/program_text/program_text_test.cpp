#include "ui/program_text/program_text.h"

#include <gtest/gtest.h>

#include "tests/ui/program_fixture.h"

namespace feedscope::ui {
namespace {

using test::program_of;

TEST(ProgramText, WithoutAProgramIsEmpty) {
  const ProgramText text;
  EXPECT_EQ(text.line_count(), 0U);
  EXPECT_EQ(text.clamped({7, 3}), TextPlace());
  EXPECT_EQ(text.text({{1, 0}, {9, 9}}), QString());
}

TEST(ProgramText, TextOfARangeGoesOverLines) {
  const ProgramText text(program_of("G1 X5\r\nY7\r\nM30"));
  EXPECT_EQ(text.text({{1, 3}, {1, 5}}), "X5");
  EXPECT_EQ(text.text({{1, 3}, {3, 1}}), "X5\nY7\nM");
  EXPECT_EQ(text.text({{1, 0}, {99, 0}}), "G1 X5\nY7\nM30");
  EXPECT_EQ(text.text({{2, 1}, {2, 1}}), "");
}

TEST(ProgramText, StepsOverCharactersAndLines) {
  const ProgramText text(program_of("\u00fcX\nY"));
  EXPECT_EQ(text.after({1, 0}), (TextPlace{1, 2}));  // two bytes
  EXPECT_EQ(text.before({1, 2}), (TextPlace{1, 0}));
  EXPECT_EQ(text.after({1, 3}), (TextPlace{2, 0}));
  EXPECT_EQ(text.before({2, 0}), (TextPlace{1, 3}));
  EXPECT_EQ(text.before({1, 0}), (TextPlace{1, 0}));
  EXPECT_EQ(text.after({2, 1}), (TextPlace{2, 1}));
  EXPECT_EQ(text.clamped({1, 1}), (TextPlace{1, 0}));  // within the character
}

TEST(ProgramText, StepsOverWords) {
  const ProgramText text(program_of("G1 X-5.5 (A)\n  Y2"));
  EXPECT_EQ(text.word_after({1, 0}), (TextPlace{1, 3}));
  EXPECT_EQ(text.word_after({1, 3}), (TextPlace{1, 4}));  // the sign
  EXPECT_EQ(text.word_before({1, 8}), (TextPlace{1, 5}));
  EXPECT_EQ(text.word_after({1, 12}), (TextPlace{2, 0}));
  EXPECT_EQ(text.word_before({2, 2}), (TextPlace{2, 0}));
  EXPECT_EQ(text.word_before({2, 0}), (TextPlace{1, 12}));
  EXPECT_EQ(text.text(text.word_at({1, 6})), "5.5");
  EXPECT_EQ(text.text(text.word_at({1, 12})), ")");
}

TEST(ProgramText, KnowsItsLongestLine) {
  EXPECT_EQ(ProgramText(program_of("G1\nG1 X1000\nM2")).longest_line(), 8U);
}

}  // namespace
}  // namespace feedscope::ui

#include "ui/language/text_pattern.h"

#include <gtest/gtest.h>

#include <QStringList>

namespace feedscope::ui {
namespace {

/// What stands in the places, in their order, with "<" and ">" around what is program text; "none" if the
/// text is of another pattern.
std::string parts_of(const char* pattern, const char* text) {
  const auto parts = TextPattern(QString::fromUtf8(pattern)).match(QString::fromUtf8(text));
  if (!parts) {
    return "none";
  }
  QStringList all;
  for (const TextPattern::Part& part : *parts) {
    all.append(part.is_program_text ? '<' + part.text + '>' : part.text);
  }
  return all.join('|').toStdString();
}

TEST(TextPattern, FindsWhatStandsInThePlaces) {
  EXPECT_EQ(parts_of("axis %1 moves to %2", "axis B moves to 30"), "B|30");
  EXPECT_EQ(parts_of("%1 is %2", "this is what it is"), "this|what it is");
  EXPECT_EQ(parts_of("no places", "no places"), "");
  EXPECT_EQ(parts_of("%1", "all"), "all");
}

TEST(TextPattern, KnowsWordsOfThePrograms) {
  EXPECT_EQ(parts_of("R%1 of %2 mm", "R5.5 of 2.5 mm"), "<5.5>|2.5");
  EXPECT_EQ(parts_of("%1%2 is negative", "X-5.5 is negative"), "X|<-5.5>");
  EXPECT_EQ(parts_of("AR=%1 ('%2')", "AR=4.5 ('1.5')"), "<4.5>|<1.5>");
  EXPECT_EQ(parts_of("\"%1 of %2\" is %3", "\"1.5 of 2.5\" is 3.5"), "<1.5>|<2.5>|3.5");
  EXPECT_EQ(parts_of("write \"DEF REAL %1=\"", "write \"DEF REAL dwell=\""), "<dwell>");
}

TEST(TextPattern, RefusesTextsOfOtherPatterns) {
  EXPECT_EQ(parts_of("axis %1 moves", "axis  moves on"), "none");
  EXPECT_EQ(parts_of("axis %1 moves", "axis moves"), "none");
  EXPECT_EQ(parts_of("%1 and %2 and %3", "X and Y and"), "none");
  EXPECT_EQ(parts_of("%1 is %1 is", "x is"), "none");
  EXPECT_EQ(parts_of("no places", "no places at all"), "none");
  EXPECT_EQ(parts_of("%1 of it", " of it"), "none");
}

/// What a program has written does not become a place.
TEST(TextPattern, FillsPlacesInAnyOrder) {
  EXPECT_EQ(TextPattern::fill("%2 de %1, 100 %", {"%2", "b"}).toStdString(), "b de %2, 100 %");
  EXPECT_EQ(TextPattern::fill("%1, %3", {"a"}).toStdString(), "a, %3");
}

}  // namespace
}  // namespace feedscope::ui

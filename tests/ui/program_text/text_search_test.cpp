#include "ui/program_text/text_search.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>
#include <random>

#include "tests/ui/patience.h"
#include "tests/ui/program_fixture.h"

namespace feedscope::ui {
namespace {

using test::program_of;
using testing::HasSubstr;

std::vector<std::string> hits(const std::string& line, const SearchQuery& query) {
  const ProgramText text(program_of(line));
  std::vector<std::string> found;
  for (const TextRange& hit : LineFinder(query).matches_in(text, 1)) {
    found.push_back(text.text(hit).toStdString());
  }
  return found;
}

TEST(LineFinder, FindsPlainText) {
  using testing::ElementsAre;
  EXPECT_THAT(hits("G1 g10 X1", {"g1"}), ElementsAre("G1", "g1"));
  EXPECT_THAT(hits("G1 g10 X1", {"g1", true}), ElementsAre("g1"));
  EXPECT_THAT(hits("G1 g10 G1.5 X1", {"g1", false, true}), ElementsAre("G1"));
  EXPECT_THAT(hits("X1. (a.b)", {"."}), ElementsAre(".", "."));
  EXPECT_THAT(hits("G1", {""}), ElementsAre());
}

TEST(LineFinder, FindsRegularExpressions) {
  using testing::ElementsAre;
  EXPECT_THAT(hits("G1 X-1.5 Y22", {"[XY]-?\\d+", false, false, true}), ElementsAre("X-1", "Y22"));
  EXPECT_THAT(hits("XXYX", {"x*", false, false, true}), ElementsAre("XX", "X")) << "nothing empty";
}

TEST(LineFinder, SaysWhereAnExpressionIsWrong) {
  const LineFinder finder({"X[0-9", false, false, true});
  EXPECT_FALSE(finder.can_find());
  EXPECT_THAT(finder.error().toStdString(), HasSubstr("At character 6"));
  EXPECT_TRUE(LineFinder({"X[0-9"}).can_find()) << "it is plain text";
  EXPECT_TRUE(LineFinder({""}).error().isEmpty());
}

TEST(LineFinder, CountsBytesBehindOtherLetters) {
  const ProgramText text(program_of("(\u00fc\u00df) X1"));
  const auto found = LineFinder({"X1"}).matches_in(text, 1);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].begin.byte, 7U);
  EXPECT_EQ(found[0].end.byte, 9U);
}

/// A search that has been done.
class TextSearchTest : public testing::Test {
 protected:
  void look_for(const std::string& program, const SearchQuery& query) {
    text = ProgramText(program_of(program));
    search.set_text(text);
    search.set_query(query);
    ASSERT_TRUE(QTest::qWaitFor([this] { return !search.busy(); }, patience));
  }

  ProgramText text;
  TextSearch search;
};

TEST_F(TextSearchTest, CountsAndNumbersItsHits) {
  look_for("G1 X1 X2\nY1\nX3\n", {"X"});
  ASSERT_NE(search.found(), nullptr);
  EXPECT_EQ(search.found()->count(), 3U);
  const auto first = search.at_or_after({1, 0});
  EXPECT_EQ(first->begin, (TextPlace{1, 3}));
  EXPECT_EQ(search.number_of(*first), 1U);
  const auto last = search.at_or_after({1, 7});
  EXPECT_EQ(last->begin, (TextPlace{3, 0}));
  EXPECT_EQ(search.number_of(*last), 3U);
  EXPECT_EQ(search.number_of({{2, 0}, {2, 1}}), 0U);
}

TEST_F(TextSearchTest, WrapsAtBothEnds) {
  look_for("G1 X1\nY1\nX3\n", {"X"});
  EXPECT_EQ(search.at_or_after({3, 1})->begin, (TextPlace{1, 3}));
  EXPECT_EQ(search.before({1, 3})->begin, (TextPlace{3, 0}));
  EXPECT_EQ(search.before({3, 0})->begin, (TextPlace{1, 3}));
}

TEST_F(TextSearchTest, WithoutHitsGoesNowhere) {
  look_for("G1 X1\n", {"Q"});
  EXPECT_EQ(search.found()->count(), 0U);
  EXPECT_FALSE(search.at_or_after({1, 0}).has_value());
  EXPECT_FALSE(search.before({1, 0}).has_value());
}

TEST_F(TextSearchTest, ANewQueryReplacesOneUnderWay) {
  std::string program;
  for (int i = 0; i < 200000; ++i) {
    program += "G1 X1 Y2\n";
  }
  look_for(program, {"Z"});
  search.set_query({"[XY]", false, false, true});
  EXPECT_TRUE(search.busy());
  EXPECT_EQ(search.found(), nullptr);
  search.set_query({"G"});
  ASSERT_TRUE(QTest::qWaitFor([this] { return !search.busy(); }, patience));
  EXPECT_EQ(search.found()->count(), 200000U);
  QTest::qWait(100);
  EXPECT_EQ(search.found()->count(), 200000U);
}

TEST_F(TextSearchTest, AgreesWithLookingAtEveryLine) {
  std::mt19937 random(4);
  for (const double share : {0.0, 0.001, 0.02, 0.5, 1.0}) {
    std::string program;
    std::vector<std::uint32_t> lines;
    for (std::uint32_t line = 1; line <= 1000; ++line) {
      const bool hit = std::bernoulli_distribution(share)(random);
      program += hit ? "G1 X1\n" : "G1 Y1\n";
      if (hit) {
        lines.push_back(line);
      }
    }
    look_for(program, {"X"});
    const FoundLines& found = *search.found();
    ASSERT_EQ(found.count(), lines.size());
    for (std::uint32_t line = 1; line <= 1002; ++line) {
      const auto next = std::ranges::lower_bound(lines, line);
      const auto after = std::ranges::upper_bound(lines, line);
      ASSERT_EQ(found.next_line(line), next == lines.end() ? 1001U : *next) << share << " " << line;
      ASSERT_EQ(found.previous_line(line), after == lines.begin() ? 0U : *(after - 1))
          << share << " " << line;
      ASSERT_EQ(found.any(line, line + 20), next != lines.end() && *next <= line + 20);
    }
  }
}

}  // namespace
}  // namespace feedscope::ui

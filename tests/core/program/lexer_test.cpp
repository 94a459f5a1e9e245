#include "core/program/text/lexer.h"

#include <gtest/gtest.h>

#include <clocale>
#include <string>

namespace feedscope {
namespace {

/// "X1.5@1 Y-2@6": every word with its value and column.
std::string words_of(std::string_view line) {
  Lexer lexer;
  std::string shown;
  for (const Word& word : lexer.read(line).words) {
    char text[64];
    std::snprintf(text, sizeof text, "%s%c%g@%u", shown.empty() ? "" : " ", word.letter, word.value,
                  word.column);
    shown += text;
  }
  return shown;
}

/// The only fault of a line as "kind@column+length".
std::string fault_of(std::string_view line) {
  Lexer lexer;
  const Block& block = lexer.read(line);
  if (block.faults.size() != 1) {
    return std::to_string(block.faults.size()) + " faults";
  }
  const Fault& fault = block.faults[0];
  constexpr const char* names[] = {"number", "range", "comment", "character"};
  return std::string(names[static_cast<int>(fault.kind)]) + "@" + std::to_string(fault.column) + "+" +
         std::to_string(fault.length);
}

TEST(Lexer, ReadsWordsWithTheirColumns) {
  EXPECT_EQ(words_of("N10 G1 X1.5 Y-2"), "N10@1 G1@5 X1.5@8 Y-2@13");
}

TEST(Lexer, NeedsNoBlanksAndTakesBlanksAfterLetterAndSign) {
  EXPECT_EQ(words_of("G1X1.5Y-2F500"), "G1@1 X1.5@3 Y-2@7 F500@10");
  EXPECT_EQ(words_of("  g 1\tx - 1.5 y + 2"), "G1@3 X-1.5@7 Y2@15");
}

TEST(Lexer, ReadsEveryWayToWriteADecimal) {
  EXPECT_EQ(words_of("X5. Y.5 Z-.25 I+3 J007 K-0"), "X5@1 Y0.5@5 Z-0.25@9 I3@15 J7@19 K-0@24");
  Lexer lexer;
  const Block& block = lexer.read("P5. P5");
  EXPECT_TRUE(block.words[0].has_point);
  EXPECT_FALSE(block.words[1].has_point);
}

TEST(Lexer, NumbersDoNotDependOnTheLocale) {
  const char* const set = std::setlocale(LC_ALL, "de_DE.UTF-8");
  EXPECT_EQ(Lexer().read("X1.5").words.at(0).value, 1.5);
  if (set != nullptr) {
    std::setlocale(LC_ALL, "C");
  }
}

TEST(Lexer, LeavesOutComments) {
  EXPECT_EQ(words_of("G1 (G2 X9) X1 ; Y2"), "G1@1 X1@12");
  EXPECT_EQ(words_of("(TOOL 3 (D=10)) X1"), "X1@17");
  EXPECT_EQ(words_of("(an odd ( one) X1"), "X1@16");
  EXPECT_EQ(words_of("; (open"), "");
  EXPECT_EQ(fault_of("G1 (never closed"), "comment@4+13");
}

TEST(Lexer, ReadsBlockDelete) {
  Lexer lexer;
  EXPECT_EQ(lexer.read("/G1 X1").delete_level, 1);
  EXPECT_EQ(lexer.read("/3 G1 X1").delete_level, 3);
  EXPECT_EQ(lexer.read("N10 /2 G1 X1").delete_level, 2);
  EXPECT_EQ(lexer.read("G1 X1").delete_level, 0);
  EXPECT_EQ(words_of("/3 G1 X1"), "G1@4 X1@7");
  EXPECT_EQ(fault_of("G1 /X1"), "character@4+1");
}

TEST(Lexer, PercentEndsTheLine) {
  Lexer lexer;
  const Block& block = lexer.read("M2 % X1");
  EXPECT_EQ(block.percent, 4U);
  EXPECT_EQ(block.words.size(), 1U);
}

TEST(Lexer, FindsMalformedNumbers) {
  EXPECT_EQ(fault_of("G1 X1..2"), "number@4+5");
  EXPECT_EQ(fault_of("G1 X- Y2"), "number@4+2");
  EXPECT_EQ(fault_of("G1 X Y2"), "number@4+1");
  EXPECT_EQ(fault_of("G1 X"), "number@4+1");
  EXPECT_EQ(fault_of("X."), "number@1+2");
  EXPECT_EQ(fault_of("X--1"), "number@1+4");
  EXPECT_EQ(fault_of("X1-2"), "number@1+4");
  EXPECT_EQ(fault_of("X1 2"), "number@1+4") << "a number must not be torn apart";
  EXPECT_EQ(fault_of("Xnan"), "number@1+4");
  EXPECT_EQ(fault_of("XInf"), "number@1+4");
  EXPECT_EQ(fault_of("X-inf Y1"), "number@1+2");
  EXPECT_EQ(fault_of("X1e5"), "number@1+4");
  EXPECT_EQ(fault_of("X1E-5Y2"), "number@1+5");
  EXPECT_EQ(words_of("G1 X1..2 F500"), "G1@1 F500@10") << "reading goes on behind it";
}

TEST(Lexer, AnExtruderWordIsNoExponent) {
  EXPECT_EQ(words_of("X1 E5"), "X1@1 E5@4");
}

TEST(Lexer, FindsNumbersOutOfRange) {
  EXPECT_EQ(words_of("X1000000000"), "X1e+09@1");
  EXPECT_EQ(fault_of("X1000000001"), "range@1+11");
  EXPECT_EQ(fault_of("X-" + std::string(400, '9')), "range@1+402");
}

TEST(Lexer, StopsWhereNamesVariablesAndExpressionsBegin) {
  const auto statement = [](std::string_view line) { return Lexer().read(line).statement; };
  EXPECT_EQ(statement("G1 X1 Y2 (X#1)"), 0U);
  EXPECT_EQ(statement("N10 CYCLE832(0.01)"), 5U);
  EXPECT_EQ(statement("#100=5"), 1U);
  EXPECT_EQ(statement("G1 X#1 Y2 ; note"), 4U);
  EXPECT_EQ(statement("X[1+2]"), 1U);
  EXPECT_EQ(statement("X=5"), 1U);
  EXPECT_EQ(statement("X1=5"), 1U);
  EXPECT_EQ(statement("o<sub> call"), 1U);
  EXPECT_EQ(statement("G1 @5 ^30"), 4U);
  EXPECT_EQ(words_of("G91 X1 Y#2 Z3"), "G91@1 X1@5") << "the words before it are read";
}

TEST(Lexer, FindsCharactersThatStartNoWord) {
  EXPECT_EQ(fault_of("G1 !X1"), "character@4+1");
  EXPECT_EQ(fault_of("12 L X+1"), "character@1+1");
  EXPECT_EQ(fault_of("G1 \xC3\xA4"), "character@4+1");
}

TEST(Lexer, ALongLineOfOpenBracketsTakesLinearTime) {
  std::string line;
  for (int i = 0; i < 300000; ++i) {
    line += "(()";
  }
  EXPECT_TRUE(Lexer().read(line).words.empty());
}

}  // namespace
}  // namespace feedscope

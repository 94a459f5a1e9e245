#include <gtest/gtest.h>

#include <random>
#include <string>

#include "core/program/program.h"
#include "tests/core/program/mutated_text.h"
#include "tests/core/program/read_text.h"
#include "tests/support/program_checks.h"

namespace feedscope {
namespace {

/// Whatever the text, what comes out can be worked with.
void expect_sane(const std::string& text, const ReadOptions& options = {}) {
  ASSERT_EQ(insane_part(read_text(text, options)), "") << text;
}

TEST(Garbage, RandomBytesAreReadWithoutHarm) {
  std::mt19937 random(1);
  for (int round = 0; round < 3000; ++round) {
    std::string text(random() % 400, ' ');
    for (char& c : text) {
      c = static_cast<char>(' ' + random() % 224);
    }
    expect_sane(text);
    if (HasFatalFailure()) {
      FAIL() << "round " << round;
    }
  }
}

TEST(Garbage, RandomWordsAreReadWithoutHarm) {
  constexpr std::string_view pieces[] = {
      "G0",  "G1",  "G2",  "G3",  "G4",  "G17",  "G18",  "G19",    "G20", "G90.1", "G91", "G93",
      "G81", "G92", "X",   "Y",   "Z",   "I",    "J",    "K",      "R",   "F",     "P",   "1",
      "-2",  ".5",  "0",   "1e9", "\n",  "\n",   " ",    "(",      ")",   ";",     "/",   "%",
      "#1",  "=",   "nan", "\r",  "M30", "1000", "-0.1", "0.0001", ",R1", ",C.5",  ","};
  std::mt19937 random(2);
  for (int round = 0; round < 20000; ++round) {
    std::string text;
    for (std::size_t i = random() % 60; i > 0; --i) {
      text += pieces[random() % std::size(pieces)];
    }
    expect_sane(text);
    if (HasFatalFailure()) {
      FAIL() << "round " << round;
    }
  }
}

TEST(Garbage, RandomMacroWordsAreReadWithoutHarm) {
  constexpr std::string_view pieces[] = {
      "#",         "#1",    "#<a>",     "#500",  "=",        "[",      "]",   "[",    "]",     "+",
      "-",         "*",     "/",        "**",    "EQ",       "LT",     "AND", "SIN[", "ATAN[", "X",
      "G1",        "1",     "2",        "0.5",   "o1",       "o<a>",   "sub", "call", "if",    "endsub",
      "else",      "while", "do",       "endif", "endwhile", "repeat", "M98", "M99",  "G65",   "G66",
      "P1",        "L2",    "GOTO",     "IF",    "THEN",     "WHILE",  "DO1", "END1", "N1",    "O1",
      "\n",        "\n",    "\n",       "\n",    " ",        " ",      "M30", "(",    ")",     "return",
      "endrepeat", "break", "continue", "elseif"};
  std::mt19937 random(4);
  for (const Dialect dialect : {Dialect::linuxcnc, Dialect::fanuc, Dialect::iso}) {
    for (int round = 0; round < 20000; ++round) {
      std::string text;
      for (std::size_t i = random() % 60; i > 0; --i) {
        text += pieces[random() % std::size(pieces)];
      }
      expect_sane(text, {.dialect = dialect, .repeat_limit = 500});
      if (HasFatalFailure()) {
        FAIL() << "round " << round;
      }
    }
  }
}

TEST(Garbage, MutatedProgramsAreReadWithoutHarm) {
  const std::string sample =
      "%\nO1 (PART)\nG17 G21 G90 G94\nG0 X1.5 Y-2 Z5\nG1 Z-1 F250\nX9 ,R.5\nY0 ,C1\nX1.5 Y-2\nG2 X3 Y-2 "
      "I0.75 J0\nG3 X1.5 Y-2 Z-2 "
      "R0.75\n"
      "G18 G2 X3 Z-2 R-0.9\n#1=2\nWHILE [#1 GT 0] DO1\nX[#1*SIN[30]]\n#1=#1-1\nEND1\no1 if [#1]\nY1\no1 "
      "endif\n"
      "G4 P500\n/ G91 X1 Y1\nN99 G90.1 G3 X5 Y5 I1 J1 P2\nG20 X.1 M8\nM98 P7 L2\nM30\nO7\nZ#1\nM99\n%\n";
  std::mt19937 random(3);
  for (int round = 0; round < 20000; ++round) {
    expect_sane(mutated(sample, random), {.repeat_limit = 500});
    if (HasFatalFailure()) {
      FAIL() << "round " << round;
    }
  }
}

}  // namespace
}  // namespace feedscope

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cctype>
#include <cmath>
#include <ostream>
#include <random>
#include <string>
#include <vector>

#include "tests/core/program/iso/iso_text.h"

namespace feedscope {
namespace {

struct Case {
  const char* expression;
  double value;
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.expression;
}

double value_of(Dialect dialect, const std::string& expression) {
  return way(dialect, "G0 X[" + expression + "]").at(0);
}

/// Blanks between the pieces of a text that are words, numbers or signs; numbers and names stay whole.
std::string with_blanks(const std::string& text, std::mt19937& random) {
  std::string spread;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto inside = [](char a, char b) {
      const bool letters =
          std::isalpha(static_cast<unsigned char>(a)) && std::isalpha(static_cast<unsigned char>(b));
      const bool digits = (std::isdigit(static_cast<unsigned char>(a)) || a == '.') &&
                          (std::isdigit(static_cast<unsigned char>(b)) || b == '.');
      return letters || digits || (a == '*' && b == '*');
    };
    // "G0 XSQRT": the X and the name behind it are two pieces.
    const bool function = i + 3 < text.size() && text[i - (i > 0 ? 1 : 0)] == 'X' && i > 0 && text[i] == 'S';
    if (i > 0 && text[i] != '\n' && (function || !inside(text[i - 1], text[i]))) {
      spread.append(random() % 3, ' ');
    }
    spread += text[i];
  }
  return spread;
}

TEST(LinuxcncExpression, BlanksBetweenItsPiecesMeanNothing) {
  std::mt19937 random(8);
  for (const std::string text :
       {"G0 XSQRT[16]", "G0 X-SQRT[16]Y[1+2]", "#1=3\nG0 X#1", "#1=[2**3-4]\nG0 X[#1*2]Y#1",
        "#<a>=5\nG0 X[#<a>+SIN[30]]", "G0 X[7MOD4]", "G0 X[ATAN[1]/[1]]", "o1 if [1LT2]\nG0 X1\no1 endif"}) {
    const double expected = way(Dialect::linuxcnc, text).at(0);
    for (int round = 0; round < 50; ++round) {
      const std::string spread = with_blanks(text, random);
      EXPECT_EQ(way(Dialect::linuxcnc, spread), (std::vector<double>{expected})) << spread;
    }
  }
}

class SharedExpression : public testing::TestWithParam<Case> {};

TEST_P(SharedExpression, HasItsValueInBothDialects) {
  for (const Dialect dialect : {Dialect::fanuc, Dialect::linuxcnc}) {
    EXPECT_NEAR(value_of(dialect, GetParam().expression), GetParam().value, 1e-12);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Values, SharedExpression,
    testing::Values(Case{"1+2*3", 7}, Case{"[1+2]*3", 9}, Case{"10-2-3", 5}, Case{"12/2/3", 2},
                    Case{"2**3", 8}, Case{"2 * 3 ** 2", 18}, Case{"-[2+3]", -5}, Case{"-2*-3", 6},
                    Case{"+4", 4}, Case{".5", 0.5}, Case{"7 MOD 4", 3}, Case{"7MOD4", 3},
                    Case{"SIN[30]", 0.5}, Case{"cos[60]", 0.5}, Case{"TAN[45]", 1}, Case{"ASIN[0.5]", 30},
                    Case{"ACOS[0.5]", 60}, Case{"ATAN[1]/[1]", 45}, Case{"ATAN[1]/[-1]", 135},
                    Case{"ATAN[1,-1]", 135}, Case{"ATAN[1]", 45}, Case{"ABS[-3]", 3}, Case{"SQRT[16]", 4},
                    Case{"EXP[0]", 1}, Case{"LN[EXP[2]]", 2}, Case{"FIX[2]", 2}, Case{"FIX[2.8]", 2},
                    Case{"FUP[2.1]", 3}, Case{"3 EQ 3", 1}, Case{"3EQ4", 0}, Case{"3 NE 4", 1},
                    Case{"3GT2", 1}, Case{"3 GE 3", 1}, Case{"3 LT 3", 0}, Case{"3 LE 3", 1},
                    Case{"[1 EQ 1] AND [2 EQ 2]", 1}, Case{"[1 EQ 1] AND [2 EQ 3]", 0},
                    Case{"[1 EQ 2] OR [2 EQ 2]", 1}, Case{"[1 EQ 1] XOR [2 EQ 2]", 0}, Case{"1 + 1 EQ 2", 1},
                    Case{"SIN[15*2]*2", 1}));

class FanucExpression : public testing::TestWithParam<Case> {};

TEST_P(FanucExpression, HasTheValueOfMacroB) {
  EXPECT_NEAR(value_of(Dialect::fanuc, GetParam().expression), GetParam().value, 1e-12);
}

// AND binds as a product, OR and XOR as a sum, and all three work on bits.
INSTANTIATE_TEST_SUITE_P(Values, FanucExpression,
                         testing::Values(Case{"12 AND 10", 8}, Case{"12 OR 3", 15}, Case{"12 XOR 10", 6},
                                         Case{"1 OR 6 AND 3", 3}, Case{"FIX[-2.8]", -2},
                                         Case{"FUP[-2.1]", -3}, Case{"-7 MOD 4", -3}, Case{"POW[2,10]", 1024},
                                         Case{"BCD[25]", 37}, Case{"BIN[37]", 25}, Case{"ATAN[-1]/[-1]", 225},
                                         Case{"ATAN[4]/2", 75.9637565320735 / 2},
                                         Case{"ROUND[1.23456]", 1.235}, Case{"#0 EQ 0", 0},
                                         Case{"#0 EQ #0", 1}, Case{"#0 NE 0", 1}, Case{"#0 + 1", 1},
                                         Case{"#0 GE 0", 1}));

class LinuxCncExpression : public testing::TestWithParam<Case> {};

TEST_P(LinuxCncExpression, HasTheValueOfItsInterpreter) {
  EXPECT_NEAR(value_of(Dialect::linuxcnc, GetParam().expression), GetParam().value, 1e-12);
}

// Logic comes last and knows true and false only; equal is equal within 0.0001.
INSTANTIATE_TEST_SUITE_P(Values, LinuxCncExpression,
                         testing::Values(Case{"12 AND 10", 1}, Case{"1 EQ 1 AND 2 EQ 2", 1},
                                         Case{"0 OR 3 GT 2", 1}, Case{"2 XOR 0", 1}, Case{"FIX[-2.8]", -3},
                                         Case{"FUP[-2.1]", -2}, Case{"-7 MOD 4", 1},
                                         Case{"ATAN[-1]/[-1]", -135}, Case{"1 EQ 1.00005", 1},
                                         Case{"1 NE 1.00005", 0}, Case{"1 EQ 1.001", 0},
                                         Case{"ROUND[-2.5]", -3}, Case{"EXISTS[#<nothing>]", 0},
                                         Case{"EXISTS[#<_x>]", 1}));

TEST(IsoExpression, FunctionsStandForNumbersInWords) {
  EXPECT_EQ(way(Dialect::linuxcnc, "G0 XSQRT[16]").at(0), 4);
  EXPECT_EQ(way(Dialect::fanuc, "G0 X-SQRT[16]").at(0), -4);
}

struct Fault {
  const char* text;
  const char* expected;
};

void PrintTo(const Fault& fault, std::ostream* out) {
  *out << fault.text;
}

class IsoExpressionFaults : public testing::TestWithParam<Fault> {};

TEST_P(IsoExpressionFaults, NamePlaceThingAndWhatToDo) {
  EXPECT_EQ(said_of(Dialect::linuxcnc, std::string("G0 X1\n") + GetParam().text), GetParam().expected);
}

INSTANTIATE_TEST_SUITE_P(
    Texts, IsoExpressionFaults,
    testing::Values(
        Fault{"G0 X[1+2",
              "f:2:8: error: \"]\" is missing here [expression] (check the brackets of the expression)"},
        Fault{
            "G0 X[1/0]",
            "f:2:7: error: \"/\" has no finite value [expression-value] (check the values that go into it)"},
        Fault{"G0 X[SQRT[-1]]",
              "f:2:6: error: \"SQRT\" has no finite value [expression-value] (check the values that go into "
              "it)"},
        Fault{"G0 X[FOO[1]]",
              "f:2:6: error: \"FOO[1]]\" is not a value, variable or function [expression] (write a number, "
              "a variable or a function here)"},
        Fault{"G0 X[1e3]",
              "f:2:7: error: \"]\" is missing here [expression] (check the brackets of the expression)"},
        Fault{"G0 X#1.5",
              "f:2:6: error: \"1.5\" is not a variable number [variable] (the block does not move; variable "
              "numbers are whole and start at 0)"},
        Fault{"G0 X#<a",
              "f:2:6: error: \">\" is missing after the name [expression] (close the name with \">\")"},
        Fault{"G0 X[1000*1000*1001]",
              "f:2:4: error: X1001000000 is above the largest number, 1000000000 [number-range] (the block "
              "does not move; check the values that go into it)"},
        Fault{"G0 X[2]]",
              "f:2:8: error: \"]\" does not start a word [unknown-character] (the rest of the line is "
              "skipped and the block does not move; remove the character)"},
        Fault{"#1 5", "f:2:4: error: \"=\" is missing after the variable [expression] (write its value)"},
        Fault{"G0 X[2] (note",
              "f:2:9: error: the comment \"(note\" is not closed [unclosed-comment] (the rest of the line is "
              "used as the comment; add the closing bracket)"}));

TEST(IsoExpression, ABlockWithAFaultDoesNotMoveButItsModalWordsCount) {
  const ReadProgram program = read_as(Dialect::linuxcnc, "G0 X1\nG91 X[1+\nX5\n");
  ASSERT_EQ(program.motions.size(), 2U);
  EXPECT_EQ(program.motions[1].target.x(), 6);
}

TEST(IsoExpression, EndlessBracketsAreRefusedNotFollowed) {
  const ReadProgram program = read_as(Dialect::linuxcnc, "G0 X1\nX" + std::string(100000, '['));
  ASSERT_EQ(program.diagnostics.size(), 1U);
  EXPECT_EQ(program.diagnostics[0].code, "expression");
}

}  // namespace
}  // namespace feedscope

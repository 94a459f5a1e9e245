#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "core/program/text/scanner.h"

namespace feedscope {

/// Operators and functions of a dialect's expressions, and their syntax.
struct ExpressionGrammar {
  /// Operator between two operands; a greater rank binds more tightly, equal ranks from left to right. Longer
  /// operators come before their own beginnings. A name must not be followed by a name character.
  struct Infix {
    std::string_view text;
    int rank = 0;
    double (*apply)(double, double) = nullptr;
  };
  /// Operator before an operand, which it binds more tightly than an infix of a lower rank.
  struct Prefix {
    std::string_view text;
    int rank = 0;
    double (*apply)(double) = nullptr;
  };
  /// A name with its arguments in brackets, separated by commas; one argument may do without brackets if
  /// `bare_arguments` is set.
  struct Function {
    std::string_view name;
    int arguments = 1;  ///< 1 or 2
    double (*apply)(double, double) = nullptr;
  };
  std::span<const Infix> infixes;
  std::span<const Prefix> prefixes;
  std::span<const Function> functions;
  char open = '(';
  char close = ')';
  std::string_view scale = {};   ///< between a number and a power of ten: "EX" in "1.5EX-3"
  bool bare_arguments = false;   ///< "SIN Q2"
  bool decimal_comma = false;    ///< "1,5"; arguments may then be separated by ";"
  bool digit_ends_name = false;  ///< an operator's name may be followed by a digit, "#1GT5"
};

/// Evaluates expressions while reading them. A dialect defines its variables.
class ExpressionReader {
 public:
  explicit ExpressionReader(const ExpressionGrammar& grammar) : grammar_(grammar) {}
  virtual ~ExpressionReader() = default;

  /// Value of the longest expression from here on. Throws ReadFault: "expression" for an unreadable one,
  /// "expression-value" for a value that is not finite.
  double read(Scanner& scanner) { return infix(scanner, 0); }
  /// Value of one operand with its signs: number, variable, function, or an expression in brackets.
  double read_operand(Scanner& scanner);

 protected:
  /// Value of a variable, or of another element of this dialect, at the scanner; none, with the scanner
  /// unmoved, for anything else. Throws ReadFault.
  virtual std::optional<double> variable(Scanner& scanner) = 0;
  /// Takes a bracket or comma. Throws ReadFault "expression" if it is missing.
  static void expect(Scanner& scanner, char c);

 private:
  double infix(Scanner& scanner, int min_rank);
  double primary(Scanner& scanner);
  double scaled(Scanner& scanner, double number);
  std::optional<double> function(Scanner& scanner);
  bool take_operator(Scanner& scanner, std::string_view symbol) const;

  const ExpressionGrammar& grammar_;
  int depth_ = 0;
};

}  // namespace feedscope

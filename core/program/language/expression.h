#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "core/program/text/scanner.h"

namespace feedscope {

/// What operators and functions a dialect's expressions have, and how they look.
struct ExpressionGrammar {
  /// Between two operands; a greater rank binds more tightly, equal ranks from left to right. Of operators
  /// that begin the same the longer stands first. A name is followed by no name character.
  struct Infix {
    std::string_view text;
    int rank = 0;
    double (*apply)(double, double) = nullptr;
  };
  /// Before an operand, which it binds more tightly than an infix of a lower rank.
  struct Prefix {
    std::string_view text;
    int rank = 0;
    double (*apply)(double) = nullptr;
  };
  /// A name with its arguments in brackets, divided by commas; one argument may stand without brackets where
  /// `bare_arguments` says so.
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
  bool decimal_comma = false;    ///< "1,5"; then ";" does not divide arguments either
  bool digit_ends_name = false;  ///< an operator's name may be followed by a digit, "#1GT5"
};

/// Evaluates expressions as they are read. A dialect says what its variables are.
class ExpressionReader {
 public:
  explicit ExpressionReader(const ExpressionGrammar& grammar) : grammar_(grammar) {}
  virtual ~ExpressionReader() = default;

  /// The value of the longest expression from here on.
  /// Throws ReadFault: "expression" for what cannot be read, "expression-value" for no finite value.
  double read(Scanner& scanner) { return infix(scanner, 0); }
  /// The value of one operand: number, variable, function, or an expression in brackets, signs before it.
  double read_operand(Scanner& scanner);

 protected:
  /// The value of a variable, or of anything else that only this dialect has, at the scanner; none, and the
  /// scanner stays, if nothing of that kind stands there. Throws ReadFault.
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

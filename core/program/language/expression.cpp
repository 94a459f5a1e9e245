#include "core/program/language/expression.h"

#include <cmath>

#include "core/program/text/message.h"
#include "core/program/text/read_fault.h"

namespace feedscope {

namespace {

/// Limit of nested brackets, signs and functions; a line is short, but the stack is finite.
constexpr int deepest = 200;

double finite(double value, std::string_view text, std::uint32_t column) {
  if (!std::isfinite(value)) {
    throw ReadFault{"expression-value", column,
                    message(NC_("core", "{} has no finite value"), in_quotes(text)),
                    NC_("core", "check the values that go into it")};
  }
  return value;
}

}  // namespace

bool ExpressionReader::take_operator(Scanner& scanner, std::string_view symbol) const {
  if (!letters::is_letter(symbol.back())) {
    return scanner.take(symbol);
  }
  return grammar_.digit_ends_name ? scanner.take_keyword(symbol) : scanner.take_name(symbol);
}

void ExpressionReader::expect(Scanner& scanner, char c) {
  const std::uint32_t column = scanner.column();
  if (!scanner.take(c)) {
    throw ReadFault{"expression", column, message(NC_("core", "\"{}\" is missing here"), c),
                    NC_("core", "check the brackets of the expression")};
  }
}

double ExpressionReader::infix(Scanner& scanner, int min_rank) {
  double value = read_operand(scanner);
  while (true) {
    const std::size_t before = scanner.at();
    const std::uint32_t column = scanner.column();
    const ExpressionGrammar::Infix* found = nullptr;
    for (const ExpressionGrammar::Infix& candidate : grammar_.infixes) {
      if (take_operator(scanner, candidate.text)) {
        found = &candidate;
        break;
      }
    }
    if (found == nullptr || found->rank < min_rank) {
      scanner.move_to(before);
      return value;
    }
    value = finite(found->apply(value, infix(scanner, found->rank + 1)), found->text, column);
  }
}

double ExpressionReader::read_operand(Scanner& scanner) {
  const std::uint32_t column = scanner.column();
  struct Level {
    int& depth;
    explicit Level(int& d) : depth(++d) {}
    ~Level() { --depth; }
  } const level(depth_);
  if (depth_ > deepest) {
    throw ReadFault{"expression", column,
                    message(NC_("core", "the expression is nested more than {} deep"), deepest),
                    NC_("core", "split it into several assignments")};
  }
  for (const ExpressionGrammar::Prefix& prefix : grammar_.prefixes) {
    if (take_operator(scanner, prefix.text)) {
      return finite(prefix.apply(infix(scanner, prefix.rank)), prefix.text, column);
    }
  }
  return primary(scanner);
}

double ExpressionReader::primary(Scanner& scanner) {
  if (scanner.take(grammar_.open)) {
    const double value = read(scanner);
    expect(scanner, grammar_.close);
    return value;
  }
  if (const std::optional<double> value = scanner.number(grammar_.decimal_comma)) {
    return grammar_.scale.empty() ? *value : scaled(scanner, *value);
  }
  if (const std::optional<double> value = variable(scanner)) {
    return *value;
  }
  if (const std::optional<double> value = function(scanner)) {
    return *value;
  }
  const std::uint32_t column = scanner.column();
  const std::string_view rest = scanner.rest();
  throw ReadFault{"expression", column,
                  rest.empty()
                      ? NC_("core", "a value is missing at the end of the expression")
                      : message(NC_("core", "{} is not a value, variable or function"), in_quotes(rest)),
                  NC_("core", "write a number, a variable or a function here")};
}

double ExpressionReader::scaled(Scanner& scanner, double number) {
  const std::size_t before = scanner.at();
  const std::uint32_t column = scanner.column();
  if (scanner.take(grammar_.scale)) {
    const bool negative = scanner.take('-');
    if (!negative) {
      scanner.take('+');
    }
    if (const std::optional<double> power = scanner.number()) {
      return finite(number * std::pow(10, negative ? -*power : *power), grammar_.scale, column);
    }
  }
  scanner.move_to(before);
  return number;
}

std::optional<double> ExpressionReader::function(Scanner& scanner) {
  const std::uint32_t column = scanner.column();
  for (const ExpressionGrammar::Function& candidate : grammar_.functions) {
    if (!scanner.take_name(candidate.name)) {
      continue;
    }
    double first = 0;
    double second = 0;
    if (grammar_.bare_arguments && candidate.arguments == 1) {
      first = read_operand(scanner);
    } else {
      expect(scanner, grammar_.open);
      first = read(scanner);
      if (candidate.arguments == 2) {
        expect(scanner, ',');
        second = read(scanner);
      }
      expect(scanner, grammar_.close);
    }
    return finite(candidate.apply(first, second), candidate.name, column);
  }
  return std::nullopt;
}

}  // namespace feedscope

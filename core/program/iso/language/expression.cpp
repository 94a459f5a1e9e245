#include "core/program/iso/language/expression.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/program/text/message.h"
#include "core/program/text/read_fault.h"

namespace feedscope::iso {

namespace {

constexpr double degree = std::numbers::pi / 180;

/// The null value counts as zero.
double number(double value) {
  return is_null(value) ? 0 : value;
}

double add(double a, double b) {
  return number(a) + number(b);
}
double subtract(double a, double b) {
  return number(a) - number(b);
}
double multiply(double a, double b) {
  return number(a) * number(b);
}
double divide(double a, double b) {
  return number(a) / number(b);
}
double power(double a, double b) {
  return std::pow(number(a), number(b));
}
double greater(double a, double b) {
  return number(a) > number(b) ? 1 : 0;
}
double greater_equal(double a, double b) {
  return number(a) >= number(b) ? 1 : 0;
}
double less(double a, double b) {
  return number(a) < number(b) ? 1 : 0;
}
double less_equal(double a, double b) {
  return number(a) <= number(b) ? 1 : 0;
}

namespace linuxcnc {

/// Values closer than this are equal, as on the control.
constexpr double equal_within = 1e-4;

double modulo(double a, double b) {
  const double rest = std::fmod(a, b);
  return rest < 0 ? rest + std::abs(b) : rest;
}
double equal(double a, double b) {
  return std::abs(a - b) < equal_within ? 1 : 0;
}
double unequal(double a, double b) {
  return 1 - equal(a, b);
}
double both(double a, double b) {
  return a != 0 && b != 0 ? 1 : 0;
}
double either(double a, double b) {
  return a != 0 || b != 0 ? 1 : 0;
}
double one_of(double a, double b) {
  return (a != 0) != (b != 0) ? 1 : 0;
}

}  // namespace linuxcnc

namespace fanuc {

double modulo(double a, double b) {
  return std::fmod(number(a), number(b));
}
double equal(double a, double b) {
  return is_null(a) == is_null(b) && number(a) == number(b) ? 1 : 0;
}
double unequal(double a, double b) {
  return 1 - equal(a, b);
}
std::int64_t bits(double value) {
  constexpr double most = 2147483647;
  return static_cast<std::int64_t>(std::clamp(std::round(number(value)), -most, most));
}
double both(double a, double b) {
  return static_cast<double>(bits(a) & bits(b));
}
double either(double a, double b) {
  return static_cast<double>(bits(a) | bits(b));
}
double one_of(double a, double b) {
  return static_cast<double>(bits(a) ^ bits(b));
}

}  // namespace fanuc

double to_binary(double value, double) {
  double rest = std::round(std::abs(number(value)));
  double binary = 0;
  for (double place = 1; rest > 0 && place < 1e12; place *= 10) {
    binary += std::fmod(rest, 16) * place;
    rest = std::floor(rest / 16);
  }
  return binary;
}

double to_decimal_code(double value, double) {
  double rest = std::round(std::abs(number(value)));
  double code = 0;
  for (double place = 1; rest > 0 && place < 1e12; place *= 16) {
    code += std::fmod(rest, 10) * place;
    rest = std::floor(rest / 10);
  }
  return code;
}

using Infix = ExpressionGrammar::Infix;
using Prefix = ExpressionGrammar::Prefix;
using Function = ExpressionGrammar::Function;

constexpr auto linuxcnc_infixes = std::to_array<Infix>({
    {"**", 6, power},
    {"*", 5, multiply},
    {"/", 5, divide},
    {"MOD", 5, linuxcnc::modulo},
    {"+", 4, add},
    {"-", 4, subtract},
    {"EQ", 3, linuxcnc::equal},
    {"NE", 3, linuxcnc::unequal},
    {"GT", 3, greater},
    {"GE", 3, greater_equal},
    {"LT", 3, less},
    {"LE", 3, less_equal},
    {"AND", 2, linuxcnc::both},
    {"OR", 2, linuxcnc::either},
    {"XOR", 2, linuxcnc::one_of},
});

// Fanuc's AND has the rank of a product, its OR and XOR that of a sum.
constexpr auto fanuc_infixes = std::to_array<Infix>({
    {"**", 6, power},
    {"*", 5, multiply},
    {"/", 5, divide},
    {"MOD", 5, fanuc::modulo},
    {"AND", 5, fanuc::both},
    {"+", 4, add},
    {"-", 4, subtract},
    {"OR", 4, fanuc::either},
    {"XOR", 4, fanuc::one_of},
    {"EQ", 3, fanuc::equal},
    {"NE", 3, fanuc::unequal},
    {"GT", 3, greater},
    {"GE", 3, greater_equal},
    {"LT", 3, less},
    {"LE", 3, less_equal},
});

constexpr auto prefixes = std::to_array<Prefix>({
    {"-", 7, [](double v) { return -number(v); }},
    {"+", 7, number},
});

constexpr std::array<Function, 9> shared_functions{{
    {"SIN", 1, [](double v, double) { return std::sin(number(v) * degree); }},
    {"COS", 1, [](double v, double) { return std::cos(number(v) * degree); }},
    {"TAN", 1, [](double v, double) { return std::tan(number(v) * degree); }},
    {"ASIN", 1, [](double v, double) { return std::asin(number(v)) / degree; }},
    {"ACOS", 1, [](double v, double) { return std::acos(number(v)) / degree; }},
    {"ABS", 1, [](double v, double) { return std::abs(number(v)); }},
    {"SQRT", 1, [](double v, double) { return std::sqrt(number(v)); }},
    {"EXP", 1, [](double v, double) { return std::exp(number(v)); }},
    {"LN", 1, [](double v, double) { return std::log(number(v)); }},
}};

template <std::size_t Count>
constexpr auto with_shared(const Function (&own)[Count]) {
  std::array<Function, shared_functions.size() + Count> all{};
  std::copy(shared_functions.begin(), shared_functions.end(), all.begin());
  std::copy(std::begin(own), std::end(own), all.begin() + shared_functions.size());
  return all;
}

constexpr auto linuxcnc_functions = with_shared({
    {"FIX", 1, [](double v, double) { return std::floor(v); }},
    {"FUP", 1, [](double v, double) { return std::ceil(v); }},
    {"ROUND", 1, [](double v, double) { return std::round(v); }},
});

// FIX rounds towards zero, FUP away from it. ROUND depends on the word and is not in the table.
constexpr auto fanuc_functions = with_shared({
    {"FIX", 1, [](double v, double) { return std::trunc(number(v)); }},
    {"FUP", 1, [](double v, double) { return std::copysign(std::ceil(std::abs(number(v))), number(v)); }},
    {"POW", 2, power},
    {"BIN", 1, to_binary},
    {"BCD", 1, to_decimal_code},
    {"SQR", 1, [](double v, double) { return std::sqrt(number(v)); }},
});

constexpr ExpressionGrammar linuxcnc_grammar{
    .infixes = linuxcnc_infixes,
    .prefixes = prefixes,
    .functions = linuxcnc_functions,
    .open = '[',
    .close = ']',
    .digit_ends_name = true,
};

constexpr ExpressionGrammar fanuc_grammar{
    .infixes = fanuc_infixes,
    .prefixes = prefixes,
    .functions = fanuc_functions,
    .open = '[',
    .close = ']',
    .digit_ends_name = true,
};

}  // namespace

double null_value() {
  return std::numeric_limits<double>::quiet_NaN();
}

bool is_null(double value) {
  return std::isnan(value);
}

std::string normal_name(std::string_view name) {
  std::string normal;
  for (const char c : name) {
    if (!letters::is_blank(c)) {
      normal += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    }
  }
  return normal;
}

Expression::Expression(Dialect dialect, VariableSource& variables)
    : ExpressionReader(follows_linuxcnc(dialect) ? linuxcnc_grammar : fanuc_grammar),
      variables_(variables),
      linuxcnc_(follows_linuxcnc(dialect)) {}

std::uint32_t Expression::variable_number(Scanner& scanner) {
  constexpr double largest = 4e9;
  constexpr double whole_within = 1e-4;
  const std::uint32_t column = scanner.column();
  const double value = number(read_operand(scanner));
  const double whole = std::round(value);
  if (!(whole >= 0 && whole <= largest && std::abs(value - whole) <= whole_within)) {
    throw ReadFault{"variable", column, message(NC_("core", "\"{}\" is not a variable number"), value),
                    NC_("core", "the block does not move; variable numbers are whole and start at 0")};
  }
  return static_cast<std::uint32_t>(whole);
}

std::string Expression::variable_name(Scanner& scanner) {
  const std::uint32_t column = scanner.column();
  if (!scanner.take('<')) {
    return {};
  }
  const std::size_t end = scanner.text().find('>', scanner.at());
  if (end == std::string_view::npos) {
    throw ReadFault{"expression", column, NC_("core", "\">\" is missing after the name"),
                    NC_("core", "close the name with \">\"")};
  }
  std::string name = normal_name(scanner.text().substr(scanner.at(), end - scanner.at()));
  scanner.move_to(end + 1);
  if (name.empty()) {
    throw ReadFault{"expression", column, NC_("core", "the name between \"<\" and \">\" is empty"),
                    NC_("core", "write a name")};
  }
  return name;
}

std::optional<double> Expression::variable(Scanner& scanner) {
  const std::uint32_t column = scanner.column();
  if (scanner.take('#')) {
    const std::string name = variable_name(scanner);
    return name.empty() ? variables_.numbered(variable_number(scanner), column)
                        : variables_.named(name, column);
  }
  if (scanner.take_name("ATAN")) {
    return arc_tangent(scanner);
  }
  if (linuxcnc_ && scanner.take_name("EXISTS")) {
    return exists(scanner);
  }
  if (!linuxcnc_ && scanner.take_name("ROUND")) {
    expect(scanner, '[');
    const double value = number(read(scanner));
    expect(scanner, ']');
    return std::round(value / rounding_step_) * rounding_step_;
  }
  return std::nullopt;
}

double Expression::arc_tangent(Scanner& scanner) {
  expect(scanner, '[');
  const double rise = number(read(scanner));
  if (scanner.take(',')) {
    const double run = number(read(scanner));
    expect(scanner, ']');
    return direction(rise, run);
  }
  expect(scanner, ']');
  Scanner run_follows = scanner;
  if (!(run_follows.take('/') && run_follows.take('['))) {
    return std::atan(rise) / degree;
  }
  const double run = number(read(run_follows));
  expect(run_follows, ']');
  scanner = run_follows;
  return direction(rise, run);
}

double Expression::direction(double rise, double run) const {
  const double angle = std::atan2(rise, run) / degree;
  return !linuxcnc_ && angle < 0 ? angle + 360 : angle;
}

double Expression::exists(Scanner& scanner) {
  expect(scanner, '[');
  expect(scanner, '#');
  const std::string name = variable_name(scanner);
  if (name.empty()) {
    throw ReadFault{"expression", scanner.column(), NC_("core", "EXISTS needs a named variable"),
                    NC_("core", "write EXISTS[#<name>]")};
  }
  expect(scanner, ']');
  return variables_.has_name(name) ? 1 : 0;
}

}  // namespace feedscope::iso

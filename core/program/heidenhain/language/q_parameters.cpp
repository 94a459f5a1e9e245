#include "core/program/heidenhain/language/q_parameters.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/base/units.h"
#include "core/program/text/message.h"
#include "core/program/text/read_fault.h"

namespace feedscope::heidenhain {

namespace {

using Infix = ExpressionGrammar::Infix;
using Prefix = ExpressionGrammar::Prefix;
using Function = ExpressionGrammar::Function;

constexpr int sign_rank = 4;
/// Largest value of a word; intermediate results of formulas may exceed it.
constexpr double largest_value = 1e9;

constexpr auto infixes = std::to_array<Infix>({
    {"+", 1, [](double a, double b) { return a + b; }},
    {"-", 1, [](double a, double b) { return a - b; }},
    {"*", 2, [](double a, double b) { return a * b; }},
    {"/", 2, [](double a, double b) { return a / b; }},
    {"%", 2, [](double a, double b) { return std::fmod(a, b); }},
    {"^", 3, [](double a, double b) { return std::pow(a, b); }},
});

constexpr auto prefixes = std::to_array<Prefix>({
    {"+", sign_rank, [](double a) { return a; }},
    {"-", sign_rank, [](double a) { return -a; }},
});

constexpr auto functions = std::to_array<Function>({
    {"SIN", 1, [](double a, double) { return std::sin(units::from_deg(a)); }},
    {"COS", 1, [](double a, double) { return std::cos(units::from_deg(a)); }},
    {"TAN", 1, [](double a, double) { return std::tan(units::from_deg(a)); }},
    {"ASIN", 1, [](double a, double) { return units::to_deg(std::asin(a)); }},
    {"ACOS", 1, [](double a, double) { return units::to_deg(std::acos(a)); }},
    {"ATAN", 1, [](double a, double) { return units::to_deg(std::atan(a)); }},
    {"SQRT", 1, [](double a, double) { return std::sqrt(a); }},
    {"SQ", 1, [](double a, double) { return a * a; }},
    {"ABS", 1, [](double a, double) { return std::abs(a); }},
    {"LN", 1, [](double a, double) { return std::log(a); }},
    {"LOG", 1, [](double a, double) { return std::log10(a); }},
    {"EXP", 1, [](double a, double) { return std::exp(a); }},
    {"NEG", 1, [](double a, double) { return -a; }},
    {"INT", 1, [](double a, double) { return std::trunc(a); }},
    {"FRAC", 1, [](double a, double) { return a - std::trunc(a); }},
    {"SGN", 1, [](double a, double) { return a < 0 ? -1.0 : static_cast<double>(a > 0); }},
});

const ExpressionGrammar grammar{.infixes = infixes,
                                .prefixes = prefixes,
                                .functions = functions,
                                .bare_arguments = true,
                                .decimal_comma = true};

int most_of(QName::Kind kind) {
  return kind == QName::Kind::local || kind == QName::Kind::remanent ? 499 : 1999;
}

constexpr std::string_view letters_of(QName::Kind kind) {
  constexpr std::array<std::string_view, 4> names{"Q", "QL", "QR", "QS"};
  return names[static_cast<std::size_t>(kind)];
}

}  // namespace

std::string QName::text() const {
  return fmt::format("{}{}", letters_of(kind), number);
}

std::optional<QName> take_parameter(Scanner& scanner) {
  if (letters::to_upper(scanner.peek()) != 'Q') {
    return std::nullopt;
  }
  QName name;
  name.column = scanner.column();
  std::size_t digits = 1;
  switch (letters::to_upper(scanner.peek_at(1))) {
    case 'L':
      name.kind = QName::Kind::local;
      break;
    case 'R':
      name.kind = QName::Kind::remanent;
      break;
    case 'S':
      name.kind = QName::Kind::text;
      break;
    default:
      digits = 0;
      break;
  }
  ++digits;
  if (!letters::is_digit(scanner.peek_at(digits))) {
    return std::nullopt;
  }
  constexpr int beyond = 100000;
  for (; letters::is_digit(scanner.peek_at(digits)); ++digits) {
    name.number = std::min(name.number * 10 + (scanner.peek_at(digits) - '0'), beyond);
  }
  scanner.move_to(scanner.at() + digits);
  if (name.number > most_of(name.kind)) {
    throw ReadFault{"parameter-number", name.column,
                    message(NC_("core", "parameter {} does not exist"), in_quotes(name.text())),
                    message(NC_("core", "the last one is {}{}"), letters_of(name.kind), most_of(name.kind))};
  }
  return name;
}

const std::vector<std::optional<double>>& QParameters::values_of(QName::Kind kind) const {
  return kind == QName::Kind::local ? locals_ : kind == QName::Kind::remanent ? remanents_ : globals_;
}

std::optional<double> QParameters::get(const QName& name) const {
  const auto& values = values_of(name.kind);
  const auto i = static_cast<std::size_t>(name.number);
  return i < values.size() ? values[i] : std::nullopt;
}

void QParameters::set(const QName& name, double value) {
  auto& values = name.kind == QName::Kind::local      ? locals_
                 : name.kind == QName::Kind::remanent ? remanents_
                                                      : globals_;
  const auto i = static_cast<std::size_t>(name.number);
  if (i >= values.size()) {
    values.resize(i + 1);
  }
  values[i] = value;
}

const std::string& QParameters::text(int number) const {
  static const std::string empty;
  const auto i = static_cast<std::size_t>(number);
  return i < texts_.size() ? texts_[i] : empty;
}

void QParameters::set_text(int number, std::string value) {
  const auto i = static_cast<std::size_t>(number);
  if (i >= texts_.size()) {
    texts_.resize(i + 1);
  }
  texts_[i] = std::move(value);
}

QParameters::Locals QParameters::exchange_locals(Locals values) {
  return std::exchange(locals_, std::move(values));
}

QFormulas::QFormulas(const QParameters& parameters, Unset unset)
    : ExpressionReader(grammar), parameters_(parameters), unset_(std::move(unset)) {}

double QFormulas::read_value(Scanner& scanner) {
  const std::uint32_t column = scanner.column();
  const double sign = scanner.take('-') ? -1 : 1;
  if (sign > 0) {
    scanner.take('+');
  }
  if (const std::optional<double> number = scanner.number(true)) {
    return sign * *number;
  }
  if (const std::optional<double> value = variable(scanner)) {
    if (!(std::abs(*value) <= largest_value)) {
      throw ReadFault{
          "number-range", column,
          message(NC_("core", "the parameter's value {} is beyond the largest number, 1000000000"), *value),
          NC_("core", "the block is skipped; check how the parameter is calculated")};
    }
    return sign * *value;
  }
  throw ReadFault{"malformed-number", column,
                  scanner.at_end()
                      ? NC_("core", "a number is missing at the end of the block")
                      : message(NC_("core", "{} is not a number or parameter"), in_quotes(scanner.rest())),
                  NC_("core", "the block is skipped; write a number or a Q parameter here")};
}

std::optional<double> QFormulas::variable(Scanner& scanner) {
  const std::optional<QName> name = take_parameter(scanner);
  if (!name) {
    return scanner.take_name("PI") ? std::optional(units::pi) : std::nullopt;
  }
  if (name->kind == QName::Kind::text) {
    throw ReadFault{"expression", name->column,
                    message(NC_("core", "{} holds a text, not a number"), name->text()),
                    NC_("core", "texts are not converted to numbers; write the number")};
  }
  const std::optional<double> value = parameters_.get(*name);
  return value ? *value : unset_(*name);
}

}  // namespace feedscope::heidenhain

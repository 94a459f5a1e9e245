#include "core/program/sinumerik/language/grammar.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "core/base/units.h"

namespace feedscope::sinumerik {

namespace {

std::int64_t bits(double value) {
  return static_cast<std::int64_t>(std::clamp(std::trunc(value), -9e15, 9e15));
}

/// REAL values are compared relatively, so that 10 * 0.1 equals 1.
bool same(double a, double b) {
  constexpr double share = 1e-12;
  return std::abs(a - b) <= share * std::max(std::abs(a), std::abs(b));
}

constexpr int compare = 1;
constexpr int logic_or = 2;
constexpr int logic_xor = 3;
constexpr int logic_and = 4;
constexpr int bit_or = 5;
constexpr int bit_xor = 6;
constexpr int bit_and = 7;
constexpr int sum = 8;
constexpr int product = 9;
constexpr int sign = 10;

constexpr int ends_expression = -1;

constexpr auto infixes = std::to_array<ExpressionGrammar::Infix>({
    {"<<", ends_expression, nullptr},  // joins texts; Values reads them
    {"==", compare, [](double a, double b) { return same(a, b) ? 1.0 : 0.0; }},
    {"<>", compare, [](double a, double b) { return same(a, b) ? 0.0 : 1.0; }},
    {"<=", compare, [](double a, double b) { return a < b || same(a, b) ? 1.0 : 0.0; }},
    {">=", compare, [](double a, double b) { return a > b || same(a, b) ? 1.0 : 0.0; }},
    {"<", compare, [](double a, double b) { return a < b && !same(a, b) ? 1.0 : 0.0; }},
    {">", compare, [](double a, double b) { return a > b && !same(a, b) ? 1.0 : 0.0; }},
    {"OR", logic_or, [](double a, double b) { return a != 0 || b != 0 ? 1.0 : 0.0; }},
    {"XOR", logic_xor, [](double a, double b) { return (a != 0) != (b != 0) ? 1.0 : 0.0; }},
    {"AND", logic_and, [](double a, double b) { return a != 0 && b != 0 ? 1.0 : 0.0; }},
    {"B_OR", bit_or, [](double a, double b) { return static_cast<double>(bits(a) | bits(b)); }},
    {"B_XOR", bit_xor, [](double a, double b) { return static_cast<double>(bits(a) ^ bits(b)); }},
    {"B_AND", bit_and, [](double a, double b) { return static_cast<double>(bits(a) & bits(b)); }},
    {"+", sum, [](double a, double b) { return a + b; }},
    {"-", sum, [](double a, double b) { return a - b; }},
    {"*", product, [](double a, double b) { return a * b; }},
    {"/", product, [](double a, double b) { return a / b; }},
    {"DIV", product, [](double a, double b) { return std::trunc(a / b); }},
    {"MOD", product, [](double a, double b) { return std::fmod(a, b); }},
});

constexpr auto prefixes = std::to_array<ExpressionGrammar::Prefix>({
    {"-", sign, [](double a) { return -a; }},
    {"+", sign, [](double a) { return a; }},
    {"NOT", sign, [](double a) { return a == 0 ? 1.0 : 0.0; }},
    {"B_NOT", sign, [](double a) { return static_cast<double>(~bits(a)); }},
});

constexpr auto math_functions = std::to_array<ExpressionGrammar::Function>({
    {"SIN", 1, [](double a, double) { return std::sin(units::from_deg(a)); }},
    {"COS", 1, [](double a, double) { return std::cos(units::from_deg(a)); }},
    {"TAN", 1, [](double a, double) { return std::tan(units::from_deg(a)); }},
    {"ASIN", 1, [](double a, double) { return units::to_deg(std::asin(a)); }},
    {"ACOS", 1, [](double a, double) { return units::to_deg(std::acos(a)); }},
    {"ATAN2", 2, [](double y, double x) { return units::to_deg(std::atan2(y, x)); }},
    {"SQRT", 1, [](double a, double) { return std::sqrt(a); }},
    {"POT", 1, [](double a, double) { return a * a; }},
    {"ABS", 1, [](double a, double) { return std::abs(a); }},
    {"TRUNC", 1, [](double a, double) { return std::trunc(a); }},
    {"ROUND", 1, [](double a, double) { return std::floor(a + 0.5); }},
    {"ROUNDUP", 1, [](double a, double) { return std::ceil(a); }},
    {"LN", 1, [](double a, double) { return std::log(a); }},
    {"EXP", 1, [](double a, double) { return std::exp(a); }},
    {"MINVAL", 2, [](double a, double b) { return std::min(a, b); }},
    {"MAXVAL", 2, [](double a, double b) { return std::max(a, b); }},
});

}  // namespace

const ExpressionGrammar& grammar() {
  static const ExpressionGrammar all = [] {
    ExpressionGrammar made;
    made.infixes = infixes;
    made.prefixes = prefixes;
    made.functions = math_functions;
    made.scale = "EX";
    return made;
  }();
  return all;
}

}  // namespace feedscope::sinumerik

#include "core/limits/formula.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/geometry.h"
#include "core/machine/axis_vector.h"

namespace feedscope {
namespace {

struct SymbolText {
  Symbol symbol;
  Dimension dimension;
  std::string_view text;  ///< {} is replaced by the axis
};

/// In the order of Symbol.
constexpr std::array symbols{
    SymbolText{Symbol::feed, Dimension::feed, "F"},
    SymbolText{Symbol::axis_velocity, Dimension::feed, "V_{}"},
    SymbolText{Symbol::axis_acceleration, Dimension::acceleration, "A_{}"},
    SymbolText{Symbol::axis_jerk, Dimension::jerk, "J_{}"},
    SymbolText{Symbol::blend_jerk, Dimension::jerk, "Jtb_{}"},
    SymbolText{Symbol::tangent_part, Dimension::number, "|t_{}|"},
    SymbolText{Symbol::normal_part, Dimension::number, "|n_{}|"},
    SymbolText{Symbol::radius, Dimension::length, "R"},
    SymbolText{Symbol::curvature_slope, Dimension::inverse_area, "|k'|"},
    SymbolText{Symbol::acceleration_share, Dimension::number, "R_A"},
    SymbolText{Symbol::jerk_share, Dimension::number, "R_J"},
    SymbolText{Symbol::speed_slope, Dimension::inverse_length, "|s'|"},
    SymbolText{Symbol::speed_bend, Dimension::inverse_area, "|s'' - k^2|"},
    SymbolText{Symbol::curvilinear_jerk, Dimension::jerk, "J_curv"},
    SymbolText{Symbol::tangential_share, Dimension::number, "r_jct"},
    SymbolText{Symbol::curvature_step, Dimension::inverse_length, "|dk_{}|"},
    SymbolText{Symbol::period, Dimension::time, "t_cy"},
    SymbolText{Symbol::block_time, Dimension::time, "t_b"},
    SymbolText{Symbol::block_length, Dimension::length, "L"},
    SymbolText{Symbol::path_acceleration, Dimension::acceleration, "A"},
    SymbolText{Symbol::path_jerk, Dimension::jerk, "J"},
    SymbolText{Symbol::length_ahead, Dimension::length, "L_N"},
    SymbolText{Symbol::blocks_ahead, Dimension::number, "N"},
    SymbolText{Symbol::speed_before, Dimension::feed, "V_0"},
    SymbolText{Symbol::speed_after, Dimension::feed, "V_1"},
    SymbolText{Symbol::filters, Dimension::number, "n"},
    SymbolText{Symbol::filter_time, Dimension::time, "T_1"},
    SymbolText{Symbol::leg_before, Dimension::length, "l_1"},
    SymbolText{Symbol::leg_after, Dimension::length, "l_2"},
    SymbolText{Symbol::turn, Dimension::angle, "phi"},
    SymbolText{Symbol::filter_angle, Dimension::angle, "x"},
    SymbolText{Symbol::acceleration_along, Dimension::acceleration, "a_t{}"},
    SymbolText{Symbol::acceleration_across, Dimension::acceleration, "a_n{}"},
    SymbolText{Symbol::jerk_along, Dimension::jerk, "j_t{}"},
    SymbolText{Symbol::jerk_across, Dimension::jerk, "j_n{}"},
    SymbolText{Symbol::turning_share, Dimension::number, "S"},
    SymbolText{Symbol::bend_part, Dimension::inverse_length, "|k_{}|"},
    SymbolText{Symbol::bend_change_part, Dimension::inverse_area, "|k'_{}|"},
    SymbolText{Symbol::ceiling, Dimension::feed, "V"},
    SymbolText{Symbol::junction_deviation, Dimension::length, "d"},
    SymbolText{Symbol::half_turn_sine, Dimension::number, "s"},
    SymbolText{Symbol::half_turn_tangent, Dimension::number, "t"},
    SymbolText{Symbol::corner_velocity, Dimension::feed, "V_sc"},
    SymbolText{Symbol::path_velocity, Dimension::feed, "V_max"},
    SymbolText{Symbol::largest_acceleration, Dimension::acceleration, "A_max"},
    SymbolText{Symbol::rotary_velocity, Dimension::turning, "W_{}"},
    SymbolText{Symbol::rotary_acceleration, Dimension::turning_acceleration, "A_{}"},
    SymbolText{Symbol::rotary_jerk, Dimension::turning_jerk, "J_{}"},
    SymbolText{Symbol::turn_slope, Dimension::turn_slope, "|q'_{}|"},
    SymbolText{Symbol::turn_bend, Dimension::turn_bend, "|q''_{}|"},
    SymbolText{Symbol::turn_change, Dimension::turn_change, "|q'''_{}|"},
    SymbolText{Symbol::jump_share, Dimension::number, "R_v"},
    SymbolText{Symbol::turn_step, Dimension::turn_slope, "|dq'_{}|"},
    SymbolText{Symbol::axis_slope, Dimension::number, "|q'_{}|"},
    SymbolText{Symbol::axis_bend, Dimension::inverse_length, "|q''_{}|"},
    SymbolText{Symbol::axis_change, Dimension::inverse_area, "|q'''_{}|"},
    SymbolText{Symbol::axis_step, Dimension::number, "|dq'_{}|"},
};

using Values = std::array<double, 5>;

struct FormulaText {
  FormulaId id;
  Dimension dimension;
  std::string_view left;
  std::string_view right;  ///< {0}, {1} ... are replaced by the numbers
  double (*value)(const Values& x);
};

double square(double x) {
  return x * x;
}

/// In the order of FormulaId.
constexpr std::array formulas{
    FormulaText{FormulaId::none, Dimension::number, "", "", [](const Values&) { return 0.0; }},
    FormulaText{FormulaId::programmed_feed, Dimension::feed, "V", "{0}",
                [](const Values& x) { return x[0]; }},
    FormulaText{FormulaId::axis_velocity, Dimension::feed, "V", "{0} / {1}",
                [](const Values& x) { return x[0] / x[1]; }},
    FormulaText{FormulaId::path_acceleration, Dimension::acceleration, "a", "{0} / {1}",
                [](const Values& x) { return x[0] / x[1]; }},
    FormulaText{FormulaId::path_jerk, Dimension::jerk, "j", "{0} / {1}",
                [](const Values& x) { return x[0] / x[1]; }},
    FormulaText{FormulaId::acceleration_jump, Dimension::jerk, "j", "{0} / {1}",
                [](const Values& x) { return x[0] / x[1]; }},
    FormulaText{FormulaId::shared_acceleration, Dimension::acceleration, "a", "(1 - {0}) {1} / {2}",
                [](const Values& x) { return (1 - x[0]) * x[1] / x[2]; }},
    FormulaText{FormulaId::shared_jerk, Dimension::jerk, "j", "(1 - {0}) {1} / {2}",
                [](const Values& x) { return (1 - x[0]) * x[1] / x[2]; }},
    FormulaText{FormulaId::radial_acceleration, Dimension::feed, "V", "({0} {1} / {2})^(1/2)",
                [](const Values& x) { return std::sqrt(x[0] * x[1] / x[2]); }},
    FormulaText{FormulaId::radial_jerk, Dimension::feed, "V", "({0} {1}^2 / {2})^(1/3)",
                [](const Values& x) { return std::cbrt(x[0] * square(x[1]) / x[2]); }},
    FormulaText{FormulaId::shared_radial_acceleration, Dimension::feed, "V", "({0} {1} {2} / {3})^(1/2)",
                [](const Values& x) { return std::sqrt(x[0] * x[1] * x[2] / x[3]); }},
    FormulaText{FormulaId::shared_radial_jerk, Dimension::feed, "V", "({0} {1} / ({2} {3}))^(1/3)",
                [](const Values& x) { return std::cbrt(x[0] * x[1] / (x[2] * x[3])); }},
    FormulaText{FormulaId::arc_blend_radial_jerk, Dimension::feed, "V", "({0} {1} {2}^2)^(1/3)",
                [](const Values& x) { return std::cbrt(x[0] * x[1] * square(x[2])); }},
    FormulaText{FormulaId::jerk_across, Dimension::jerk, "|3 v a k + v^3 k'|", "{0} {1} / {2}",
                [](const Values& x) { return x[0] * x[1] / x[2]; }},
    FormulaText{FormulaId::steady_acceleration, Dimension::feed, "V", "((1 - {0}) {1} / ({2} {3}))^(1/2)",
                [](const Values& x) { return std::sqrt((1 - x[0]) * x[1] / (x[2] * x[3])); }},
    FormulaText{FormulaId::steady_jerk, Dimension::feed, "V", "((1 - {0}) {1} / ({2} {3}))^(1/3)",
                [](const Values& x) { return std::cbrt((1 - x[0]) * x[1] / (x[2] * x[3])); }},
    FormulaText{FormulaId::curvilinear_jerk, Dimension::feed, "V", "({0} {1} {2}^2)^(1/3)",
                [](const Values& x) { return std::cbrt(x[0] * x[1] * square(x[2])); }},
    FormulaText{FormulaId::curvature_crossing, Dimension::feed, "V", "({0} {1} / {2})^(1/2)",
                [](const Values& x) { return std::sqrt(x[0] * x[1] / x[2]); }},
    FormulaText{FormulaId::interpolation_period, Dimension::feed, "V", "{0} / {1}",
                [](const Values& x) { return x[0] / x[1]; }},
    FormulaText{FormulaId::block_time, Dimension::feed, "V", "{0} / {1}",
                [](const Values& x) { return x[0] / x[1]; }},
    FormulaText{FormulaId::horizon_jerk, Dimension::feed, "V", "({0} {1}^2)^(1/3)",
                [](const Values& x) { return std::cbrt(x[0] * square(x[1])); }},
    FormulaText{FormulaId::horizon_acceleration, Dimension::feed, "V",
                "(({0}^2 / (2 {1}))^2 + 2 {0} {2})^(1/2) - {0}^2 / (2 {1})",
                [](const Values& x) {
                  const double half = square(x[0]) / (2 * x[1]);
                  return std::sqrt(square(half) + 2 * x[0] * x[2]) - half;
                }},
    FormulaText{FormulaId::braking_jerk, Dimension::length, "L", "({0} + {1}) (({0} - {1}) / {2})^(1/2)",
                [](const Values& x) { return (x[0] + x[1]) * std::sqrt((x[0] - x[1]) / x[2]); }},
    FormulaText{FormulaId::braking_acceleration, Dimension::length, "L",
                "({0} + {1}) / 2 (({0} - {1}) / {2} + {2} / {3})",
                [](const Values& x) { return (x[0] + x[1]) / 2 * ((x[0] - x[1]) / x[2] + x[2] / x[3]); }},
    FormulaText{FormulaId::filter_delay, Dimension::time, "T_d", "{0} {1}",
                [](const Values& x) { return x[0] * x[1]; }},
    FormulaText{FormulaId::corner_error, Dimension::length, "eps", "({0} + {1}) sin({2} / 2)",
                [](const Values& x) { return (x[0] + x[1]) * std::sin(x[2] / 2); }},
    FormulaText{FormulaId::arc_error, Dimension::length, "eps", "{0} (1 - (sin({1}) / {1})^{2})",
                [](const Values& x) { return x[0] * (1 - std::pow(std::sin(x[1]) / x[1], x[2])); }},
    FormulaText{FormulaId::whole_acceleration, Dimension::acceleration, "a", "|{0} + {1}|",
                [](const Values& x) { return std::abs(x[0] + x[1]); }},
    FormulaText{FormulaId::whole_jerk, Dimension::jerk, "j", "|{0} + {1}|",
                [](const Values& x) { return std::abs(x[0] + x[1]); }},
    FormulaText{FormulaId::curve_acceleration, Dimension::feed, "V", "({0} {1} / {2})^(1/2)",
                [](const Values& x) { return std::sqrt(x[0] * x[1] / x[2]); }},
    FormulaText{FormulaId::curve_jerk, Dimension::feed, "V", "({0} {1} / {2})^(1/3)",
                [](const Values& x) { return std::cbrt(x[0] * x[1] / x[2]); }},
    FormulaText{FormulaId::curve_ramp_acceleration, Dimension::acceleration, "a", "({0} - {1}^2 {2}) / {3}",
                [](const Values& x) { return (x[0] - square(x[1]) * x[2]) / x[3]; }},
    FormulaText{FormulaId::curve_ramp_jerk, Dimension::jerk, "j", "({0} - {1}^3 {2}) / {3}",
                [](const Values& x) { return (x[0] - x[1] * square(x[1]) * x[2]) / x[3]; }},
    FormulaText{FormulaId::junction_deviation, Dimension::feed, "V", "({0} {2} {3} / ({1} (1 - {3})))^(1/2)",
                [](const Values& x) { return std::sqrt(x[0] * x[2] * x[3] / (x[1] * (1 - x[3]))); }},
    FormulaText{FormulaId::square_corner, Dimension::feed, "V",
                "{0} ((2^(1/2) - 1) {1} {2} / ((1 - {1}) {3}))^(1/2)",
                [](const Values& x) {
                  return x[0] * std::sqrt((std::sqrt(2.0) - 1) * x[1] * x[2] / ((1 - x[1]) * x[3]));
                }},
    FormulaText{FormulaId::corner_within_blocks, Dimension::feed, "V", "({0} {1} {2} / 2)^(1/2)",
                [](const Values& x) { return std::sqrt(x[0] * x[1] * x[2] / 2); }},
    FormulaText{FormulaId::stop_within_blocks, Dimension::feed, "V", "(2 {0} {1})^(1/2)",
                [](const Values& x) { return std::sqrt(2 * x[0] * x[1]); }},
    FormulaText{FormulaId::braking_evenly, Dimension::length, "L", "({0}^2 - {1}^2) / (2 {2})",
                [](const Values& x) { return (square(x[0]) - square(x[1])) / (2 * x[2]); }},
    FormulaText{FormulaId::path_velocity, Dimension::feed, "V", "{0}", [](const Values& x) { return x[0]; }},
    FormulaText{FormulaId::level_acceleration, Dimension::acceleration, "a", "{0}",
                [](const Values& x) { return x[0]; }},
    FormulaText{FormulaId::turning_velocity, Dimension::feed, "V", "{0} / {1}",
                [](const Values& x) { return x[0] / x[1]; }},
    FormulaText{FormulaId::turning_acceleration, Dimension::feed, "V", "({0} {1} / {2})^(1/2)",
                [](const Values& x) { return std::sqrt(x[0] * x[1] / x[2]); }},
    FormulaText{FormulaId::turning_jerk, Dimension::feed, "V", "({0} {1} / {2})^(1/3)",
                [](const Values& x) { return std::cbrt(x[0] * x[1] / x[2]); }},
    FormulaText{FormulaId::turning_jump, Dimension::feed, "V", "{0} {1} {2} / {3}",
                [](const Values& x) { return x[0] * x[1] * x[2] / x[3]; }},
    FormulaText{FormulaId::turning_ramp_acceleration, Dimension::acceleration, "a", "(1 - {0}) {1} / {2}",
                [](const Values& x) { return (1 - x[0]) * x[1] / x[2]; }},
    FormulaText{FormulaId::turning_ramp_jerk, Dimension::jerk, "j", "(1 - {0}) {1} / {2}",
                [](const Values& x) { return (1 - x[0]) * x[1] / x[2]; }},
    FormulaText{FormulaId::turning_ramp_bend, Dimension::acceleration, "a", "{0} {1} / (3 {2} {3})",
                [](const Values& x) { return x[0] * x[1] / (3 * x[2] * x[3]); }},
};

template <typename Table, typename Key>
constexpr bool in_order(const Table& table, Key Table::value_type::*key) {
  for (std::size_t i = 0; i < table.size(); ++i) {
    if (static_cast<std::size_t>(table[i].*key) != i) {
      return false;
    }
  }
  return true;
}
static_assert(in_order(symbols, &SymbolText::symbol));
static_assert(symbols.size() == static_cast<std::size_t>(Symbol::axis_step) + 1);
static_assert(in_order(formulas, &FormulaText::id));
static_assert(formulas.size() == static_cast<std::size_t>(FormulaId::turning_ramp_bend) + 1);

const FormulaText& text_of(FormulaId id) {
  return formulas[static_cast<std::size_t>(id)];
}

/// `pattern` with {i} replaced by `write(i)`.
template <typename Write>
std::string filled(std::string_view pattern, const Write& write) {
  std::string text;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    if (pattern[i] == '{') {
      text += write(static_cast<std::size_t>(pattern[i + 1] - '0'));
      i += 2;
    } else {
      text += pattern[i];
    }
  }
  return text;
}

/// `pattern` with signs between factors, which numbers need but symbols do not.
std::string with_factor_signs(std::string_view pattern) {
  const auto ends_factor = [](char c) { return c == '}' || c == ')' || (c >= '0' && c <= '9'); };
  const auto begins_factor = [](char c) { return c == '{' || c == '(' || c == 's'; };
  std::string text;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    const bool between = pattern[i] == ' ' && i > 0 && i + 1 < pattern.size() &&
                         ends_factor(pattern[i - 1]) && begins_factor(pattern[i + 1]);
    if (between) {
      text += " \u00b7 ";
    } else {
      text += pattern[i];
    }
  }
  return text;
}

}  // namespace

Dimension dimension_of(Symbol symbol) {
  return symbols[static_cast<std::size_t>(symbol)].dimension;
}

std::string symbol_text(const Quantity& quantity) {
  const std::string_view pattern = symbols[static_cast<std::size_t>(quantity.symbol)].text;
  const auto place = pattern.find("{}");
  if (place == std::string_view::npos) {
    return std::string(pattern);
  }
  const std::string axis(quantity.axis < 0 ? 0 : 1,
                         quantity.axis < 0 ? ' ' : cause_axes[static_cast<std::size_t>(quantity.axis)].name);
  return fmt::format("{}{}{}", pattern.substr(0, place), axis, pattern.substr(place + 2));
}

Dimension Formula::dimension() const {
  return text_of(id).dimension;
}

double Formula::value() const {
  Values values{};
  for (std::size_t i = 0; i < std::min(values.size(), numbers.size()); ++i) {
    values[i] = numbers[i].value;
  }
  return text_of(id).value(values);
}

std::string Formula::left() const {
  return std::string(text_of(id).left);
}

std::string Formula::text() const {
  return filled(text_of(id).right, [&](std::size_t i) { return symbol_text(numbers.at(i)); });
}

std::string Formula::with_numbers(const std::function<std::string(const Quantity&)>& write) const {
  std::string text = with_factor_signs(text_of(id).right);
  for (std::size_t i = 0; i < numbers.size(); ++i) {  // a power applies to the number with its unit
    const std::string raised = fmt::format("{{{}}}^", i);
    for (auto at = text.find(raised); at != std::string::npos; at = text.find(raised, at + raised.size())) {
      text.replace(at, raised.size(), fmt::format("({{{}}})^", i));
    }
  }
  return filled(text, [&](std::size_t i) { return write(numbers.at(i)); });
}

const Quantity* Formula::find(Symbol symbol) const {
  const auto found = std::ranges::find(numbers, symbol, &Quantity::symbol);
  return found == numbers.end() ? nullptr : &*found;
}

}  // namespace feedscope

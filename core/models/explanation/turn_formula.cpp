#include "core/models/explanation/turn_formula.h"

#include <array>
#include <cmath>
#include <optional>

#include "core/limits/cause.h"
#include "core/toolpath/turn_limiter.h"

namespace feedscope {
namespace {

/// Notation for a limit of a turn: its formula and the symbols of axis limit and derivative, for rotary and
/// for linear axes.
struct TurnSymbols {
  FormulaId id;
  std::array<Symbol, 2> limit;
  std::array<Symbol, 2> slope;
};

TurnSymbols symbols_of(TurnLimit::By by) {
  switch (by) {
    case TurnLimit::By::velocity:
      return {FormulaId::turning_velocity,
              {Symbol::rotary_velocity, Symbol::axis_velocity},
              {Symbol::turn_slope, Symbol::axis_slope}};
    case TurnLimit::By::acceleration:
      return {FormulaId::turning_acceleration,
              {Symbol::rotary_acceleration, Symbol::axis_acceleration},
              {Symbol::turn_bend, Symbol::axis_bend}};
    case TurnLimit::By::jerk:
      return {FormulaId::turning_jerk,
              {Symbol::rotary_jerk, Symbol::axis_jerk},
              {Symbol::turn_change, Symbol::axis_change}};
    case TurnLimit::By::jump:
      break;
  }
  return {FormulaId::turning_jump,
          {Symbol::rotary_acceleration, Symbol::axis_acceleration},
          {Symbol::turn_step, Symbol::axis_step}};
}

/// Limit of a rotary or a linear axis.
template <typename Axis>
double limit_of(const Axis& axis, TurnLimit::By by) {
  return by == TurnLimit::By::velocity ? axis.velocity
         : by == TurnLimit::By::jerk   ? axis.jerk
                                       : axis.acceleration;
}

/// Limit of an axis, an index of cause_axes, and its derivative by the path.
struct AxisTerms {
  Quantity limit;
  Quantity slope;
};

/// None if the machine lacks the axis. `of`: order of the derivative `slope`.
std::optional<AxisTerms> terms_of(std::int8_t axis, TurnLimit::By by, TurnLimit::By of, double slope,
                                  const Machine& machine) {
  if (axis < 0) {
    return std::nullopt;
  }
  const char name = cause_axes[static_cast<std::size_t>(axis)].name;
  const RotaryAxis* rotary = machine.kinematics.find(name);
  const AxisLimits* linear = machine.axes.find(name);
  if (rotary == nullptr && linear == nullptr) {
    return std::nullopt;
  }
  const std::size_t kind = rotary != nullptr ? 0 : 1;
  return AxisTerms{
      {symbols_of(by).limit[kind], axis, rotary != nullptr ? limit_of(*rotary, by) : limit_of(*linear, by)},
      {symbols_of(of).slope[kind], axis, slope}};
}

/// Formula of the share of an axis limit that turning takes, derived from the limit of a ramp along the path.
Formula formula_of_rest(FormulaId id, double along, const std::optional<AxisTerms>& terms) {
  if (!terms) {
    return {};
  }
  const double taken = 1 - along * terms->slope.value / terms->limit.value;
  return {id, {{Symbol::turning_share, -1, taken}, terms->limit, terms->slope}};
}

}  // namespace

Formula formula_of(const TurnLimit& limit, const Machine& machine, double period) {
  const std::optional<AxisTerms> terms = terms_of(limit.axis, limit.by, limit.by, limit.slope, machine);
  if (!terms) {
    return {};
  }
  const TurnSymbols symbols = symbols_of(limit.by);
  const auto& [axis, slope] = *terms;
  switch (limit.by) {
    case TurnLimit::By::velocity:
      return {symbols.id, {axis, slope}};
    case TurnLimit::By::jump:
      return {symbols.id, {{Symbol::jump_share, -1, jump_share}, axis, {Symbol::period, -1, period}, slope}};
    case TurnLimit::By::acceleration:
    case TurnLimit::By::jerk:
      break;
  }
  const double taken = std::pow(limit.speed, limit.by == TurnLimit::By::jerk ? 3 : 2) * limit.slope;
  return {symbols.id, {{Symbol::turning_share, -1, taken / axis.value}, axis, slope}};
}

Formula formula_of_acceleration(const TurnRamp& ramp, const Machine& machine, double speed) {
  using By = TurnLimit::By;
  if (!ramp.acceleration_by_jerk) {
    return formula_of_rest(
        FormulaId::turning_ramp_acceleration, ramp.acceleration,
        terms_of(ramp.acceleration_axis, By::acceleration, By::velocity, ramp.acceleration_slope, machine));
  }
  const auto terms =
      terms_of(ramp.acceleration_axis, By::jerk, By::acceleration, ramp.acceleration_slope, machine);
  if (!terms) {
    return {};
  }
  const double taken = 3 * terms->slope.value * speed * ramp.acceleration / terms->limit.value;
  return {FormulaId::turning_ramp_bend,
          {{Symbol::turning_share, -1, taken}, terms->limit, terms->slope, {Symbol::ceiling, -1, speed}}};
}

Formula formula_of_jerk(const TurnRamp& ramp, const Machine& machine) {
  using By = TurnLimit::By;
  return formula_of_rest(FormulaId::turning_ramp_jerk, ramp.jerk,
                         terms_of(ramp.jerk_axis, By::jerk, By::velocity, ramp.jerk_slope, machine));
}

}  // namespace feedscope

#include "core/analysis/explanation/turn_formula.h"

#include <array>
#include <cmath>

#include "core/limits/cause.h"
#include "core/toolpath/turn_limiter.h"

namespace feedscope {
namespace {

/// How a limit of a turn is written: its formula and the symbols of axis limit and derivative, for rotary
/// and for linear axes.
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

/// Of a rotary or a linear axis.
template <typename Axis>
double limit_of(const Axis& axis, TurnLimit::By by) {
  return by == TurnLimit::By::velocity ? axis.velocity
         : by == TurnLimit::By::jerk   ? axis.jerk
                                       : axis.acceleration;
}

}  // namespace

Formula formula_of(const TurnLimit& limit, const Machine& machine, double period) {
  if (limit.axis < 0) {
    return {};
  }
  const char name = cause_axes[static_cast<std::size_t>(limit.axis)].name;
  const RotaryAxis* rotary = machine.kinematics.find(name);
  const AxisLimits* linear = machine.axes.find(name);
  if (rotary == nullptr && linear == nullptr) {
    return {};
  }
  const TurnSymbols symbols = symbols_of(limit.by);
  const std::size_t kind = rotary != nullptr ? 0 : 1;
  const Quantity axis{symbols.limit[kind], limit.axis,
                      rotary != nullptr ? limit_of(*rotary, limit.by) : limit_of(*linear, limit.by)};
  const Quantity slope{symbols.slope[kind], limit.axis, limit.slope};
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

}  // namespace feedscope

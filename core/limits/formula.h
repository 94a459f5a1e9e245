#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/dimension.h"

namespace feedscope {

/// Quantities in formulas; `Quantity::axis` names the axis, if any.
enum class Symbol : std::uint8_t {
  feed,                  ///< F, programmed
  axis_velocity,         ///< V_X
  axis_acceleration,     ///< A_X
  axis_jerk,             ///< J_X
  blend_jerk,            ///< Jtb_X
  tangent_part,          ///< |t_X|, of the unit tangent
  normal_part,           ///< |n_X|, of the unit normal
  radius,                ///< R, of curvature
  curvature_slope,       ///< |k'|, change of the curvature along the path
  acceleration_share,    ///< R_A, radial
  jerk_share,            ///< R_J, radial
  speed_slope,           ///< s'|, at constant du/dt: change of the speed along the path, v'/v^2
  speed_bend,            ///< s'' - k^2|, at constant du/dt: jerk along the path divided by v^3
  curvilinear_jerk,      ///< J_curv
  tangential_share,      ///< r_jct
  curvature_step,        ///< |dk_X|, of the curvature vector
  period,                ///< t_cy, interpolation period
  block_time,            ///< t_b, time of the control for a block
  block_length,          ///< L, of a block or an arc
  path_acceleration,     ///< A, along the path
  path_jerk,             ///< J, along the path
  length_ahead,          ///< L_N, of the blocks known to the control
  blocks_ahead,          ///< N, blocks known to the control
  speed_before,          ///< V_0, at the start of a ramp
  speed_after,           ///< V_1, at its end
  filters,               ///< n, moving averages
  filter_time,           ///< T_1, of each filter
  leg_before,            ///< l_1, distance from the corner that the filters leave before it
  leg_after,             ///< l_2, after it
  turn,                  ///< phi, direction change
  filter_angle,          ///< x, V T_1 / (2 R)
  acceleration_along,    ///< a_tX, part of the acceleration of an axis along the path
  acceleration_across,   ///< a_nX, across it
  jerk_along,            ///< j_tX, part of the jerk of an axis along the path
  jerk_across,           ///< j_nX, across it
  turning_share,         ///< S, share of an axis limit that turning takes or may take
  bend_part,             ///< |k_X|, of the curvature vector
  bend_change_part,      ///< |k'_X|, of its change along the path
  ceiling,               ///< V, the highest speed on an element
  junction_deviation,    ///< d
  half_turn_sine,        ///< s, sine of half the angle between the blocks of a corner; 1: straight on
  half_turn_tangent,     ///< t, its tangent
  corner_velocity,       ///< V_sc, square corner velocity
  path_velocity,         ///< V_max, the control's limit of the speed
  largest_acceleration,  ///< A_max, the control's limit of the acceleration
  rotary_velocity,       ///< W_C, of a rotary axis
  rotary_acceleration,   ///< A_C
  rotary_jerk,           ///< J_C
  turn_slope,            ///< |q'_C|, turn of a rotary axis along the path of the tip
  turn_bend,             ///< |q''_C|
  turn_change,           ///< |q'''_C|
  jump_share,   ///< R_v, permitted velocity jump, as a share of what an axis can take up within a period
  turn_step,    ///< |dq'_C|, jump of q'_C where blocks meet
  axis_slope,   ///< |q'_X|, motion of a linear axis along the path of the tip
  axis_bend,    ///< |q''_X|
  axis_change,  ///< |q'''_X|
  axis_step,    ///< |dq'_X|
};

struct Quantity {
  Symbol symbol = Symbol::feed;
  std::int8_t axis = -1;  ///< index in cause_axes; -1 none
  double value = 0;       ///< internal units
};

Dimension dimension_of(Symbol symbol);
/// Text of a symbol: "J_X", "R", "|t_Y|".
std::string symbol_text(const Quantity& quantity);

/// Formula of a limit. By dimension its result is speed, acceleration or jerk along the path, or a length or
/// time named in the formula's text.
enum class FormulaId : std::uint8_t {
  none,
  programmed_feed,
  axis_velocity,
  path_acceleration,
  path_jerk,
  acceleration_jump,
  shared_acceleration,
  shared_jerk,
  radial_acceleration,
  radial_jerk,
  shared_radial_acceleration,
  shared_radial_jerk,
  arc_blend_radial_jerk,
  jerk_across,
  steady_acceleration,
  steady_jerk,
  curvilinear_jerk,
  curvature_crossing,
  interpolation_period,
  block_time,
  horizon_jerk,
  horizon_acceleration,
  braking_jerk,
  braking_acceleration,
  filter_delay,
  corner_error,
  arc_error,
  whole_acceleration,
  whole_jerk,
  curve_acceleration,
  curve_jerk,
  curve_ramp_acceleration,
  curve_ramp_jerk,
  junction_deviation,
  square_corner,
  corner_within_blocks,
  stop_within_blocks,
  braking_evenly,
  path_velocity,
  level_acceleration,
  turning_velocity,
  turning_acceleration,
  turning_jerk,
  turning_jump,
  turning_ramp_acceleration,
  turning_ramp_jerk,
  turning_ramp_bend,
};

/// A formula with the numbers at one place, in the order of its text.
struct Formula {
  FormulaId id = FormulaId::none;
  std::vector<Quantity> numbers;

  bool empty() const { return id == FormulaId::none; }
  Dimension dimension() const;  ///< of the result
  double value() const;         ///< of the right side, internal units; 0 if none
  std::string left() const;     ///< "V"
  /// Right side: "(J_X R^2 / |t_X|)^(1/3)".
  std::string text() const;
  /// Right side with `write` of every number in place of its symbol, in UTF-8: "(5 m/s3 · (2.5 mm)^2 /
  /// 0.8)^(1/3)".
  std::string with_numbers(const std::function<std::string(const Quantity&)>& write) const;
  /// Number with that symbol; null if there is none.
  const Quantity* find(Symbol symbol) const;
};

}  // namespace feedscope

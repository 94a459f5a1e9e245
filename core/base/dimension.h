#pragma once

#include <cstdint>
#include <string_view>

namespace feedscope {

/// What a number measures; with a UnitSystem it says how the number is shown.
enum class Dimension : std::uint8_t {
  number,                ///< without unit
  time,                  ///< inside [s]
  length,                ///< of paths and positions, inside [mm]
  inverse_length,        ///< inside [1/mm]
  inverse_area,          ///< inside [1/mm2]
  error,                 ///< small length, inside [mm]
  feed,                  ///< along the path, inside [mm/s]
  velocity,              ///< of an axis, inside [mm/s]
  acceleration,          ///< inside [mm/s2]
  jerk,                  ///< inside [mm/s3]
  ratio,                 ///< inside a share of 1
  pace,                  ///< time lost over length, inside [s/mm]
  angle,                 ///< inside [rad]
  force,                 ///< inside [N]
  torque,                ///< inside [N mm]
  power,                 ///< inside [N mm/s]
  turning,               ///< velocity of a rotary axis, inside [rad/s]
  turning_acceleration,  ///< inside [rad/s2]
  turning_jerk,          ///< inside [rad/s3]
  turn_slope,            ///< turn over path length, inside [rad/mm]
  turn_bend,             ///< its second derivative by path length, inside [rad/mm2]
  turn_change,           ///< its third one, inside [rad/mm3]
};

enum class UnitSystem : std::uint8_t { metric, inch };

/// How numbers of a dimension are shown.
struct ShownUnit {
  std::string_view text;  ///< "mm/min"; empty: none
  double factor = 1;      ///< shown unit an inside unit
  int decimals = 0;
};

/// The one place that says in which unit a number is shown.
const ShownUnit& shown_unit(Dimension dimension, UnitSystem system = UnitSystem::metric);

}  // namespace feedscope

#pragma once

#include <cstdint>
#include <string_view>

namespace feedscope {

/// Physical dimension of a number; with a UnitSystem it determines the display unit.
enum class Dimension : std::uint8_t {
  number,                ///< without unit
  time,                  ///< internally [s]
  length,                ///< of paths and positions, internally [mm]
  inverse_length,        ///< internally [1/mm]
  inverse_area,          ///< internally [1/mm2]
  error,                 ///< small length, internally [mm]
  feed,                  ///< along the path, internally [mm/s]
  velocity,              ///< of an axis, internally [mm/s]
  acceleration,          ///< internally [mm/s2]
  jerk,                  ///< internally [mm/s3]
  ratio,                 ///< internally a share of 1
  pace,                  ///< time lost per length, internally [s/mm]
  angle,                 ///< internally [rad]
  force,                 ///< internally [N]
  torque,                ///< internally [N mm]
  power,                 ///< internally [N mm/s]
  turning,               ///< velocity of a rotary axis, internally [rad/s]
  turning_acceleration,  ///< internally [rad/s2]
  turning_jerk,          ///< internally [rad/s3]
  turn_slope,            ///< rotation per path length, internally [rad/mm]
  turn_bend,             ///< its second derivative by path length, internally [rad/mm2]
  turn_change,           ///< its third one, internally [rad/mm3]
};

enum class UnitSystem : std::uint8_t { metric, inch };

/// Display unit of a dimension.
struct ShownUnit {
  std::string_view text;  ///< "mm/min"; empty if none
  double factor = 1;      ///< display units per internal unit
  int decimals = 0;
};

/// The only place that determines display units.
const ShownUnit& shown_unit(Dimension dimension, UnitSystem system = UnitSystem::metric);

}  // namespace feedscope

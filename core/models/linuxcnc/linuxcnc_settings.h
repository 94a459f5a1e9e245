#pragma once

#include <array>
#include <cstdint>

#include "core/base/geometry.h"
#include "core/machine/machine.h"
#include "core/machine/settings.h"

namespace feedscope {

/// Path control where the program says nothing: blended (G64), exact path (G61: stops where blocks are not
/// tangential), exact stop (G61.1: at the end of every block).
enum class LinuxCncPathMode : std::uint8_t { blend, exact_path, exact_stop };

/// What an INI file of LinuxCNC says of the planner, in inside units.
struct LinuxCncSettings {
  Vec3 velocity = Vec3::Zero();      ///< MAX_VELOCITY of the axes [mm/s]
  Vec3 acceleration = Vec3::Zero();  ///< MAX_ACCELERATION of the axes [mm/s2]
  /// The same of A, B and C [rad/s], [rad/s2]; 0: the machine does not have the axis.
  std::array<double, 3> turn_velocity{};
  std::array<double, 3> turn_acceleration{};
  double period = 1e-3;     ///< servo period T [s]
  double max_velocity = 0;  ///< MAX_LINEAR_VELOCITY [mm/s]
  double max_override = 1;  ///< MAX_FEED_OVERRIDE
  bool master = false;      ///< planner of master, else of 2.9
  LinuxCncPathMode path_mode = LinuxCncPathMode::blend;
  double blend_tolerance = 0;        ///< P of that G64; 0: as fast as possible [mm]
  double naive_tolerance = 0;        ///< Q of it; 0: blocks are not joined [mm]
  bool own_naive_tolerance = false;  ///< it is given, not that of blending
  bool follows_program = true;       ///< P and Q of the program hold before these

  LinuxCncSettings() = default;
  /// `settings` as complete_settings() gives them for the model: without a largest velocity there is none
  /// along the path, without a tolerance of joining that of blending, as of a G64 P without Q.
  LinuxCncSettings(const Machine& machine, const Settings& settings);
};

}  // namespace feedscope

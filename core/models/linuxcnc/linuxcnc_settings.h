#pragma once

#include <array>
#include <cstdint>

#include "core/base/geometry.h"
#include "core/machine/machine.h"
#include "core/machine/settings.h"

namespace feedscope {

/// Path control without words in the program: blended (G64), exact path (G61: stops where blocks are not
/// tangential), exact stop (G61.1: at the end of every block).
enum class LinuxCncPathMode : std::uint8_t { blend, exact_path, exact_stop };

/// Planner settings of a LinuxCNC INI file, in internal units.
struct LinuxCncSettings {
  Vec3 velocity = Vec3::Zero();      ///< MAX_VELOCITY of the axes [mm/s]
  Vec3 acceleration = Vec3::Zero();  ///< MAX_ACCELERATION of the axes [mm/s2]
  /// The same of A, B and C [rad/s], [rad/s2]; 0: not on this machine.
  std::array<double, 3> turn_velocity{};
  std::array<double, 3> turn_acceleration{};
  double period = 1e-3;     ///< servo period T [s]
  double max_velocity = 0;  ///< MAX_LINEAR_VELOCITY [mm/s]
  double max_override = 1;  ///< MAX_FEED_OVERRIDE
  bool master = false;      ///< planner of master, else of 2.9
  LinuxCncPathMode path_mode = LinuxCncPathMode::blend;
  double blend_tolerance = 0;        ///< P of the default G64; 0: as fast as possible [mm]
  double naive_tolerance = 0;        ///< Q of it; 0: blocks are not joined [mm]
  bool own_naive_tolerance = false;  ///< it is given; otherwise that of blending
  bool follows_program = true;       ///< P and Q of the program take precedence

  LinuxCncSettings() = default;
  /// `settings` as from complete_settings() for the model. Defaults: no largest velocity along the path; the
  /// tolerance of blending for that of joining, as for a G64 P without Q.
  LinuxCncSettings(const Machine& machine, const Settings& settings);
};

}  // namespace feedscope

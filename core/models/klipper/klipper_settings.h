#pragma once

#include "core/machine/machine.h"
#include "core/machine/settings.h"

namespace feedscope {

/// Limits of Klipper's [printer] section in inside units.
struct KlipperSettings {
  double max_velocity = 0;            ///< along the path [mm/s]
  double max_acceleration = 0;        ///< along the path [mm/s2]
  double square_corner_velocity = 0;  ///< [mm/s]
  double minimum_cruise_ratio = 0;
  double arc_resolution = 0;      ///< length of the chords of arcs [mm]
  double max_z_velocity = 0;      ///< [mm/s]
  double max_z_acceleration = 0;  ///< [mm/s2]

  /// `settings` as complete_settings() gives them for the model: without a largest velocity or acceleration
  /// the least of the axes, without one of Z that of the path.
  KlipperSettings(const Machine& machine, const Settings& settings);
};

}  // namespace feedscope

#pragma once

#include "core/machine/machine.h"
#include "core/machine/settings.h"

namespace feedscope {

/// Limits of Klipper's [printer] section in internal units.
struct KlipperSettings {
  double max_velocity = 0;            ///< along the path [mm/s]
  double max_acceleration = 0;        ///< along the path [mm/s2]
  double square_corner_velocity = 0;  ///< [mm/s]
  double minimum_cruise_ratio = 0;
  double arc_resolution = 0;      ///< length of the chords of arcs [mm]
  double max_z_velocity = 0;      ///< [mm/s]
  double max_z_acceleration = 0;  ///< [mm/s2]
  /// For moves of the extruder alone, max_extrude_only_velocity and _accel [mm/s], [mm/s2].
  double max_extrude_velocity = 0;
  double max_extrude_acceleration = 0;

  /// `settings` as from complete_settings() for the model. Defaults: the least velocity and acceleration of
  /// the axes; those of the path for Z; for the extruder Klipper's values for the usual nozzle and filament,
  /// extrude_only_share(0.4, 1.75) of the path's.
  KlipperSettings(const Machine& machine, const Settings& settings);

  /// Time of a move of the extruder alone over `length` [mm] at the feed `feed` [mm/s], planned from rest to
  /// rest (models/klipper/README.md, "Extruder") [s].
  double extrude_time(double length, double feed) const;
};

/// Share of the path's largest velocity and acceleration that Klipper allows the extruder alone, from the
/// diameters of nozzle and filament [mm] (Klipper, kinematics/extruder.py).
double extrude_only_share(double nozzle, double filament);

}  // namespace feedscope

#pragma once

#include <array>
#include <cstddef>

#include "core/machine/machine.h"
#include "core/machine/settings.h"

namespace feedscope {

/// Numbers of grbl: its own 32-bit numbers in its own units, mm and minutes.
struct GrblSettings {
  using Axes = std::array<float, 3>;

  Axes steps{};         ///< $100 to $102 [1/mm]; 0: not given, positions are not rounded to steps
  Axes rate{};          ///< $110 to $112 [mm/min]
  Axes acceleration{};  ///< $120 to $122 [mm/min2]
  float junction_deviation = 0.01F;  ///< $11 [mm]
  float arc_tolerance = 0.002F;      ///< $12 [mm]
  std::size_t buffer_blocks = 15;    ///< blocks that are planned together, including the running one
  double idle_delay = 0;             ///< $1 [s]
  bool step_timing = false;          ///< times of the step timer instead of planned ones

  /// `settings` as from complete_settings() for the model.
  GrblSettings(const Machine& machine, const Settings& settings);
  /// True if positions are whole steps.
  bool has_steps() const { return steps[0] > 0 && steps[1] > 0 && steps[2] > 0; }
};

}  // namespace feedscope

#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "core/base/units.h"
#include "core/load/engagement.h"
#include "core/machine/key_unit.h"

/// Numbers of an operation in load files.
namespace feedscope {

/// One number of an operation: either `needed` or `given` (optional) is set.
struct OperationKey {
  const char* key;
  double Engagement::*needed;
  std::optional<double> Engagement::*given;
  KeyConversion unit;
  double least;  ///< in the unit of the file; itself permitted only if `least_allowed`
  double most;   ///< in the unit of the file
  bool least_allowed;
};

inline constexpr KeyConversion as_written{units::as_it_is, units::as_it_is};

inline constexpr std::array<OperationKey, 10> operation_keys{{
    {"diameter_mm", &Engagement::diameter, nullptr, as_written, 0, 2000, false},
    {"helix_deg", &Engagement::helix, nullptr, {units::from_deg, units::to_deg}, 0, 80, true},
    {"ae_mm", &Engagement::radial_depth, nullptr, as_written, 0, 2000, false},
    {"ap_mm", &Engagement::axial_depth, nullptr, as_written, 0, 1000, false},
    {"spindle_1_min",
     nullptr,
     &Engagement::spindle_speed,
     {units::from_rev_min, units::to_rev_min},
     0,
     1e6,
     false},
    {"min_chip_um", nullptr, &Engagement::least_chip, {units::from_um, units::to_um}, 0, 1000, false},
    {"max_chip_um", nullptr, &Engagement::max_chip, {units::from_um, units::to_um}, 0, 10000, false},
    {"max_force_n", nullptr, &Engagement::max_force, as_written, 0, 1e7, false},
    {"max_torque_nm", nullptr, &Engagement::max_torque, {units::from_n_m, units::to_n_m}, 0, 1e6, false},
    {"max_power_kw", nullptr, &Engagement::max_power, {units::from_kw, units::to_kw}, 0, 1e5, false},
}};

}  // namespace feedscope

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/base/message.h"
#include "core/machine/settings.h"

namespace feedscope {

/// How one axis follows its set values: a position loop with velocity feed-forward around a velocity loop
/// that lags; core/drives/README.md has the equations. What a machine file does not give has no value; an
/// axis without a gain follows exactly.
struct AxisDrive {
  std::optional<double> gain;                   ///< Kv, position gain, > 0 [1/s]
  std::optional<double> feedforward;            ///< f, share of the set velocity that is fed forward, 0 to 1
  std::optional<double> lag;                    ///< Tv, time constant of the velocity loop [s]
  std::optional<double> backlash;               ///< that the motor takes up at a reversal [mm]
  std::optional<double> backlash_compensation;  ///< share of the backlash that the control makes up for
  std::optional<double> friction_spike;         ///< by how much the axis stays behind at a reversal [mm]
  std::optional<double> friction_time;          ///< time constant with which that decays [s]

  std::optional<double> steps_per_mm;  ///< of a stepper motor: places that it can stand at [1/mm]

  bool follows_exactly() const { return !gain.has_value(); }
  bool operator==(const AxisDrive&) const = default;
};

/// Keys of a drive for --set, machine files and the editor, each optional: kv (1/s), velocity_feedforward,
/// velocity_lag (ms), backlash (um), backlash_compensation, friction_spike (um), friction_time (ms),
/// steps_per_mm.
const std::vector<SettingSpec>& axis_drive_specs();
/// Value in the unit of axis_drive_specs(), an empty text if there is none; `i` counts there.
SettingValue drive_value(const AxisDrive& drive, std::size_t i);
/// Sets it; an empty text takes the value back. Throws InputError as check_setting().
void set_drive_value(AxisDrive& drive, std::size_t i, const SettingValue& value);

/// What is wrong with a drive as a whole, with what to do: other values without a gain, a friction spike
/// without its time. Empty if nothing is.
Message drive_problem(const AxisDrive& drive, char axis);

/// By how much a step of the set value is overshot, as a share of the step: that of a loop without
/// feed-forward, exp(-pi d/sqrt(1 - d^2)) with the damping d = 1/(2 sqrt(Kv Tv)); 0 where it is damped well
/// enough not to overshoot.
double drive_overshoot(const AxisDrive& drive);

}  // namespace feedscope

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/base/message.h"
#include "core/machine/settings.h"

namespace feedscope {

/// How one axis follows its set values: a position loop with velocity feed-forward around a velocity loop
/// with lag; equations in core/drives/README.md. Values missing in the machine file are empty; an axis
/// without a gain follows exactly.
struct AxisDrive {
  std::optional<double> gain;                   ///< Kv, position gain, > 0 [1/s]
  std::optional<double> feedforward;            ///< f, share of the set velocity fed forward, 0 to 1
  std::optional<double> lag;                    ///< Tv, time constant of the velocity loop [s]
  std::optional<double> backlash;               ///< taken up by the motor at a reversal [mm]
  std::optional<double> backlash_compensation;  ///< share of the backlash that the control compensates
  std::optional<double> friction_spike;         ///< by which the axis lags at a reversal [mm]
  std::optional<double> friction_time;          ///< time constant of its decay [s]

  std::optional<double> steps_per_mm;  ///< of a stepper motor, its resolution [1/mm]

  bool follows_exactly() const { return !gain.has_value(); }
  bool operator==(const AxisDrive&) const = default;
};

/// Keys of a drive for --set, machine files and the editor, each optional: kv (1/s), velocity_feedforward,
/// velocity_lag (ms), backlash (um), backlash_compensation, friction_spike (um), friction_time (ms),
/// steps_per_mm.
const std::vector<SettingSpec>& axis_drive_specs();
/// Value in the unit of axis_drive_specs(), an empty text if there is none; `i`: index of that list.
SettingValue drive_value(const AxisDrive& drive, std::size_t i);
/// Sets a value; an empty text clears it. Throws InputError as check_setting() does.
void set_drive_value(AxisDrive& drive, std::size_t i, const SettingValue& value);

/// Problem of a drive as a whole, with advice: other values without a gain, a friction spike without its
/// time. Empty if there is none.
Message drive_problem(const AxisDrive& drive, char axis);

/// Overshoot at a step of the set value, as a share of the step: that of a loop without feed-forward, exp(-pi
/// d/sqrt(1 - d^2)) with the damping d = 1/(2 sqrt(Kv Tv)); 0 if it is damped well enough.
double drive_overshoot(const AxisDrive& drive);

}  // namespace feedscope

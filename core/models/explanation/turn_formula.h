#pragma once

#include "core/limits/formula.h"
#include "core/machine/machine.h"
#include "core/toolpath/toolpath.h"

namespace feedscope {

/// Formula for a limit of a turn: the limit of its axis on `machine` and the derivative of the axis position
/// by the path, or the jump of that and the interpolation `period` [s]. None if the machine lacks the axis.
Formula formula_of(const TurnLimit& limit, const Machine& machine, double period);

/// Acceleration along the path that `ramp` allows, from what turning leaves of the limit of its axis; at
/// `speed` [mm/s] where curvature takes the jerk of the axis. None if the machine lacks the axis.
Formula formula_of_acceleration(const TurnRamp& ramp, const Machine& machine, double speed);
/// Jerk along the path, likewise.
Formula formula_of_jerk(const TurnRamp& ramp, const Machine& machine);

}  // namespace feedscope

#pragma once

#include "core/limits/formula.h"
#include "core/machine/machine.h"
#include "core/toolpath/toolpath.h"

namespace feedscope {

/// What a limit of a turn comes from: the limit of its axis on `machine` and the derivative of its place by
/// the path, or the jump of that and the interpolation `period` [s]. None where the machine lacks the axis.
Formula formula_of(const TurnLimit& limit, const Machine& machine, double period);

/// The acceleration along the path that `ramp` allows, from what turning leaves of the limit of its axis;
/// where bending takes the jerk of the axis, at `speed` [mm/s]. None where the machine lacks the axis.
Formula formula_of_acceleration(const TurnRamp& ramp, const Machine& machine, double speed);
/// The same of the jerk along the path.
Formula formula_of_jerk(const TurnRamp& ramp, const Machine& machine);

}  // namespace feedscope

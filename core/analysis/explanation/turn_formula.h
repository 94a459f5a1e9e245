#pragma once

#include "core/limits/formula.h"
#include "core/machine/machine.h"
#include "core/toolpath/toolpath.h"

namespace feedscope {

/// What a limit of a turn comes from: the limit of its axis on `machine` and the derivative of its place by
/// the path, or the jump of that and the interpolation `period` [s]. None where the machine lacks the axis.
Formula formula_of(const TurnLimit& limit, const Machine& machine, double period);

}  // namespace feedscope

#pragma once

#include "core/analysis/run.h"

namespace feedscope {

/// Servo period of the control or of the machine, at which its recorder takes samples unless told otherwise
/// [s]; 0 where neither has one. For TraceColumns::machine_period.
double servo_period_of(const Setup& setup);

}  // namespace feedscope

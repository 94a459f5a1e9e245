#pragma once

#include "core/analysis/run/run.h"

namespace feedscope {

/// Servo period of the control or the machine [s], the default sampling period of its recorder; 0 if neither
/// has one. For TraceColumns::machine_period.
double servo_period_of(const Setup& setup);

}  // namespace feedscope

#pragma once

#include "core/analysis/explanation/element_limits.h"
#include "core/analysis/explanation/explanation.h"

namespace feedscope {

/// Formula of a cause at an instant of filtered motion: the pulses are limited, and the filters spread them
/// over time; on settled stretches the pulse of the block counts. `limits`: of `run`.
Reason filtered_reason(const Trajectory& run, const Settings& settings, const ElementLimits& limits,
                       const State& state, Cause cause);

}  // namespace feedscope

#pragma once

#include "core/analysis/explanation/element_limits.h"
#include "core/analysis/explanation/explanation.h"

namespace feedscope {

/// The formula behind a cause at an instant of filtered motion: the pulses are limited, and the filters draw
/// them out; on settled stretches the pulse of the block counts. `limits` are those of `run`.
Reason filtered_reason(const Trajectory& run, const Settings& settings, const ElementLimits& limits,
                       const State& state, Cause cause);

}  // namespace feedscope

#pragma once

#include "core/analysis/run/run.h"

namespace feedscope {

/// Why a run stops between two blocks.
enum class StopReason : std::uint8_t {
  unknown,
  end,        ///< the program begins or ends there
  rapid,      ///< a rapid begins or ends there, and the model stops before and after each
  tolerance,  ///< an exact stop is in force, or a contour tolerance of 0
};

/// Reason at the block border nearest to `state`.
StopReason stop_reason(const Run& run, const State& state);

}  // namespace feedscope

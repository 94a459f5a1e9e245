#pragma once

#include "core/analysis/run.h"

namespace feedscope {

/// Why a run stands still between two blocks.
enum class StopReason : std::uint8_t {
  unknown,
  end,        ///< the program begins or ends there
  rapid,      ///< a rapid begins or ends there, and the model stops before and after every one
  tolerance,  ///< an exact stop is in force, or a contour tolerance of 0
};

/// At the border of blocks that lies nearest to `state`.
StopReason stop_reason(const Run& run, const State& state);

}  // namespace feedscope

#pragma once

#include "core/machine/settings.h"
#include "core/trajectory/trajectory.h"

namespace feedscope {

/// Why a run stands still between two blocks.
enum class StopReason : std::uint8_t {
  unknown,
  end,        ///< the program begins or ends there
  rapid,      ///< a rapid begins or ends there
  tolerance,  ///< an exact stop is in force, or a contour tolerance of 0
};

/// At the border of blocks that lies nearest to `state`.
StopReason stop_reason(const Trajectory& run, const Settings& settings, const State& state);

}  // namespace feedscope

#pragma once

#include "core/analysis/run/run.h"
#include "core/trace/trace.h"

namespace feedscope {

/// Reach of an axis in a trace: a start value for a search.
struct AxisReach {
  double velocity = 0;      ///< [mm/s]; 0: it does not move
  double acceleration = 0;  ///< [mm/s2]
  double jerk = 0;          ///< [mm/s3]
};

/// By axis, from differences over several samples to suppress noise. `noise` [mm].
AxisVector<AxisReach> reach_of(const Trace& trace, double noise);

}  // namespace feedscope

#pragma once

#include "core/analysis/run.h"
#include "core/trace/trace.h"

namespace feedscope {

/// What an axis reaches in a trace: as good a begin of a search as any.
struct AxisReach {
  double velocity = 0;      ///< [mm/s]; 0: it does not move
  double acceleration = 0;  ///< [mm/s2]
  double jerk = 0;          ///< [mm/s3]
};

/// By axis; from differences over several samples, so that noise does not decide. `noise` [mm].
AxisVector<AxisReach> reach_of(const Trace& trace, double noise);

}  // namespace feedscope

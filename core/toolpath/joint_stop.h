#pragma once

#include <array>

#include "core/toolpath/toolpath.h"

namespace feedscope {

/// One side of a place where two segments meet, for stop_is_faster().
struct StopSide {
  double way = 0;           ///< over which times are compared [mm]
  double top = 0;           ///< highest speed on it [mm/s]
  double acceleration = 0;  ///< along it, joints aside [mm/s2]
  double jerk = 0;          ///< [mm/s3]
  bool shaped = false;      ///< the joint's ramp holds on it, too
};

/// Whether the tip that brakes to rest at a joint and starts again takes less time over the ways of both
/// sides than one that passes at TurnJoint::limit within TurnJoint::ramp. What the slower of the two loses
/// behind them counts, too. `blend`: length of the curve in the corner, all of which is passed at that limit
/// [mm].
bool stop_is_faster(const TurnJoint& joint, const std::array<StopSide, 2>& sides, double blend);

/// Least length that a curve in the corner where a segment ends has within the contour tolerance, whatever
/// its shape: that of the program where it gives one and `follows_program`, else `tolerance`; at most a
/// quarter of the shorter segment; 0 for no corner [mm].
double least_blend(const Toolpath& path, std::size_t segment, double tolerance, bool follows_program);

}  // namespace feedscope

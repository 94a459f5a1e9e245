#pragma once

#include <array>

#include "core/toolpath/toolpath.h"

namespace feedscope {

/// One side of a joint, for stop_is_faster().
struct StopSide {
  double way = 0;           ///< length over which times are compared [mm]
  double top = 0;           ///< highest speed on it [mm/s]
  double acceleration = 0;  ///< along it, without joints [mm/s2]
  double jerk = 0;          ///< [mm/s3]
  bool shaped = false;      ///< the joint's ramp applies to it, too
};

/// True if a tip that brakes to rest at a joint and starts again takes less time over both sides than one
/// that passes at TurnJoint::limit within TurnJoint::ramp. Includes the time that the slower of the two loses
/// after them. `blend`: length of the curve in the corner, all of it passed at that limit [mm].
bool stop_is_faster(const TurnJoint& joint, const std::array<StopSide, 2>& sides, double blend);

/// Least length of any curve that blends the corner at the end of a segment within the contour tolerance
/// [mm]: the program's tolerance where it gives one and `follows_program` is set, else `tolerance`; at most a
/// quarter of the shorter segment; 0 without a corner.
double least_blend(const Toolpath& path, std::size_t segment, double tolerance, bool follows_program);

}  // namespace feedscope

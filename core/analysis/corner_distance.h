#pragma once

#include "core/base/progress.h"
#include "core/trajectory/trajectory.h"

namespace feedscope {

/// Largest distance between a programmed junction and the executed path passing it [mm]. Searched no farther
/// along the path than twice the distance from the transition between the two segments, so that another pass
/// does not count; where a control joins segments, additionally over the length of both. Covers rounded
/// corners, points that the control omits or rounds to its steps, and filtered motion. Linear in the number
/// of segments. Throws Cancelled when stopped.
double largest_corner_distance(const Trajectory& trajectory, const Progress* progress = nullptr);

}  // namespace feedscope

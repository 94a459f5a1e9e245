#pragma once

#include "core/base/progress.h"
#include "core/trajectory/trajectory.h"

namespace feedscope {

/// Largest distance between a programmed junction and the executed path passing it [mm]. The search extends
/// along the path from the transition between the two segments by at most twice the distance, so that another
/// pass does not count; where a control joins segments, by the length of both in addition. Covers rounded
/// corners, points that the control omits or rounds to its steps, and filtered motion. Linear in the number
/// of segments. Throws Cancelled when stopped.
double largest_corner_distance(const Trajectory& trajectory, const Progress* progress = nullptr);

}  // namespace feedscope

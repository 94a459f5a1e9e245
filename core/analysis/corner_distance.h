#pragma once

#include "core/base/progress.h"
#include "core/trajectory/trajectory.h"

namespace feedscope {

/// Largest distance of a point where programmed segments meet from the executed path on its way past that
/// point [mm]: no farther along it, from where one segment gives way to the next, than twice the distance, so
/// that another pass does not count; where a control joins segments, as far as both are long besides.
/// Measured: of corners that are rounded, of points that the control leaves out or rounds to its steps, and
/// of filtered motion alike. Linear in the number of segments. Throws Cancelled when stopped.
double largest_corner_distance(const Trajectory& trajectory, const Progress* progress = nullptr);

}  // namespace feedscope

#pragma once

#include <vector>

#include "core/toolpath/toolpath.h"

namespace feedscope {

/// Points at equal steps of the way along `places`: a shape without its time, so that two can be compared. A
/// place that is nearer than `least_step` to the one before is omitted as noise [mm]. Empty if nothing moves.
std::vector<Vec3> shape_of(const std::vector<Vec3>& places, double least_step);
/// Mean distance of points at the same share of both ways [mm].
double mean_distance(const std::vector<Vec3>& a, const std::vector<Vec3>& b);
Bounds bounds_of(const std::vector<Vec3>& places);

}  // namespace feedscope

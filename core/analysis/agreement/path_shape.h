#pragma once

#include <vector>

#include "core/toolpath/toolpath.h"

namespace feedscope {

/// Points at equal distances along `places`: a shape independent of time, for comparison. Steps shorter than
/// `least_step` are omitted as noise [mm]. Empty without motion.
std::vector<Vec3> shape_of(const std::vector<Vec3>& places, double least_step);
/// Mean distance of points at the same share of both lengths [mm].
double mean_distance(const std::vector<Vec3>& a, const std::vector<Vec3>& b);
Bounds bounds_of(const std::vector<Vec3>& places);

}  // namespace feedscope

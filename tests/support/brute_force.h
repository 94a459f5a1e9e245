#pragma once

#include "core/toolpath/toolpath.h"

namespace feedscope::testing {

/// Distance of `place` from the nearest point of all segments of `path`, one by one and without the code
/// under test [mm]. Closed form on lines and flat arcs; on a helix the least of many places, each narrowed
/// down.
double brute_force_distance(const Toolpath& path, const Vec3& place);

/// The same from one segment.
double brute_force_distance(const Toolpath& path, std::size_t segment, const Vec3& place);

}  // namespace feedscope::testing

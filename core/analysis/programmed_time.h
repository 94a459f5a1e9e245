#pragma once

#include <cstddef>

#include "core/toolpath/toolpath.h"

namespace feedscope {

/// What segment `index` takes at its programmed feed: length over feed; at the speed at which the first axis
/// reaches `rapid_speed` [mm/s] for rapids and what has no feed; the time of a dwell that has one [s].
double programmed_time(const Toolpath& toolpath, std::size_t index, const Vec3& rapid_speed);
/// Of all segments [s].
double programmed_time(const Toolpath& toolpath, const Vec3& rapid_speed);

}  // namespace feedscope

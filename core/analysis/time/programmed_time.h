#pragma once

#include <cstddef>

#include "core/toolpath/toolpath.h"

namespace feedscope {

/// Time of segment `index` at its programmed feed [s]: length over feed. Rapids and motions without a feed
/// use the speed at which the first axis reaches `rapid_speed` [mm/s]; a dwell has its own time, if any.
double programmed_time(const Toolpath& toolpath, std::size_t index, const Vec3& rapid_speed);
/// Time of all segments [s].
double programmed_time(const Toolpath& toolpath, const Vec3& rapid_speed);

}  // namespace feedscope

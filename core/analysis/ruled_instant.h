#pragma once

#include "core/analysis/slow_places.h"

namespace feedscope {

/// An instant of `place` that its cause rules: what is said of the place must be explained there, and not
/// where the tool is slowest, which may have another cause. Of several the slowest; where the tool does
/// nothing in the place but slow down for what the cause rules, one at which it does that [s]. Linear in the
/// pieces of the place.
double ruled_instant(const Trajectory& trajectory, const SlowPlace& place);

}  // namespace feedscope

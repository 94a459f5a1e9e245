#pragma once

#include "core/analysis/time/slow_places.h"

namespace feedscope {

/// Time within `place` at which its limiting cause is active [s]. The slowest instant may have a different
/// cause, so explanations use this one. Of several the slowest; if the tool only slows down for that cause in
/// the place, a time at which it does. Linear in the pieces of the place.
double ruled_instant(const Trajectory& trajectory, const SlowPlace& place);

}  // namespace feedscope

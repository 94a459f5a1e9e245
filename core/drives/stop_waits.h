#pragma once

#include <memory>

#include "core/machine/machine.h"
#include "core/trajectory/trajectory.h"

namespace feedscope {

/// `motion` with waits at its exact stops: where a block ends in exact stop mode (G9, G60 with G601 or G602,
/// G61; not with G603), before every pause and at the end, the set positions stand until every motor is
/// within `window` [mm] of its own. A first-order drive (no velocity_lag_ms) that is e behind when they come
/// to rest takes ln(e/window)/kv; others until they are within it for the first time. Axes without drive are
/// where they should be. Throws Cancelled, and InputError as AxisDrives.
Trajectory with_stop_waits(Trajectory motion, const Machine& machine, double window,
                           const Progress* progress = nullptr);

}  // namespace feedscope

#pragma once

#include <memory>

#include "core/machine/machine.h"
#include "core/trajectory/trajectory.h"

namespace feedscope {

/// Adds waits at exact stops to `motion`: after blocks in exact stop mode (G9, G60 with G601 or G602, G61;
/// not with G603), before every pause and at the end the set positions rest until every motor is within
/// `window` [mm] of its own. A first-order drive (no velocity_lag_ms) with a following error e takes
/// ln(e/window)/kv. Axes without a drive follow exactly. Throws Cancelled, and InputError as AxisDrives does.
Trajectory with_stop_waits(Trajectory motion, const Machine& machine, double window,
                           const Progress* progress = nullptr);

}  // namespace feedscope

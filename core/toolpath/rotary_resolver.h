#pragma once

#include <memory>

#include "core/base/progress.h"
#include "core/machine/machine.h"
#include "core/toolpath/toolpath.h"

namespace feedscope {

/// The same path with what its Toolpath::rotary_moves come to on a machine with rotary axes: pauses of
/// Pause::indexing, each as long as its slowest axis turns (turning_time()), and the angles in
/// Toolpath::rotary_turns; of Pause::swing where X, Y and Z hold the tip in it (TipSwing). Where they go to
/// is that of RotaryPositions.
///
/// Beside a feed motion or a rapid the axes go along it (TurnCourse), and Toolpath::segment_turns holds what
/// its axes allow: the rotary ones, and where X, Y and Z are those of the tip, the tool length and part_zero
/// of `settings` are known, all axes; Toolpath::turn_joints the same of the places where segments meet
/// (TurnLimiter; MODELS.md, section 14).
///
/// What cannot be is in Toolpath::machine_faults.
/// Returns `path` itself where the machine has no rotary axes or the program moves none. Throws Cancelled
/// when stopped; `progress` may be null.
std::shared_ptr<const Toolpath> with_rotary_moves(std::shared_ptr<const Toolpath> path,
                                                  const Machine& machine, const Settings& settings,
                                                  const Progress* progress);

}  // namespace feedscope

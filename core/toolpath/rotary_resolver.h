#pragma once

#include <memory>

#include "core/base/progress.h"
#include "core/machine/machine.h"
#include "core/toolpath/machine_path.h"

namespace feedscope {

/// The same path with its Toolpath::rotary_moves as a machine with rotary axes runs them: pauses of
/// Pause::indexing, each as long as its slowest axis turns (turning_time()), with the angles in
/// Toolpath::rotary_turns; pauses of Pause::swing where X, Y and Z keep the tip in place meanwhile
/// (TipSwing). RotaryPositions gives the end positions.
///
/// During a feed motion or a rapid the axes turn along it (TurnCourse). Toolpath::segment_turns then contains
/// the limits of the axes: of the rotary ones, and of all axes where X, Y and Z are those of the tip and
/// `settings` give tool length and part_zero. Toolpath::turn_joints contains the same for the joints of
/// segments (TurnLimiter; MODELS.md, section 14).
///
/// Impossible moves are reported in MachinePath::faults. The toolpath is `path` itself where the machine has
/// no rotary axes or the program moves none. Throws Cancelled when stopped; `progress` may be null.
MachinePath with_rotary_moves(std::shared_ptr<const Toolpath> path, const Machine& machine,
                              const Settings& settings, const Progress* progress);

}  // namespace feedscope

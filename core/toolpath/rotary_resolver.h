#pragma once

#include <memory>

#include "core/machine/machine.h"
#include "core/toolpath/toolpath.h"

namespace feedscope {

/// The same path with what its Toolpath::rotary_moves come to on a machine with rotary axes: pauses of
/// Pause::indexing, each as long as its slowest axis turns (turning_time()), and the angles in
/// Toolpath::rotary_turns. Beside a rapid only what the turn lasts longer than the rapid from rest to rest at
/// the limits of X, Y and Z, after it. All axes start at zero; a direction takes the angles that
/// KinematicChain::turn_to() gives, those with the sign that is asked for, else the nearest. Tool vectors
/// beside feed motions take the nearer of two positions; what is unclear of them is noted. Tool and part
/// stand still meanwhile: how the linear axes follow a turn is not part of it.
///
/// Beside a feed motion the angles go linearly along it, and Toolpath::segment_turns holds what its axes
/// allow: the rotary ones, and where X, Y and Z are those of the tip, the tool length and part_zero of
/// `settings` are known, all axes by the derivatives of the chain at five places of a segment
/// (KinematicChain::courses(); MODELS.md, section 14). Where segments meet, the velocity of a rotary axis may
/// jump: no limit holds there.
///
/// What cannot be is in Toolpath::machine_faults: a direction out of reach (the axes stay), a place beyond
/// travel (its time is that of the way to it).
/// Returns `path` itself where the machine has no rotary axes or the program moves none.
std::shared_ptr<const Toolpath> with_rotary_moves(std::shared_ptr<const Toolpath> path,
                                                  const Machine& machine, const Settings& settings);

}  // namespace feedscope

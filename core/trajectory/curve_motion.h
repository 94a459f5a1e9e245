#pragma once

#include <functional>

#include "core/trajectory/stretch.h"

namespace feedscope {

/// Looks at the motion that `builder` has laid from `start` on along the elements of `stretch`: where an axis
/// exceeds its acceleration or jerk on a span of a smooth curve (curve_limits() bounds the terms of both one
/// by one), the ceiling of that span is lowered by what the excess says, so that another plan keeps them.
/// Looked at at the ends and in the middle of every part of constant jerk. Returns whether any was lowered.
bool lower_curve_ceilings(const TrajectoryBuilder& builder, const TrajectoryBuilder::Mark& start,
                          Stretch& stretch, const AxisVectors& axes);

/// Plans and moves over a stretch with `plan_and_move`, again with lower ceilings while axes exceed their
/// limits on its curves, four times at most: contract tests find no more than 5 % of an acceleration and 10 %
/// of a jerk left.
void move_over_curves(TrajectoryBuilder& builder, Stretch& stretch, const AxisVectors& axes,
                      const std::function<void()>& plan_and_move);

}  // namespace feedscope

#pragma once

#include <functional>

#include "core/trajectory/stretch.h"

namespace feedscope {

/// Checks the motion that `builder` has laid from `start` on along the elements of `stretch`. Where an axis
/// exceeds its acceleration or jerk on a span of a smooth curve (curve_limits() bounds the terms of both
/// separately), it lowers the ceiling of that span in proportion to the excess, so that another plan keeps
/// the limits. Checks the ends and the middle of every part of constant jerk. Returns true if it lowered any.
bool lower_curve_ceilings(const TrajectoryBuilder& builder, const TrajectoryBuilder::Mark& start,
                          Stretch& stretch, const AxisVectors& axes);

/// Plans and lays the motion of a stretch with `plan_and_move`, again with lower ceilings while axes exceed
/// their limits on its curves, four times at most: in contract tests at most 5 % of an acceleration and 10 %
/// of a jerk remain.
void move_over_curves(TrajectoryBuilder& builder, Stretch& stretch, const AxisVectors& axes,
                      const std::function<void()>& plan_and_move);

}  // namespace feedscope

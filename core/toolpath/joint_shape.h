#pragma once

#include "core/kinematics/series.h"
#include "core/toolpath/toolpath.h"

namespace feedscope {

/// Longest reach of a joint to one side, as a multiple of the reach to the other. Longer ones would bend the
/// shorter side more.
inline constexpr double largest_reach_ratio = 2;

/// Deviation of an angle from its programmed course at `away` along the path [mm] from a place where its
/// slope grows by 1, with derivatives by the path. `away` is negative before the place, -0.0 included.
/// `before`, `behind`: reach of the joint to both sides, above 0 [mm].
///
/// With t from 0 to 1 towards the place on either side, the deviation is a t^3 + b t^4 before it and
/// c t^3 - b t^4 after it: value, slope and second derivative of the angle are continuous, also at the ends
/// of the reach. For equal reaches b = 0, and over even blocks joints add up to the cubic B-spline whose
/// control points are the programmed angles. Within a reach the third derivative is linear and largest at an
/// end.
Series joint_shape(double before, double behind, double away);

/// Deviation of axis `axis`, 0 to 2 for A, B and C, at a joint [rad]; zero for a joint without reach.
Series joint_turn(const TurnJoint& joint, std::size_t axis, double away);

/// Least reach into a segment of `length` with which a joint shapes most of its course [mm].
inline double least_shaping_reach(double length) {
  return 0.45 * length;  // below one half, because rounding may leave a little less of a reach of one half
}
inline bool shapes_segment(double reach, double length) {
  return reach >= least_shaping_reach(length);
}

}  // namespace feedscope

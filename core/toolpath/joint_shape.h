#pragma once

#include "core/kinematics/series.h"
#include "core/toolpath/toolpath.h"

namespace feedscope {

/// Longest reach of a joint to one side, in those to the other: longer ones would bend the shorter side more.
inline constexpr double largest_reach_ratio = 2;

/// How far an angle is from its programmed course at `away` from a place where its slope grows by 1, along
/// the path [mm], negative (-0.0 too) before it; with its derivatives by the path. `before`, `behind`: how
/// far the joint reaches to both sides, above 0 [mm].
///
/// With t from 0 to 1 towards the place on either side it is a t^3 + b t^4 before it and c t^3 - b t^4
/// behind: value, slope and second derivative of the angle are continuous, also at the ends of the reach.
/// Where it reaches equally far b = 0, and over even blocks joints add up to the cubic B-spline whose control
/// points are the programmed angles. In the reach of any the third derivative is linear, its largest value at
/// an end.
Series joint_shape(double before, double behind, double away);

/// The same of axis `axis`, 0 to 2 for A, B and C, at a joint; nothing for one that reaches nowhere [rad].
Series joint_turn(const TurnJoint& joint, std::size_t axis, double away);

/// From which reach into a segment of `length` on a joint shapes most of its course [mm].
inline double least_shaping_reach(double length) {
  return 0.45 * length;  // less than a half: that is what rounding leaves of a reach of a half
}
inline bool shapes_segment(double reach, double length) {
  return reach >= least_shaping_reach(length);
}

}  // namespace feedscope

#pragma once

#include "core/toolpath/curve.h"

namespace feedscope {

/// Closed forms of an isolated corner (Ward 2021, section 3; README.md in this folder with print corrected:
/// eq 29 and 30 need cos(theta) + 1 with theta the interior angle and the other sign for eps; eq 30, 40, 41
/// and 42 have the width of n = 2 in the formula of n = 3; eq 38 and 39 are right up to a = 2/3 only).
///
/// Symbols: n filters of length T1, F feed, a = V_c/F blending factor, V_c height of the blending pulse,
/// T_b = (n T1/2)(1 - a) its width on each side, phi direction change.

/// l/(F T1): mean distance l of the pulses from the corner, weighted by the filters, when these are centred
/// on it; the corner error is eps = 2 l sin(phi/2). `a` in [0, 1].
double corner_distance(int filters, double a);

/// v'/F: speed along each of the two legs at the same time; the corner speed is 2 cos(phi/2) v'.
double corner_speed_share(int filters, double a);

/// A corner between two straight blocks.
struct CornerLegs {
  double feed_before = 0;  ///< > 0 [mm/s]
  double feed_after = 0;   ///< > 0 [mm/s]
  double turn = 0;         ///< phi [rad]
};
/// Highest speed V_c [mm/s] of the blending pulses, at most the lower feed, at which an isolated corner keeps
/// `tolerance` [mm]: (l_before + l_after) sin(phi/2) = tolerance, or the lower feed if that keeps it. For
/// equal feeds this is eps = tolerance; for unequal ones the distance across the bisector, equal to the
/// closest approach as long as the path there follows the bisector.
double corner_speed(int filters, double filter_time, const CornerLegs& legs, double tolerance);

/// Gain of n moving averages over T1 for exp(i w t): sinc^n(x), x = w T1/2.
double turn_gain(int filters, double x);

/// Highest speed [mm/s] on a long arc or helix at which the path, which n moving averages shrink to
/// sinc^n(w T1/2) of the radius R, w the angular speed, stays within `tolerance` [mm] of it; infinite where
/// the tolerance is not below R.
double arc_speed(int filters, double filter_time, const Arc& arc, double tolerance);

}  // namespace feedscope

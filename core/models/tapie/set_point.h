#pragma once

#include "core/limits/segment_limits.h"

namespace feedscope {

/// Limits of the axes at constant speed at the place of an arc where the steady feed is reached.
struct SteadyPlace {
  double angle = 0;         ///< a_c, from the arc's start [rad]
  double control_jerk = 0;  ///< V_Jtcurv: curvilinear jerk of the control settings [mm/s]
  AxisBound jerk;           ///< V_Jt(a_c) [mm/s]
  AxisBound acceleration;   ///< V_An(a_c) [mm/s]
  AxisBound velocity;       ///< V_t(a_c) [mm/s]
};

/// a_c (Tapie 2007, fig. 12 and section 5.2.4; README.md in this folder): the first angle of the arc at
/// which the axes, at constant speed, allow just the feed of the control settings, V_Jt(a_c) = V_Jtcurv,
/// which in the XY plane is J_t(a_c) = J_curv r_jct; if the arc has none, the angle at which V_Jt is
/// largest. `control_jerk`: J_curv r_jct [mm/s3].
///
/// Any plane, helices: the jerk at constant speed is v^3 times the third derivative of the position by path
/// length; its part on every axis is a cosine of the angle, so that a_c is found in closed form.
SteadyPlace steady_place(const Arc& arc, const AxisVectors& axes, double control_jerk);

/// Set point V_st of the lines and arcs of a path (eq 6 and 12): arcs min(V_prog, V_Jtcurv, V_Jt(a_c),
/// V_An(a_c), V_t(a_c), V_tcy), lines min(V_prog, V_t, V_tcy), V_tcy = length / t_cy. Beyond the paper every
/// axis stays within its velocity on the whole arc, not only at a_c: a drive cannot exceed it.
struct SetPointRule {
  AxisVectors axes;
  double control_jerk;  ///< J_curv r_jct [mm/s3]
  double period;        ///< t_cy [s]

  /// Limits of segment `i`, with the set point as speed. `part`: as in segment_limits().
  MotionLimits limits(const Toolpath& toolpath, std::size_t i, const TurnPart* part = nullptr) const;
};

}  // namespace feedscope

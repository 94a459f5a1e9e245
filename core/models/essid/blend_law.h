#pragma once

#include <vector>

#include "core/blend/corner.h"
#include "core/limits/segment_limits.h"

namespace feedscope {

/// Limits on a corner blend (Essid 2019, eq 14, 15, 24): shares of an axis for radial and tangential motion.
struct BlendLimits {
  Vec3 velocity;                 ///< V [mm/s]
  Vec3 tangential_acceleration;  ///< (1 - R_A) A [mm/s2]
  Vec3 radial_acceleration;      ///< R_A A [mm/s2]
  Vec3 tangential_jerk;          ///< (1 - R_J) Jtb [mm/s3]
  Vec3 radial_jerk;              ///< R_J Jtb [mm/s3]

  BlendLimits(const AxisVectors& axes, double radial_acceleration_share, double radial_jerk_share);
};

/// Vin_L: highest speed at which a blend may be entered without acceleration, and what sets it.
/// min over axes of F, V/|T|, sqrt(R_A A / (k |N|)), cbrt(R_J Jtb / (|dk/ds| |N|)) at u = 0.
/// Eq 26 in print lacks |T| and the cube root. It looks at u = 0 only: further on the radial jerk of eq 24
/// exceeds its share by a factor of about 1.3 to 1.7.
SpeedBound entry_speed_limit(const BlendShape::Point& entry, const SpeedBound& feed,
                             const BlendLimits& limits);

/// Least tangential acceleration and jerk that the axes allow anywhere on the blend [mm/s2, mm/s3].
MotionLimits blend_motion_limits(const BlendShape& shape, const SpeedBound& speed, const BlendLimits& limits);

/// One sampling interval on a blend: constant parametric jerk.
struct BlendStep {
  double duration = 0;  ///< [s]
  double u = 0;
  double du = 0;    ///< du/dt [1/s]
  double ddu = 0;   ///< [1/s2]
  double dddu = 0;  ///< [1/s3]
  Cause cause;
};

/// Motion over a whole blend.
struct BlendMotion {
  std::vector<BlendStep> steps;
  double exit_speed = 0;         ///< [mm/s]
  double exit_acceleration = 0;  ///< along the path [mm/s2]
  bool complete = false;         ///< false: the tool would stall on the blend
};

/// Largest parametric jerk of every sample that keeps eq 24 (Essid 2019, eq 16, 28-30 and the algorithm),
/// corrected: the jerk is taken from the whole signed interval [(-j_t - c)/sigma, (j_t - c)/sigma], the speed
/// keeps v + v'^2/(2 j_t) <= ceiling so that it can be levelled off in time, and where no value keeps every
/// row, the one with the least excess is taken.
/// `speed`, `acceleration`: along the path at the entry; `ceiling`: of the whole blend [mm/s];
/// `period`: sampling time t_s [s].
BlendMotion run_blend(const BlendShape& shape, double speed, double acceleration, const SpeedBound& ceiling,
                      const BlendLimits& limits, double period);

/// Reading "strict": the highest constant du/dt that keeps every row of eq 24 on the whole blend.
struct SteadyBlend {
  double du = 0;     ///< du/dt [1/s]
  double speed = 0;  ///< at both ends [mm/s]
  Cause cause;
};
SteadyBlend steady_blend(const BlendShape& shape, const SpeedBound& feed, const BlendLimits& limits);

}  // namespace feedscope

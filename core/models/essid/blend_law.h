#pragma once

#include <vector>

#include "core/blend/corner.h"
#include "core/limits/segment_limits.h"
#include "core/trajectory/blend_chains.h"

namespace feedscope {

/// One value per axis for each row of eq 24 of Essid 2019.
struct BlendRows {
  Vec3 velocity;
  Vec3 tangential_acceleration;
  Vec3 radial_acceleration;
  Vec3 tangential_jerk;
  Vec3 radial_jerk;
};

/// Limits on a corner blend (Essid 2019, eq 14, 15, 24): shares of an axis for radial and tangential motion,
/// V, (1 - R_A) A, R_A A, (1 - R_J) Jtb, R_J Jtb [mm/s, mm/s2, mm/s3].
struct BlendLimits : BlendRows {
  BlendRows inverse;                 ///< 1 / limit
  double least_velocity;             ///< of the axes
  double least_radial_acceleration;  ///< likewise

  BlendLimits(const AxisVectors& axes, double radial_acceleration_share, double radial_jerk_share);
};

/// Direction change [rad] above which the entry limit at u = 0 does not cover the middle of the blend, where
/// the curvature has its maximum: the radial jerk of run_blend there exceeds its share by 1.6 at 120 degrees,
/// by 45 at 135 and by 1500 at 150.
inline constexpr double sharp_turn = 2.0;

/// Vin_L: highest entry speed of a blend without acceleration, and its cause. min over axes of F, V/|T|,
/// sqrt(R_A A / (k |N|)), cbrt(R_J Jtb / (|dk/ds| |N|)) at u = 0. Eq 26 in print lacks |T| and the cube root.
/// It covers only u = 0: further on the radial jerk of eq 24 exceeds its share by a factor of about 1.3
/// to 1.7.
SpeedBound entry_speed_limit(const BlendShape::Point& entry, const SpeedBound& feed,
                             const BlendLimits& limits);

/// Least tangential acceleration and jerk that the axes allow anywhere on the blend [mm/s2, mm/s3], and
/// `speed`, lowered where rows (0)-(3) of eq 24 require it further on: eq 26 covers only the entry, where the
/// curvature is lower than in the middle and another axis may limit. `feed`: programmed [mm/s].
MotionLimits blend_motion_limits(const BlendShape& shape, const SpeedBound& speed, double feed,
                                 const BlendLimits& limits);

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
  double peak_speed = 0;         ///< largest at the samples and midway between them [mm/s]
  double peak_axis_use = 0;      ///< largest share of an axis velocity at the same places
  double exit_acceleration = 0;  ///< along the path [mm/s2]
  bool complete = false;         ///< false: the tool would stall on the blend, or be too fast
};

/// Largest parametric jerk of every sample that keeps eq 24 (Essid 2019, eq 16, 28-30 and the algorithm),
/// corrected: the jerk is from the whole signed interval [(-j_t - c)/sigma, (j_t - c)/sigma]; the speed keeps
/// v + v'^2/(2 j_t) <= ceiling so that it can be levelled off in time; where no value keeps every row, the
/// one with the least excess is used. `speed`: at the entry, without acceleration along the path (eq 25)
/// [mm/s]; `ceiling`: of the whole blend [mm/s]; `period`: sampling time t_s [s]. Stops, incomplete, where
/// the motion exceeds `fastest` [mm/s] or the velocity of an axis by more than sampled_slack.
BlendMotion run_blend(const BlendShape& shape, double speed, const SpeedBound& ceiling,
                      const BlendLimits& limits, double period, double fastest);

/// Factor by which a speed between samples may exceed its ceiling, because the rows of eq 24 are kept at
/// samples only.
inline constexpr double sampled_slack = 1.005;

/// Speed at both ends of a blend run at constant du/dt: the highest that keeps every row of eq 24 on the
/// whole blend (reading "strict").
SpeedBound steady_speed_limit(const BlendShape& shape, const SpeedBound& feed, const BlendLimits& limits);

/// Ramps over a blend run by its parameter, as in chains of blends with reading "strict": every row of eq 24
/// is kept while w = |S'(0)| du/dt, the speed at both ends of the blend, stays below the speed of a step and
/// changes by no more than its acceleration and jerk. With g = |S'(u)| / |S'(0)| and its derivatives by x =
/// |S'(0)| u: v = g w, v' = g w' + g_x w^2, v'' = g w'' + 3 g_x w w' + g_xx w^3, put into rows (2), (4) and
/// (5) with the worst signs.
BlendRamps parameter_ramps(const BlendShape& shape, const BlendLimits& limits);

/// True if a whole blend at constant `speed` [mm/s] keeps every row of eq 24.
bool keeps_rows_at(const BlendShape& shape, double speed, const BlendLimits& limits);

}  // namespace feedscope

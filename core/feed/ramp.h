#pragma once

#include <array>
#include <cstddef>

namespace feedscope {

/// Limits along the path.
struct RampLimits {
  double acceleration;  ///< > 0 [mm/s2]
  double jerk;          ///< > 0 [mm/s3]
};

/// A stretch of constant jerk.
struct Phase {
  double duration = 0;  ///< [s]
  double jerk = 0;      ///< [mm/s3]
};

/// Speed and acceleration along the path at one instant, and the length covered.
struct Motion1d {
  double s = 0;  ///< [mm]
  double v = 0;  ///< [mm/s]
  double a = 0;  ///< [mm/s2]
};

/// State after `time` [s] of constant `jerk`.
Motion1d advance(const Motion1d& from, double jerk, double time);

/// The fastest jerk-limited change of speed between standstills of acceleration (core/models/README.md):
/// time 2 sqrt(|v1-v0|/J), or |v1-v0|/A + A/J once the acceleration limit is reached;
/// length (v0+v1)/2 times that time.
double ramp_time(double v0, double v1, const RampLimits& limits);
double ramp_length(double v0, double v1, const RampLimits& limits);

/// Highest speed that a ramp from `v0` reaches within `length` [mm/s]; also the highest speed from which `v0`
/// is reached, the ramp being its own mirror image. Exact to rounding.
double reachable_speed(double v0, double length, const RampLimits& limits);

/// Phases that bring (v, a) to (target, 0) fastest: jerk, constant acceleration, opposite jerk.
/// An |a| above the acceleration limit is left as soon as the jerk allows.
///
///     a ^     ___
///       |    /   \            first jerk J, then a = A, then jerk -J
///       |   /     \___ t
std::array<Phase, 3> speed_change(double v, double a, double target, const RampLimits& limits);

/// Time law over one stretch of path: (v0, a0) -> peak -> (v1, 0), at most seven phases.
struct SpeedProfile {
  /// The phase at the peak, without acceleration: what rounding leaves of it would count with the square of
  /// its duration.
  static constexpr std::size_t held = 3;

  std::array<Phase, 7> phases;
  double v0 = 0;    ///< [mm/s]
  double a0 = 0;    ///< [mm/s2]
  double peak = 0;  ///< speed between the two ramps [mm/s]
  bool feasible =
      true;  ///< false: v1 cannot be reached within the length; the profile brakes as hard as it may

  double duration() const;
  double length() const;
};

/// The profile of highest peak, at most `ceiling`, that covers `length` exactly and ends at (v1, 0)
/// (the seven-phase law on a line of Essid 2019 and Dong 2014). Its length is exact: where rounding leaves up
/// to 1e-6 of it, all speeds are changed by that share. Not feasible if even braking at once is too long, if
/// v1 lies beyond what the length allows to reach, or if `a0` is so low that the speed would fall below 0.
SpeedProfile plan_profile(double v0, double a0, double v1, double length, double ceiling,
                          const RampLimits& limits);

/// The peak of plan_profile() from (v0, 0), and how long that takes, to rounding: at half of the cost.
/// Without any acceleration that takes for ever, unless the speed stays.
double profile_peak(double v0, double v1, double length, double ceiling, const RampLimits& limits);
double profile_time(double v0, double v1, double length, double ceiling, const RampLimits& limits);

}  // namespace feedscope

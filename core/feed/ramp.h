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

/// Fastest jerk-limited change of speed from zero acceleration to zero (core/models/README.md): time 2
/// sqrt(|v1-v0|/J), or |v1-v0|/A + A/J once the acceleration limit is reached; length (v0+v1)/2 times that
/// time.
double ramp_time(double v0, double v1, const RampLimits& limits);
double ramp_length(double v0, double v1, const RampLimits& limits);

/// Largest speed that a ramp from `v0` reaches within `length` [mm/s]; also the largest speed from which `v0`
/// is reached, since the ramp is symmetric. Exact up to rounding.
double reachable_speed(double v0, double length, const RampLimits& limits);

/// Fastest phases from (v, a) to (target, 0): jerk, constant acceleration, opposite jerk. An |a| above the
/// acceleration limit is reduced as fast as the jerk allows.
///
///     a ^     ___
///       |    /   \            first jerk J, then a = A, then jerk -J
///       |   /     \___ t
std::array<Phase, 3> speed_change(double v, double a, double target, const RampLimits& limits);

/// Time law over one stretch of path: (v0, a0) -> peak -> (v1, 0), at most seven phases.
struct SpeedProfile {
  /// Phase at the peak, without acceleration: a rounding error in it would grow with the square of its
  /// duration.
  static constexpr std::size_t held = 3;

  std::array<Phase, 7> phases;
  double v0 = 0;    ///< [mm/s]
  double a0 = 0;    ///< [mm/s2]
  double peak = 0;  ///< speed between the two ramps [mm/s]
  bool feasible =
      true;  ///< false: v1 is not reachable within the length; the profile brakes as hard as possible

  double duration() const;
  double length() const;
};

/// Profile with the largest peak, at most `ceiling`, that covers `length` exactly and ends at (v1, 0) (the
/// seven-phase law on a line of Essid 2019 and Dong 2014). Its length is exact: rounding errors up to 1e-6 of
/// it are removed by scaling all speeds. Not feasible if even immediate braking is too long, if v1 is not
/// reachable within the length, or if `a0` is so low that the speed would become negative.
SpeedProfile plan_profile(double v0, double a0, double v1, double length, double ceiling,
                          const RampLimits& limits);

/// Peak of plan_profile() from (v0, 0), and its duration, up to rounding, at half of the cost. Without any
/// acceleration the duration is infinite, unless the speed is constant.
double profile_peak(double v0, double v1, double length, double ceiling, const RampLimits& limits);
double profile_time(double v0, double v1, double length, double ceiling, const RampLimits& limits);

}  // namespace feedscope

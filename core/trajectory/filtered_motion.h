#pragma once

#include <vector>

#include "core/trajectory/kinematics.h"

namespace feedscope {

/// A stretch of constant commanded velocity; it lasts until the next begins.
struct Pulse {
  double time = 0;  ///< start, from the start of the motion [s]
  Vec3 velocity;    ///< [mm/s]
  Vec3 position;    ///< commanded, at the start [mm]
};

/// Velocity pulses smoothed by `filters` equal moving averages of length `filter_time`, from standstill to
/// standstill (Ward 2021, eq 1-7; MODELS section 5):
///
///   p'(t) = sum_j dv_j T1 S_(n,n+1)((t - t_j)/T1),   velocity S_(n,n), acceleration S_(n,n-1)/T1,
///   S_(n,m)(u) = (1/m!) sum_i (-1)^i C(n,i) (u - i)_+^m       jerk S_(n,n-2)/T1^2
///
/// dv_j the velocity steps at the pulses' starts t_j. Every axis is a polynomial of degree n + 1 between
/// neighbouring t_j + i T1; the pulses are kept rather than these polynomials, of which there are n + 1 times
/// as many. Only the pulses of the last n T1 count: the cost of one evaluation is linear in their number.
class FilteredMotion {
 public:
  /// `filters` 2 or 3; `filter_time` > 0 [s]; `start` on the clock of the trajectory [s]; at least two
  /// `pulses` in order of time, the last at rest.
  FilteredMotion(int filters, double filter_time, double start, std::vector<Pulse> pulses);

  double start() const { return start_; }                           ///< [s]
  double filter_time() const { return filter_time_; }               ///< T1 [s]
  double delay() const { return delay_; }                           ///< n T1 [s]
  double duration() const { return pulses_.back().time + delay_; }  ///< [s]
  const std::vector<Pulse>& pulses() const { return pulses_; }

  /// At `t` from the start [s].
  Kinematics at(double t) const;
  Vec3 velocity(double t) const;
  /// Path length from `t0` to `t1` [mm]: exact where the velocity is constant, else by Gauss-Legendre
  /// quadrature, halved until two halves agree with the whole to 1e-9
  /// of what the largest speed covers.
  double length(double t0, double t1) const;
  /// First time in [t0, t1] at which `length` [mm] from t0 is covered.
  double time_at_length(double t0, double t1, double length) const;
  /// Whether one pulse fills the filters all the time from `t0` to `t1`: the velocity is constant.
  bool is_settled(double t0, double t1) const;

 private:
  std::size_t pulse_after(double t) const;  ///< first that begins after `t`
  double quadrature(double t0, double t1) const;
  double refined(double t0, double t1, double whole, double tolerance, int depth) const;

  int filters_;
  double filter_time_;
  double delay_;
  double start_;
  double largest_speed_ = 0;  ///< of the pulses [mm/s]
  std::vector<Pulse> pulses_;
};

}  // namespace feedscope

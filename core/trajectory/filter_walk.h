#pragma once

#include <array>
#include <vector>

#include "core/trajectory/kinematics.h"
#include "core/trajectory/pulse_train.h"

namespace feedscope {

/// Evaluates smoothed pulses at many times. With n filters of length T1, P_0 the commanded position and
/// P_m its m-fold integral,
///
///   p'(t) = T1^-n sum_i (-1)^i C(n,i) P_n(t - i T1),   velocity from P_(n-1), acceleration P_(n-2), jerk
///   P_(n-3)
///
/// which is the sum of models/ward/README.md over the steps of the pulses. It is valid for turning pulses,
/// too: their integrals are those of exp(i w t), by a series where w t is small. The integrals start at an
/// anchor a little more than one delay back and are kept at the start of every pulse after it: for times in
/// order the amortised cost is constant whatever the number of pulses within the delay. A new anchor every
/// few delays starts from nothing, so that rounding does not build up; a distant time costs the pulses of a
/// delay.
class FilterWalk {
 public:
  /// Bound of the rounding error of a velocity as a share of the largest commanded one; for an acceleration
  /// times T1. 2^n terms of up to (4 n)^n/n!, n = 3, each with a few roundings.
  static constexpr double velocity_rounding = 1e-12;

  /// Smoothed motion at `t` from its start [s].
  Kinematics at(const PulseTrain& train, double t);
  /// The same without the jerk; velocity_at() also without the position, for callers that need no more at
  /// many times.
  Kinematics motion_at(const PulseTrain& train, double t);
  VelocityPoint velocity_at(const PulseTrain& train, double t);
  /// First time after `t` [s] at which a pulse begins to count, or one of its averages to begin or end.
  /// Between two such times the motion of straight pulses is one polynomial.
  double next_knot(const PulseTrain& train, double t);
  /// True if one pulse fills the filters at the last time queried. Straight or on an arc, the speed is
  /// constant until the next knot.
  bool is_settled() const { return cursor_[0] == cursor_[static_cast<std::size_t>(train_->filters)]; }
  /// True if all pulses in the filters were straight then: the motion is a polynomial up to the next knot.
  bool is_polynomial() const;
  /// Motion at `t` if the pulses in the filters stay those of the last time queried: same as at() up to the
  /// next knot.
  Kinematics continued(double t) const;
  /// The same as position and derivatives by time up to the fourth; straight pulses have no higher ones.
  using Derivatives = std::array<Vec3, 5>;
  Derivatives continued_derivatives(double t) const;
  /// If is_settled(): output of the filters up to the next knot.
  CommandPart settled_part() const;
  /// Bound of the `order`-th derivative of the position up to the next knot, if not is_polynomial(); `order`
  /// above the number of filters [mm/s^order].
  double derivative_bound(int order) const;
  /// Forgets the cached state of a train whose pulses were changed.
  void forget() { train_ = nullptr; }

 private:
  static constexpr int max_filters = 3;
  /// A part with the integrals P_0 (as distance from the anchor) ... P_n at its start.
  struct Knot {
    CommandPart part;
    double start = 0;  ///< after the anchor, free of the rounding of late times [s]
    std::array<Vec3, max_filters + 1> integrals;
  };
  template <int filters, int highest, int lowest>
  std::array<Vec3, highest - lowest + 1> differences(double t) const;
  template <int filters>
  Kinematics evaluate(double t, bool with_jerk) const;
  template <int filters>
  VelocityPoint evaluate_velocity(double t) const;
  void seek(const PulseTrain& train, double t);
  void restart(double anchor_time);
  void append_block();
  void append(const CommandPart& part);
  void find_known();

  const PulseTrain* train_ = nullptr;
  double anchor_time_ = 0;  ///< [s]
  Vec3 anchor_;             ///< commanded there [mm]
  std::vector<Knot> knots_;
  double known_until_ = 0;                             ///< start of the first pulse without a knot [s]
  std::size_t next_block_ = 0;                         ///< block of that pulse
  std::array<std::size_t, max_filters + 1> cursor_{};  ///< knot at t - i T1
};

}  // namespace feedscope

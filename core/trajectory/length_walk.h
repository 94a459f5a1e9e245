#pragma once

#include <array>

#include "core/trajectory/filter_walk.h"

namespace feedscope {

/// Speed and its derivative at one time.
struct SpeedSample {
  double time = 0;   ///< [s]
  double speed = 0;  ///< [mm/s]
  double slope = 0;  ///< [mm/s2]
};

/// Path length over a short time: the integral of the polynomial of degree four through the speed at both
/// ends and in the middle, with the slopes at both ends. Never decreases.
class LengthStep {
 public:
  LengthStep(const SpeedSample& from, const SpeedSample& middle, const SpeedSample& to);
  /// `length` [mm] at one speed.
  LengthStep(double start, double duration, double length);

  double start() const { return start_; }            ///< [s]
  double end() const { return start_ + duration_; }  ///< [s]
  double length() const { return length_; }          ///< [mm]
  double covered(double t) const;                    ///< at `t` within the step [mm]
  double time_at(double covered) const;              ///< first time, the inverse [s]

 private:
  double start_;
  double duration_;
  double length_;
  std::array<double, 5> coefficients_;  ///< of the speed by the share of the duration [mm/s]
};

/// Path length of smoothed pulses at times in order, by a quadrature in steps. Exact where the speed is
/// constant; otherwise steps are halved until the rule agrees with one of lower order to 1e-7 (with two
/// filters 1e-8) of the length at the largest speed, and the speed of a step is nowhere negative. The steps
/// depend only on the two times.
class LengthWalk {
 public:
  /// Starts at `t` from the start of the motion [s].
  LengthWalk(FilterWalk& walk, const PulseTrain& train, double t);
  /// Path length covered since the previous time [mm].
  double advance_to(double t);
  /// The same, step by step: calls visit(LengthStep).
  template <typename Visit>
  void advance_to(double t, const Visit& visit);

  /// Sample at a time near the last one of advance_to(); free at the middle of the last step.
  SpeedSample sample_at(double t);

 private:
  SpeedSample sample(double t);
  template <typename Visit>
  void between(const SpeedSample& from, const SpeedSample& middle, const SpeedSample& to, double tolerance,
               int depth, const Visit& visit);

  FilterWalk& walk_;
  const PulseTrain& train_;
  SpeedSample last_;
  SpeedSample middle_;
};

/// Path length covered within a span of the motion, as a share of the span, so that both ends are exact
/// whatever the quadrature gives: never decreasing from 0 at `from` to 1 at `to`.
class SpanCourse {
 public:
  /// `from` < `to` from the start of the motion [s].
  SpanCourse(FilterWalk& walk, const PulseTrain& train, double from, double to)
      : walk_(walk), train_(train), from_(from), to_(to) {}
  double share_at(double t) const;
  /// First time at which `share` is covered, within [from, to] [s].
  double time_at(double share) const;

 private:
  FilterWalk& walk_;
  const PulseTrain& train_;
  double from_;
  double to_;
};

}  // namespace feedscope

#pragma once

#include "core/base/roots.h"
#include "core/feed/ramp.h"

namespace feedscope {

/// Whether plan_profile() from (v0, 0) is faster than `speed`, at least v0 and v1, somewhere: then ramps up
/// to it and back are shorter than the way.
inline bool rises_above(double speed, double v0, double v1, double length, double ceiling,
                        const RampLimits& limits) {
  return ceiling > speed && ramp_length(v0, speed, limits) + ramp_length(speed, v1, limits) < length;
}

/// Where along a speed profile that begins without acceleration the tool is faster than some speed, in closed
/// form: a root where ProfileWalk searches.
///
///   speed ^      .-----.           up: v0 to the peak
///       c |---- / ----- \ ---      down: the peak to the end
///         |   .'         '.        above(c): from low to high
///         +---|-----------|----> path
class ProfileSpeeds {
 public:
  /// Of plan_profile() from (v0, 0), which is feasible.
  ProfileSpeeds(double v0, double v1, double length, double ceiling, const RampLimits& limits);

  double largest() const { return top_; }  ///< [mm/s]
  /// The part of the path on which the profile is faster than `speed` [mm]; high < low where it nowhere is.
  Bracket above(double speed) const;
  /// Whether it is faster than `speed` somewhere before `to` and after `from` [mm].
  bool is_above(double speed, double from, double to) const {
    return speed < top_ && up_.length_to(speed) < to && length_ - down_.length_to(speed) > from;
  }

 private:
  /// A rise of the speed from no acceleration to none: jerk, constant acceleration, opposite jerk.
  class Rise {
   public:
    Rise(double slow, double fast, const RampLimits& limits);
    /// Length from its slow end to where it has `speed` [mm]; 0 for less than its slowest.
    double length_to(double speed) const;

   private:
    double slow_ = 0;
    double fast_ = 0;
    double jerk_ = 0;
    Motion1d held_{};        ///< where the acceleration stops growing
    double held_speed_ = 0;  ///< when it is no longer held [mm/s]
    double length_ = 0;
  };

  double top_;
  Rise up_;
  Rise down_;      ///< seen from its end
  double length_;  ///< [mm]
};

}  // namespace feedscope

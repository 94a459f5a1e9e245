#pragma once

#include "core/base/roots.h"
#include "core/feed/ramp.h"

namespace feedscope {

/// Whether plan_profile() from (v0, 0) exceeds `speed`, at least v0 and v1, somewhere: then the ramps up to
/// it and back are shorter than the length.
inline bool rises_above(double speed, double v0, double v1, double length, double ceiling,
                        const RampLimits& limits) {
  return ceiling > speed && ramp_length(v0, speed, limits) + ramp_length(speed, v1, limits) < length;
}

/// Part of a speed profile above a given speed, in closed form instead of a search by ProfileWalk; the
/// profile starts without acceleration.
///
///   speed ^      .-----.           up: v0 to the peak
///       c |---- / ----- \ ---      down: the peak to the end
///         |   .'         '.        above(c): from low to high
///         +---|-----------|----> path
class ProfileSpeeds {
 public:
  /// For plan_profile() from (v0, 0), which must be feasible.
  ProfileSpeeds(double v0, double v1, double length, double ceiling, const RampLimits& limits);

  double largest() const { return top_; }  ///< [mm/s]
  /// Part of the path on which the profile is above `speed` [mm]; high < low if there is none.
  Bracket above(double speed) const;
  /// Whether the profile is above `speed` somewhere between `from` and `to` [mm].
  bool is_above(double speed, double from, double to) const {
    return speed < top_ && up_.length_to(speed) < to && length_ - down_.length_to(speed) > from;
  }

 private:
  /// A rise of the speed from zero acceleration to zero: jerk, constant acceleration, opposite jerk.
  class Rise {
   public:
    Rise(double slow, double fast, const RampLimits& limits);
    /// Length from its slow end to the place with `speed` [mm]; 0 below its slowest speed.
    double length_to(double speed) const;

   private:
    double slow_ = 0;
    double fast_ = 0;
    double jerk_ = 0;
    Motion1d held_{};        ///< end of the increase of acceleration
    double held_speed_ = 0;  ///< end of the constant acceleration [mm/s]
    double length_ = 0;
  };

  double top_;
  Rise up_;
  Rise down_;      ///< from its end
  double length_;  ///< [mm]
};

}  // namespace feedscope

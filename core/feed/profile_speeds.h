#pragma once

#include "core/base/roots.h"
#include "core/feed/ramp.h"

namespace feedscope {

/// Where along a speed profile that begins without acceleration the tool is faster than some speed, in closed
/// form: a root where ProfileWalk searches.
///
///   speed ^      .-----.           up: v0 to the peak
///       c |---- / ----- \ ---      down: the peak to the end
///         |   .'         '.        above(c): from low to high
///         +---|-----------|----> path
class ProfileSpeeds {
 public:
  explicit ProfileSpeeds(const SpeedProfile& profile);

  /// The part of the path on which the profile is faster than `speed` [mm]; high < low where it nowhere is.
  Bracket above(double speed) const;

 private:
  /// A rise of the speed from no acceleration to none: jerk, constant acceleration, opposite jerk.
  class Rise {
   public:
    Rise() = default;
    Rise(double slow, double fast, const Phase& first, const Phase& second);
    /// Length from its slow end to where it has `speed` [mm]; 0 for less than its slowest.
    double length_to(double speed) const;
    double length() const { return length_; }

   private:
    double slow_ = 0;
    double fast_ = 0;
    double jerk_ = 0;
    Motion1d held_{};        ///< where the acceleration stops growing
    double held_time_ = 0;   ///< how long it is held [s]
    double held_speed_ = 0;  ///< when it is no longer held [mm/s]
    double length_ = 0;
  };

  Rise up_;
  Rise down_;  ///< seen from its end
  double top_ = 0;
  double end_of_fall_ = 0;  ///< [mm]
};

}  // namespace feedscope

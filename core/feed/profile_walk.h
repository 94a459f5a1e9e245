#pragma once

#include "core/feed/ramp.h"

namespace feedscope {

/// Walks along a speed profile by path length; each call continues from the last place. Copies nothing.
class ProfileWalk {
 public:
  explicit ProfileWalk(const SpeedProfile& profile);

  /// Advances to path length `s` (not before the current place) or to the profile's end, whichever comes
  /// first; returns the state there and records the largest speed on the way.
  const Motion1d& move_to(double s);
  const Motion1d& at() const { return at_; }
  double largest_speed() const { return largest_; }  ///< during the last move [mm/s]

  /// Current phase, and the time left in it; phase 7: the end.
  std::size_t phase() const { return phase_; }
  double phase_left() const { return phase_ < 7 ? profile_.phases[phase_].duration - tau_ : 0; }
  double jerk() const { return phase_ < 7 ? profile_.phases[phase_].jerk : 0; }
  /// Advances by `time`, at most to the end of the phase.
  void move_by(double time);
  /// Time within the current phase until path length `s` is reached; phase_left() if later [s].
  double time_to(double s) const;

 private:
  void skip_empty();

  const SpeedProfile& profile_;
  Motion1d start_;  ///< state at the start of the phase
  Motion1d at_;
  std::size_t phase_ = 0;
  double tau_ = 0;  ///< time in the phase
  double largest_ = 0;
};

}  // namespace feedscope

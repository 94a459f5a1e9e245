#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/limits/cause.h"
#include "core/program/controls/klipper_settings.h"
#include "core/toolpath/toolpath.h"

namespace feedscope {

/// A straight move with its speeds, planned together with its neighbours from standstill to standstill.
struct KlipperMove {
  double length = 0;               ///< L [mm]
  double acceleration = 0;         ///< a [mm/s2]
  double smooth_acceleration = 0;  ///< A (1 - q) [mm/s2]
  double corner_deviation = 0;     ///< (sqrt(2) - 1) V_sc^2 / A [mm]
  double top_squared = 0;          ///< v^2, of the feed and the limits [mm2/s2]
  double limit = 0;                ///< S, upper limit of the start speed squared [mm2/s2]
  double smooth_limit = 0;         ///< Ss, the same with the pseudo-acceleration
  double start = 0;                ///< speed squared at its start [mm2/s2]
  double cruise = 0;               ///< speed squared in its middle [mm2/s2]; negative until it is known
  double end = 0;                  ///< speed squared at its end [mm2/s2]
  Cause top_cause;                 ///< of v
  Cause limit_cause;               ///< of S
  bool below_peak = false;         ///< the cruise ratio sets `cruise`
  bool z_acceleration = false;

  double change() const { return 2 * length * acceleration; }  ///< D, of the speed squared
  /// Ds.
  double smooth_change() const { return 2 * length * std::min(acceleration, smooth_acceleration); }
};

/// The queue of moves between two full stops (README.md, "Planning").
class KlipperMoves {
 public:
  /// Appends a line along unit vector `direction` at `feed` [mm/s]; `limits`: in force there; `feed_cause`:
  /// where nothing else limits.
  void add(const Vec3& direction, double length, double feed, Cause feed_cause,
           const KlipperSettings& limits);
  /// Finds start, cruise and end of all moves, which end at rest.
  void plan();
  const std::vector<KlipperMove>& moves() const { return moves_; }
  void clear() { moves_.clear(); }

 private:
  void limit_junction(const Vec3& direction);
  void plan_backward();
  void plan_forward();

  std::vector<KlipperMove> moves_;
  Vec3 direction_ = Vec3::Zero();  ///< of the last added move
};

}  // namespace feedscope

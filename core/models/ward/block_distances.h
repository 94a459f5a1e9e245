#pragma once

#include <algorithm>

#include "core/models/ward/ward_pulses.h"
#include "core/trajectory/filter_walk.h"

namespace feedscope {

/// Distances of a block's programmed points from the path [mm].
struct BlockDistance {
  double corner = 0;  ///< its start
  double arc = 0;     ///< places inside an arc
  double largest() const { return std::max(corner, arc); }
};

/// Distances of programmed points from the path of laid pulses, block after block in order.
class BlockDistances {
 public:
  /// Both outlive this; the pulses do not change in the meantime.
  BlockDistances(const WardPulses& pulses, const PathRules& rules)
      : pulses_(pulses), train_(pulses.train), rules_(rules) {}

  BlockDistance of(std::size_t block);

 private:
  /// Calls f(point, time) for programmed points inside the arc of `block`: every `step` [s] from its ends up
  /// to `reach`, and in its middle; `time`: approximate time of the path there [s].
  template <typename F>
  void for_points_of_arc(std::size_t block, double step, double reach, F f) const;
  double of_arc(std::size_t block);
  /// Distance of a point from the path near `time` [mm]: by one evaluation and its Newton step where that is
  /// precise, which is usual because the path lags as much as at the previous point.
  double of_point(const Vec3& point, double time, double tolerance);

  const WardPulses& pulses_;
  const PulseTrain& train_;
  const PathRules& rules_;
  FilterWalk walk_;
  double lag_ = 0;  ///< of the path relative to the middle of the filters at the previous point [s]
};

}  // namespace feedscope

#pragma once

#include "core/limits/segment_limits.h"
#include "core/trajectory/trajectory_builder.h"

namespace feedscope {

/// Law of another model on its path, slowed down until it keeps velocity, programmed feed, acceleration and
/// jerk: a law near the bound must not be slower than it.
class SlowedLaw {
 public:
  SlowedLaw(const Trajectory& run, const AxisVectors& axes) : run_(run), axes_(axes) {}

  /// Replaces the motion of elements [first, last), from standstill to standstill, that `builder` collected
  /// from `start` on, where this law takes less time.
  void replace_slower(std::uint32_t first, std::uint32_t last, const TrajectoryBuilder::Mark& start,
                      TrajectoryBuilder& builder) const;

 private:
  double slower_by(std::size_t first_piece, std::size_t last_piece) const;

  const Trajectory& run_;
  const AxisVectors& axes_;
};

}  // namespace feedscope

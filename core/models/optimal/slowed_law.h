#pragma once

#include "core/limits/segment_limits.h"
#include "core/trajectory/trajectory_builder.h"

namespace feedscope {

/// The law by which another model runs a path, passed so much slower that it keeps velocity, programmed feed,
/// acceleration and jerk: what a law near the bound must not be slower than.
class SlowedLaw {
 public:
  SlowedLaw(const Trajectory& run, const AxisVectors& axes) : run_(run), axes_(axes) {}

  /// Where elements [first, last), from standstill to standstill, take less time by this law than what
  /// `builder` collected of them from `start` on, puts it in its place.
  void replace_slower(std::uint32_t first, std::uint32_t last, const TrajectoryBuilder::Mark& start,
                      TrajectoryBuilder& builder) const;

 private:
  double slower_by(std::size_t first_piece, std::size_t last_piece) const;

  const Trajectory& run_;
  const AxisVectors& axes_;
};

}  // namespace feedscope

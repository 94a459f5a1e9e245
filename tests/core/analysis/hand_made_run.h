#pragma once

#include <memory>
#include <vector>

#include "core/trajectory/trajectory_builder.h"

/// Runs whose motion is given piece by piece, so that what an analysis says of them is known.
namespace feedscope::testing {

/// A piece and its time [s].
struct Passage {
  Piece piece;
  double duration;
};

inline Segment line_to(const Vec3& end, double length, double feed, std::uint32_t line = 0) {
  Segment segment;
  segment.end = end;
  segment.length = length;
  segment.feed = feed;
  segment.line = line;
  return segment;
}

/// `toolpath` as it is, passed as `runs` say; `axis_speed` of rapids [mm/s].
inline Trajectory trajectory_of(const Toolpath& toolpath, const std::vector<Passage>& runs,
                                const Vec3& axis_speed) {
  TrajectoryBuilder builder(std::make_shared<const Toolpath>(toolpath), axis_speed);
  for (std::uint32_t i = 0; i < toolpath.segments.size(); ++i) {
    builder.add_segment(i);
  }
  for (const Passage& run : runs) {
    builder.add_piece(run.piece, run.duration);
  }
  return builder.finish();
}

}  // namespace feedscope::testing

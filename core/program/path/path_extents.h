#pragma once

#include <array>

#include "core/program/program.h"

namespace feedscope {

/// Adds the full extent of the arc or helix from `start` to `end` [mm].
void add_arc(Bounds& bounds, const Vec3& start, const Vec3& end, const ArcWords& words);

/// Follows the motions of a program and maintains the bounds that Program documents.
class PathExtents {
 public:
  /// `program` outlives it.
  explicit PathExtents(Program& program) : program_(program) {}

  /// Adds the next motion. `axes`: programmed by its block; `arc`: of arcs only.
  void add(const MotionBlock& block, const ArcWords& arc, const std::array<bool, 3>& axes);
  /// Continues the path at `to`; `axes`: those programmed so far.
  void go_on_at(const Vec3& to, const std::array<bool, 3>& axes);

 private:
  Program& program_;
  Vec3 position_ = Vec3::Zero();  ///< end of the last motion [mm]
  std::array<bool, 3> known_{};   ///< axes whose position the program has given
};

}  // namespace feedscope

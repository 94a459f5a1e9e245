#pragma once

#include "core/trajectory/part_walk.h"

namespace feedscope {

/// States at instants that never fall: each takes constant time on average.
class StateWalk {
 public:
  /// `from`: the first instant [s].
  explicit StateWalk(const Trajectory& trajectory, double from = 0)
      : trajectory_(trajectory),
        walk_(trajectory, trajectory.pieces().empty() ? 0 : trajectory.piece_at(from)) {}

  /// `time` [s]: not before that of the last call.
  State at(double time) {
    while (!walk_.done() && walk_.part().time + walk_.part().duration <= time) {
      walk_.next();
    }
    return walk_.done() ? trajectory_.state(time) : walk_.motion().state(time - walk_.part().time);
  }

 private:
  const Trajectory& trajectory_;
  PartWalk walk_;
};

}  // namespace feedscope

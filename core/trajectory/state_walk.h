#pragma once

#include <optional>

#include "core/trajectory/part_walk.h"

namespace feedscope {

/// States at non-decreasing times, each in constant time on average.
class StateWalk {
 public:
  /// `from`: the first time [s].
  explicit StateWalk(const Trajectory& trajectory, double from = 0)
      : trajectory_(trajectory),
        walk_(trajectory, trajectory.pieces().empty() ? 0 : trajectory.piece_at(from)) {}
  StateWalk(const StateWalk&) = delete;
  StateWalk& operator=(const StateWalk&) = delete;

  /// `time` [s]: not before that of the previous call.
  State at(double time) {
    const PartMotion* motion = motion_at(time);
    return motion != nullptr ? motion->state(time - walk_.part().time) : trajectory_.state(time);
  }
  /// The same with a path length of 0, which avoids its quadrature on curves.
  State at_without_length(double time) {
    const PartMotion* motion = motion_at(time);
    return motion != nullptr ? motion->state_without_length(time - walk_.part().time)
                             : trajectory_.state(time);
  }

 private:
  /// Null after the last part.
  const PartMotion* motion_at(double time) {
    while (!walk_.done() && walk_.part().time + walk_.part().duration <= time) {
      walk_.next();
      motion_.reset();
    }
    if (walk_.done()) {
      return nullptr;
    }
    if (!motion_) {
      motion_.emplace(walk_.motion());
    }
    return &*motion_;
  }

  const Trajectory& trajectory_;
  PartWalk walk_;
  std::optional<PartMotion> motion_;  ///< of the current part
};

}  // namespace feedscope

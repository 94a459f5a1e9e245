#pragma once

#include "core/trajectory/part_walk.h"

namespace feedscope {

/// How many instants between the ends of a part are looked at to find extremes of what goes with its motion,
/// evenly spaced: none on lines, every 5 degrees on arcs, on blends the closer the sharper they turn, some in
/// each filter time. `duration`: of the part, or of its beginning [s].
int inner_looks(const Trajectory& trajectory, const Part& part, const ElementCurve& curve, double duration);

/// The instants at which a part is looked at: its ends, those between them, and where the feed stops rising
/// or falling.
class PartLooks {
 public:
  PartLooks(const Trajectory& trajectory, const Part& part, const ElementCurve& curve);

  int count() const { return count_; }
  /// Instant `i`, 0 to count() - 1 [s].
  double at(int i) const;
  /// The first one behind `time` [s]; count() if there is none.
  int first_after(double time) const;

 private:
  double start_;     ///< [s]
  double duration_;  ///< [s]
  double turn_;      ///< where the feed turns, from the start; the middle where it does not [s]
  int spaced_;       ///< parts between evenly spaced instants
  int before_turn_;  ///< evenly spaced instants up to the turn
  int count_;
};

}  // namespace feedscope

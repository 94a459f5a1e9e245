#pragma once

#include "core/trajectory/part_walk.h"

namespace feedscope {

/// Number of evenly spaced instants sampled between the ends of a part to find extremes of its motion: none
/// on lines, every 5 degrees on arcs, more on blends the sharper they turn, several per filter time.
/// `duration`: of the part, or of its beginning [s].
int inner_looks(const Trajectory& trajectory, const Part& part, const ElementCurve& curve, double duration);

/// Instants at which a part is sampled: its ends, evenly spaced ones between them, and the turning point of
/// the feed.
class PartLooks {
 public:
  PartLooks(const Trajectory& trajectory, const Part& part, const ElementCurve& curve);

  int count() const { return count_; }
  /// Instant `i`, 0 to count() - 1 [s].
  double at(int i) const;
  /// Index of the first instant after `time` [s]; count() if there is none.
  int first_after(double time) const;

 private:
  double start_;     ///< [s]
  double duration_;  ///< [s]
  double turn_;      ///< turning point of the feed, from the start; the middle if there is none [s]
  int spaced_;       ///< intervals between evenly spaced instants
  int before_turn_;  ///< evenly spaced instants up to the turning point
  int count_;
};

}  // namespace feedscope

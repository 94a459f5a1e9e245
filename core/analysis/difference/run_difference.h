#pragma once

#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/trajectory/trajectory.h"

namespace feedscope {

/// What a run does unlike a reference run of the same program, place by place. A place is where both have
/// come equally far along the programmed path (CourseWalk); within a dwell, at the same share of it.
struct RunDifference {
  /// Time to the place less that of the reference [s]; the last one of a whole run is the difference of the
  /// cycle times.
  std::vector<double> lost;
  /// How fast time is lost at the place [s/mm programmed], below 0 where it is won: the mean of the stretches
  /// to the places before and behind, or one of them where the other is a jump. Finite at a standstill. In a
  /// dwell 0.
  std::vector<float> pace;
  /// From the run to the path that the reference executes [mm], as NearestPlace.
  std::vector<float> distance;
  /// When the reference is there [s].
  std::vector<double> reference_time;
};

/// At `times` of the run [s], which must not fall; clamped to the run. Linear in the pieces of both runs and
/// in the places; of the same run twice all is 0. Both run the same programmed path: throws
/// std::invalid_argument where one has no pieces or their numbers of segments differ. Throws Cancelled.
RunDifference compare_places(const Trajectory& run, const Trajectory& reference,
                             std::span<const double> times, Progress* progress = nullptr);

/// When `other` is where `run` is at `times` [s], as above.
std::vector<double> times_at_places(const Trajectory& run, const Trajectory& other,
                                    std::span<const double> times);

}  // namespace feedscope

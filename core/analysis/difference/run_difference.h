#pragma once

#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/trajectory/trajectory.h"

namespace feedscope {

/// Differences between a run and a reference run of the same program, place by place. A place is where both
/// have the same progress along the programmed path (CourseWalk); within a dwell, at the same share of it.
struct RunDifference {
  /// Time to the place minus that of the reference [s]; the last one of a whole run is the difference of the
  /// cycle times.
  std::vector<double> lost;
  /// Rate of time lost at the place [s/mm programmed], below 0 if gained: mean of the stretches to the places
  /// before and after, or one of them if the other is a jump. Finite at a standstill, 0 in a dwell.
  std::vector<float> pace;
  /// from the run to the executed path of the reference [mm], as in NearestPlace
  std::vector<float> distance;
  /// Time of the reference at the place [s].
  std::vector<double> reference_time;
};

/// Compares at `times` of the run [s], in ascending order, clamped to the run. Linear in the pieces of both
/// runs and in the places; all zero for the same run twice. Both must run the same programmed path: throws
/// std::invalid_argument if one has no pieces or their numbers of segments differ. Throws Cancelled.
RunDifference compare_places(const Trajectory& run, const Trajectory& reference,
                             std::span<const double> times, Progress* progress = nullptr);

/// Times at which `other` is where `run` is at `times` [s], as in compare_places().
std::vector<double> times_at_places(const Trajectory& run, const Trajectory& other,
                                    std::span<const double> times);

}  // namespace feedscope

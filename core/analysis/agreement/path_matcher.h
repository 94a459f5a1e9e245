#pragma once

#include <limits>
#include <vector>

#include "core/analysis/agreement/programmed_course.h"
#include "core/base/progress.h"

namespace feedscope {

/// Positions in order of time.
struct MotionRecord {
  std::vector<double> time;  ///< rising [s]
  std::vector<Vec3> place;   ///< [mm]
};

struct MatchOptions {
  double tolerance = 0;        ///< largest distance from the path at which a position matches [mm]
  double noise = 0;            ///< of the positions [mm]
  double most_searched = 2e8;  ///< points of the path in total during the search for the start
};

/// Places of recorded positions on a programmed path.
struct MatchedRecord {
  static constexpr double unmatched = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> s;        ///< programmed path length, never decreasing; `unmatched` off the path [mm]
  std::vector<float> distance;  ///< from the path [mm]
  std::size_t first = 0;        ///< first sample that matches
  std::size_t end = 0;          ///< one past the last one
  std::size_t arrival = 0;      ///< first sample at the end of the path; the number of samples if none
  std::size_t lost = 0;         ///< samples between `first` and `end` that do not match
  bool empty() const { return first >= end; }
};

/// Finds recorded positions on a path, in order. Each takes the nearest place not before that of the previous
/// sample, within a window ahead as long as the tool can have travelled (three times the recorded distance,
/// and four tolerances); of several equally near, the first. Thus pauses do not move, and order decides where
/// the path overlaps or repeats itself. A position farther away than the tolerance is not matched, and the
/// search continues ahead. Matching begins where the record first reaches the start of the path, or else
/// where it first reaches the path. Linear in the samples while they match. `from`: first sample to consider.
/// Throws Cancelled.
MatchedRecord match_record(const ProgrammedCourse& course, const MotionRecord& record,
                           const MatchOptions& options, std::size_t from = 0, Progress* progress = nullptr);

/// Noise of recorded positions [mm], from their fourth differences, to which motion hardly contributes.
double noise_of(const MotionRecord& record);

}  // namespace feedscope

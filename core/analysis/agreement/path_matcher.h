#pragma once

#include <limits>
#include <vector>

#include "core/analysis/agreement/programmed_course.h"
#include "core/base/progress.h"

namespace feedscope {

/// Places that follow each other in time.
struct MotionRecord {
  std::vector<double> time;  ///< rising [s]
  std::vector<Vec3> place;   ///< [mm]
};

struct MatchOptions {
  double tolerance = 0;        ///< farther from the path a place does not fit [mm]
  double noise = 0;            ///< of the places [mm]
  double most_searched = 2e8;  ///< points of the path in all while looking for the start
};

/// Where on a programmed path recorded places are.
struct MatchedRecord {
  static constexpr double unmatched = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> s;  ///< programmed path length, never falling; `unmatched` where it does not fit [mm]
  std::vector<float> distance;  ///< from the path [mm]
  std::size_t first = 0;        ///< first sample that fits
  std::size_t end = 0;          ///< behind the last one
  std::size_t arrival = 0;      ///< first sample at the end of the path; the number of samples: none
  std::size_t lost = 0;         ///< samples between the two that do not fit
  bool empty() const { return first >= end; }
};

/// Finds recorded places on a path, in order: each at the nearest place not before the one of the sample
/// before, within a window ahead as long as the tool can have come (three times what was recorded, and four
/// tolerances); of several equally near the first. So pauses stay where they are, and where the path
/// overlaps or repeats itself the order decides. What is farther away than the tolerance is not matched, and
/// the search goes on ahead. It begins where the record first comes to the start of the path, or else where
/// it first comes onto it. Linear in the samples where they fit.
/// `from`: the first sample to look at. Throws Cancelled.
MatchedRecord match_record(const ProgrammedCourse& course, const MotionRecord& record,
                           const MatchOptions& options, std::size_t from = 0, Progress* progress = nullptr);

/// Noise of recorded places, from their fourth differences, which motion hardly has [mm].
double noise_of(const MotionRecord& record);

}  // namespace feedscope

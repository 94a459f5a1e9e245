#pragma once

#include <vector>

#include "core/analysis/run/run.h"

namespace feedscope::ui {

/// A run over equal parts of its programmed feed motions, without rapids and pauses.
struct FeedCourse {
  double length = 0;               ///< programmed, of all parts [mm]
  std::vector<double> feed;        ///< mean over each part along the programmed path [mm/s]
  std::vector<double> programmed;  ///< mean of the programmed feed [mm/s]
  std::vector<double> lost;        ///< against the programmed feed, up to the end of each part [s]
};

/// Linear in the segments, plus two searches of the run for each part and each rapid or pause. Empty for a
/// program without feed motions.
FeedCourse feed_course(const Run& run, std::size_t parts);

}  // namespace feedscope::ui

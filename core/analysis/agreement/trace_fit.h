#pragma once

#include "core/analysis/agreement/path_matcher.h"
#include "core/analysis/agreement/programmed_course.h"

namespace feedscope {

/// Shares of a trace and of a program that are the same motion.
struct TraceFit {
  double trace_share = 0;  ///< of the trace's length that follows the path; 0: it does not move
  double path_share = 0;   ///< of the path's length that the trace follows
  double way = 0;          ///< length of the trace, over the recorded axes [mm]
};

/// Measures in steps of a few tolerances. A step counts if both ends are matched and the path between them is
/// about as long as the step; thus a path that is only crossed, or passed over by the order of the search,
/// does not count. Nothing is measured before a start at the beginning of the path, after the arrival at its
/// end, or in gaps between samples. `period`: of the record [s].
TraceFit fit_of(const ProgrammedCourse& course, const MotionRecord& record, const MatchedRecord& matched,
                const MatchOptions& options, double period);

}  // namespace feedscope

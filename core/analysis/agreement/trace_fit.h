#pragma once

#include "core/analysis/agreement/path_matcher.h"
#include "core/analysis/agreement/programmed_course.h"

namespace feedscope {

/// How much of a trace and of a program is the same motion.
struct TraceFit {
  double trace_share = 0;  ///< of the way of the trace that runs along the path; 0: it does not move
  double path_share = 0;   ///< of the path that the trace runs along
  double way = 0;          ///< of the trace, that of the axes that are seen [mm]
};

/// Measures it in steps of some tolerances: one counts where both of its ends were matched and the path
/// between them is about as long as the step. So a path that is merely crossed, or that the order of the
/// search runs through, does not count. Before a start at the begin of the path, behind the arrival at its
/// end, and in gaps between samples nothing is measured. `period`: of the record [s].
TraceFit fit_of(const ProgrammedCourse& course, const MotionRecord& record, const MatchedRecord& matched,
                const MatchOptions& options, double period);

}  // namespace feedscope

#pragma once

#include <vector>

#include "core/analysis/agreement/programmed_course.h"
#include "core/analysis/agreement/time_law.h"
#include "core/analysis/agreement/trace_on_program.h"
#include "core/base/diagnostic.h"

namespace feedscope {

/// A place where a trace stops longer than a run: a feed hold, an operator, a door.
struct HeldStretch {
  double from = 0;    ///< of the trace [s]
  double to = 0;      ///< when motion resumes [s]
  double held = 0;    ///< excess over the stop of the run there [s]
  double from_s = 0;  ///< programmed path length, with half a second of motion on both sides [mm]
  double to_s = 0;
};

/// Held stretches of half a second or more, in order of the trace. `noise`: of its positions [mm]. Dwells
/// that the run also has do not count, nor does the time before the first or after the last motion.
std::vector<HeldStretch> held_stretches(const TimeLaw& trace, const TimeLaw& run, double noise);

/// Adds a remark for each stop of a trace that the run does not have. `run`: on the programmed path.
void add_held_remarks(TraceOnProgram& trace, const ProgrammedCourse& course, const TimeLaw& run);

/// Names the first few stops and the number of the others; `hint`: consequence of that.
void add_held_notes(std::vector<Diagnostic>& remarks, const std::vector<HeldStretch>& held,
                    const ProgrammedCourse& course, const Message& hint);

}  // namespace feedscope

#pragma once

#include <vector>

#include "core/analysis/agreement/programmed_course.h"
#include "core/analysis/agreement/time_law.h"
#include "core/analysis/agreement/trace_on_program.h"
#include "core/base/diagnostic.h"

namespace feedscope {

/// A place where a trace stands still longer than a run: a feed hold, an operator, a door.
struct HeldStretch {
  double from = 0;    ///< of the trace [s]
  double to = 0;      ///< when it goes on [s]
  double held = 0;    ///< longer than the run is there [s]
  double from_s = 0;  ///< programmed path length, with half a second of motion on both sides [mm]
  double to_s = 0;
};

/// Those of a trace, of half a second and more, in its order. `noise`: of its places [mm]. Dwells that the
/// run has too are none, nor is the time before the first and after the last motion.
std::vector<HeldStretch> held_stretches(const TimeLaw& trace, const TimeLaw& run, double noise);

/// Says in the remarks of a trace where it stands still and the run, `run` on its programmed path, does not.
void add_held_remarks(TraceOnProgram& trace, const ProgrammedCourse& course, const TimeLaw& run);

/// Says it of the first few, and how many there are besides; `hint`: what follows from that.
void add_held_notes(std::vector<Diagnostic>& remarks, const std::vector<HeldStretch>& held,
                    const ProgrammedCourse& course, const Message& hint);

}  // namespace feedscope

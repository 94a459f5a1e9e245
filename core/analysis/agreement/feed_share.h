#pragma once

#include <optional>

#include "core/analysis/agreement/agreement.h"
#include "core/analysis/agreement/programmed_course.h"
#include "core/toolpath/toolpath.h"

namespace feedscope {

/// At which share of the programmed feed a trace runs wherever the run has the programmed one: that of an
/// override, or of times of another rate. Where the run hardly comes to the programmed feed, or the trace
/// differs there, the largest share above 1 that the trace keeps. None where it is about 1, differs from
/// place to place, or few places show it.
std::optional<double> feed_share(const Agreement& agreement, const ProgrammedCourse& course,
                                 const Toolpath& toolpath);

/// The ratio of recorded to simulated feed where it is the same at even speed and where the machine speeds up
/// or slows down: no override makes that, nor do other limits, but times of another rate do. None where it is
/// about 1, differs from place to place, or few places show it.
std::optional<double> pace_ratio(const Agreement& agreement);

/// Simulated over recorded time of the dwells of the program, where that is above 1 and the same at most of
/// them, whatever the limits and the feed override: times of another rate make the trace shorter than it was.
/// None of a trace that stands longer, as controls do, or of few dwells.
std::optional<double> dwell_ratio(const TimeLaw& trace, const TimeLaw& run, const ProgrammedCourse& course,
                                  const Toolpath& toolpath);

/// Says in the remarks of a trace that its feed_share(), pace_ratio() or dwell_ratio() is not 1, as
/// "trace-rate" where its rate is wrong and as "trace-override" where it may be an override: limits that are
/// found from it are wrong.
void add_feed_remark(TraceOnProgram& trace, const Agreement& agreement, const ProgrammedCourse& course,
                     const Toolpath& toolpath);

/// What says that the rate of a trace without times is wrong: its own feeds, or add_feed_remark() to `found`;
/// null: nothing.
const Diagnostic* wrong_rate_of(const Trace& trace, const TraceOnProgram& found);

}  // namespace feedscope

#pragma once

#include <optional>

#include "core/analysis/agreement/agreement.h"
#include "core/analysis/agreement/programmed_course.h"
#include "core/toolpath/toolpath.h"

namespace feedscope {

/// Share of the programmed feed at which a trace runs where the run has the programmed feed: an override, or
/// times of another sampling rate. If the run hardly reaches the programmed feed, or the trace differs there,
/// the largest share above 1 that the trace keeps. None if it is about 1, varies from place to place, or few
/// places show it.
std::optional<double> feed_share(const Agreement& agreement, const ProgrammedCourse& course,
                                 const Toolpath& toolpath);

/// Ratio of recorded to simulated feed where it is the same at even speed as when speeding up and slowing
/// down. No override or other limits cause that, but times of another sampling rate do. None if it is about
/// 1, varies from place to place, or few places show it.
std::optional<double> pace_ratio(const Agreement& agreement);

/// Simulated over recorded time of the program's dwells, if it is above 1 and the same at most of them,
/// whatever the limits and the feed override: times of another sampling rate make the trace too short. None
/// if the trace dwells longer, as controls do, or has few dwells.
std::optional<double> dwell_ratio(const TimeLaw& trace, const TimeLaw& run, const ProgrammedCourse& course,
                                  const Toolpath& toolpath);

/// Adds a remark to a trace whose feed_share(), pace_ratio() or dwell_ratio() is not 1: "trace-rate" if its
/// sampling rate is wrong, "trace-override" if it may be an override. Limits identified from such a trace are
/// wrong.
void add_feed_remark(TraceOnProgram& trace, const Agreement& agreement, const ProgrammedCourse& course,
                     const Toolpath& toolpath);

/// Remark that the sampling rate of a trace without times is wrong, from its own feeds or from
/// add_feed_remark() on `found`; null without one.
const Diagnostic* wrong_rate_of(const Trace& trace, const TraceOnProgram& found);

}  // namespace feedscope

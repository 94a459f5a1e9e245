#pragma once

#include <optional>

#include "core/analysis/agreement/agreement.h"
#include "core/analysis/agreement/programmed_course.h"
#include "core/toolpath/toolpath.h"

namespace feedscope {

/// At which share of the programmed feed a trace runs wherever the run has the programmed one: that of an
/// override, or of times of another rate. None where it is about 1, differs from place to place, or few
/// places show it.
std::optional<double> feed_share(const Agreement& agreement, const ProgrammedCourse& course,
                                 const Toolpath& toolpath);

/// Says so in the remarks of a trace: limits that are found from it are those of the override.
void add_feed_remark(TraceOnProgram& trace, const Agreement& agreement, const ProgrammedCourse& course,
                     const Toolpath& toolpath);

}  // namespace feedscope

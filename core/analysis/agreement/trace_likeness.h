#pragma once

#include <vector>

#include "core/analysis/agreement/path_matcher.h"
#include "core/analysis/agreement/programmed_course.h"
#include "core/base/diagnostic.h"

namespace feedscope {

/// Transformations with which a trace that does not fit a program would fit as a whole: columns in another
/// order, another unit, other signs, run backwards. One remark on each, with advice; empty if none brings it
/// within a hundredth of its size of the path. `record`: as recorded.
std::vector<Diagnostic> likeness_remarks(const ProgrammedCourse& course, const MotionRecord& record);
/// Whether a remark comes from likeness_remarks().
bool says_likeness(const Diagnostic& remark);

}  // namespace feedscope

#pragma once

#include <vector>

#include "core/analysis/agreement/path_matcher.h"
#include "core/analysis/agreement/programmed_course.h"
#include "core/base/diagnostic.h"

namespace feedscope {

/// How a trace that does not fit a program would fit it as a whole: with its columns in another order, in
/// another unit, with other signs, run backwards. A remark on each of these, with what to do; nothing if none
/// lays it onto the path within a hundredth of its size. `record`: as it was recorded.
std::vector<Diagnostic> likeness_remarks(const ProgrammedCourse& course, const MotionRecord& record);
/// Whether a remark is one of these.
bool says_likeness(const Diagnostic& remark);

}  // namespace feedscope

#pragma once

#include <span>
#include <string>

#include "core/analysis/notes/slower_tolerance.h"

namespace feedscope {

/// Whether limits on corner blends cause the longer time.
bool is_by_blends(const SlowerTolerance& slower);
/// Reason why a wider tolerance takes longer, as one sentence for display; empty unless it is by blends.
std::string why_slower(const SlowerTolerance& slower);

/// Whether the tolerances of a comparison have no effect: the runs differ in the contour tolerance, none has
/// a blend, and runs that otherwise agree take the same time.
bool tolerances_without_effect(std::span<const ComparedRun> runs);

}  // namespace feedscope

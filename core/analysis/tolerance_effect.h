#pragma once

#include <span>
#include <string>

#include "core/analysis/slower_tolerance.h"

namespace feedscope {

/// Whether limits on corner blends are what takes longer.
bool is_by_blends(const SlowerTolerance& slower);
/// Why a wider tolerance can take longer, as one sentence for people; empty where it is not by blends.
std::string why_slower(const SlowerTolerance& slower);

/// Whether the runs differ in the contour tolerance, none has a blend, and runs that differ in nothing else
/// take the same time: the tolerances compared change nothing.
bool tolerances_without_effect(std::span<const ComparedRun> runs);

}  // namespace feedscope

#pragma once

#include <string>

#include "core/export/merge.h"

namespace feedscope {

/// Programs as groups with a row for each run, then the sums over all programs by setting; a star marks the
/// fastest within the bound. Programs with errors or without motion are marked, in the heading of the sums
/// too.
std::string merge_text(const MergedComparison& merged);

}  // namespace feedscope

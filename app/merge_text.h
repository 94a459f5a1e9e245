#pragma once

#include <string>

#include "core/export/merge.h"

namespace feedscope {

/// Programs as groups with a row a run, then the sums over all programs by setting.
std::string merge_text(const MergedComparison& merged);

}  // namespace feedscope

#pragma once

#include <optional>

#include "core/base/diagnostic.h"
#include "core/toolpath/toolpath.h"

namespace feedscope {

/// First place of a path beyond the reach of any machine or the patience of any shop: a coordinate beyond 100
/// km, a path that spans more than 1 km along an axis, an element longer than 10 km, a rotary axis beyond 100
/// 000 turns, more than a year at the programmed feeds. An error with line and value, code "beyond-machines";
/// none for a path that can be run.
std::optional<Diagnostic> beyond_machines(const Toolpath& toolpath);

}  // namespace feedscope

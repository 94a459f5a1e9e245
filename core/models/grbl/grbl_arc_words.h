#pragma once

#include <string>

#include "core/models/grbl/grbl_arc.h"
#include "core/models/grbl/grbl_line.h"

namespace feedscope {

/// Centre and radius of `arc`, whose ends, plane and sense are known, from the words of its line; or why grbl
/// rejects it. `unit`: of the words [mm]; the letters that the arc uses are added to `used`.
std::optional<GrblError> read_arc_words(const GrblLine& line, float unit, GrblArc& arc, std::string& used);

}  // namespace feedscope

#pragma once

#include <string>

#include "core/program/controls/grbl_arc.h"
#include "core/program/controls/grbl_line.h"

namespace feedscope {

/// Sets centre and radius of `arc`, whose ends, plane and sense are known, from the words of its line;
/// returns grbl's error if it rejects it. `unit`: of the words [mm]. Adds the letters of the arc to `used`.
std::optional<GrblError> read_arc_words(const GrblLine& line, float unit, GrblArc& arc, std::string& used);

}  // namespace feedscope

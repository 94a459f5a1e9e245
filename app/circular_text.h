#pragma once

#include <span>
#include <string>

#include "core/analysis/circularity/program_circles.h"

namespace feedscope {

/// Circular tests of one setup for people: a row for each direction, and the meaning of the letters.
std::string circular_text(const Setup& setup, std::span<const CircularTest> tests);

/// The full circles of a program as such a table, or a sentence if there are none.
std::string program_circles_text(const Run& run, const ProgramCircles& circles);

}  // namespace feedscope

#pragma once

#include <string>
#include <vector>

#include "core/identification/fit_parameter.h"

namespace feedscope {

/// For each parameter, the title of the first part of the test program (identification_program()) that would
/// determine it: halving its value at `setup` changes the time in motion clearly, and by at least a quarter
/// of the largest change of any part. "" if there is none: the model does not use it, or not there. Simulates
/// the test program once for each.
std::vector<std::string> telling_parts(const Setup& setup, const std::vector<FitParameter>& parameters);

}  // namespace feedscope

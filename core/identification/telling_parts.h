#pragma once

#include <string>
#include <vector>

#include "core/identification/fit_parameter.h"

namespace feedscope {

/// By parameter the title of the first part of the test program (identification_program()) whose time in
/// motion half of its value at `setup` changes by a quarter as much as that of any other part, and clearly;
/// "" where there is none: the model does not use it, or not there. The test program is simulated once for
/// each.
std::vector<std::string> telling_parts(const Setup& setup, const std::vector<FitParameter>& parameters);

}  // namespace feedscope

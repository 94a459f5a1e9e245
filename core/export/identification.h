#pragma once

#include <span>
#include <string>

#include "core/identification/identify.h"

namespace feedscope {

/// What identification found, by model, as JSON: keys of README.md beside this file. `parameters` and
/// `agreement` at the top are those of the first.
std::string identification_json(std::span<const Identification> models,
                                const std::vector<std::string>& traces);

}  // namespace feedscope

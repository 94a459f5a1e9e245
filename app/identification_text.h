#pragma once

#include <string>
#include <vector>

#include "core/identification/identify.h"

namespace feedscope {

/// What identification found, for people; the best model first.
std::string identification_text(const std::vector<Identification>& models,
                                const std::vector<std::string>& traces);

}  // namespace feedscope

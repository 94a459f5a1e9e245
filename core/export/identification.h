#pragma once

#include <span>
#include <string>

#include "core/identification/identify.h"
#include "core/identification/unfitted_model.h"

namespace feedscope {

/// What identification found, by model, as JSON: keys of README.md beside this file. `parameters` and
/// `agreement` at the top are those of the first. `unfitted`: models that were asked for and failed.
std::string identification_json(std::span<const Identification> models,
                                const std::vector<std::string>& traces,
                                std::span<const UnfittedModel> unfitted = {});

}  // namespace feedscope

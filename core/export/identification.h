#pragma once

#include <span>
#include <string>

#include "core/identification/identify.h"
#include "core/identification/unfitted_model.h"

namespace feedscope {

/// Results of an identification, by model, as JSON: keys in README.md next to this file. `parameters` and
/// `agreement` at the top are those of the first model. `unfitted`: requested models that failed.
std::string identification_json(std::span<const Identification> models,
                                const std::vector<std::string>& traces,
                                std::span<const UnfittedModel> unfitted = {});

}  // namespace feedscope

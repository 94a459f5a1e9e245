#pragma once

#include <string>
#include <vector>

#include "core/identification/identify.h"
#include "core/identification/unfitted_model.h"

namespace feedscope {

/// Results of the identification for people; the best model first. `unfitted`: models that failed.
std::string identification_text(const std::vector<Identification>& models,
                                const std::vector<std::string>& traces,
                                const std::vector<UnfittedModel>& unfitted = {});
/// A line with the numbers of the machine file that are not determined; "" for none.
std::string undetermined_text(const Identification& found);

}  // namespace feedscope

#pragma once

#include <string>
#include <vector>

#include "core/identification/identify.h"
#include "core/identification/unfitted_model.h"

namespace feedscope {

/// What identification found, for people; the best model first. `unfitted`: models that failed.
std::string identification_text(const std::vector<Identification>& models,
                                const std::vector<std::string>& traces,
                                const std::vector<UnfittedModel>& unfitted = {});
/// Which numbers the machine file keeps without being determined, on a line of its own; "" for none.
std::string undetermined_text(const Identification& found);

}  // namespace feedscope

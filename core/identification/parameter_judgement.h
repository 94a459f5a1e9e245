#pragma once

#include <vector>

#include "core/identification/identify.h"
#include "core/identification/parameter_search.h"

namespace feedscope {

/// Judges of each parameter where a search stands whether the traces tell it, and how well: uncertainty,
/// reason, bound. `start`: values that were begun with, in the units of the keys.
/// `without`: by parameter the cost of the best explanation in which another one stands for it.
std::vector<IdentifiedParameter> judge_parameters(ParameterSearch& search, const std::vector<double>& start,
                                                  const std::vector<double>& without);

/// Which parameters change the residuals by more than noise where they are half as large again or as small.
std::vector<bool> influences(ParameterSearch& search);

}  // namespace feedscope

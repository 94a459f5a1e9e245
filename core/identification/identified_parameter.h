#pragma once

#include <optional>
#include <string>

#include "core/identification/fit_parameter.h"
#include "core/machine/machine.h"

namespace feedscope {

/// Result for one number.
struct IdentifiedParameter {
  FitParameter parameter;
  double start = 0;  ///< value of the machine at the start, in the unit of the key
  double value = 0;  ///< best fit to the traces; for a number not determined, the value that stays in use
  double uncertainty = 0;          ///< with 95 % probability; 0 if not determined
  bool told = false;               ///< determined by the traces
  std::string reason;              ///< why it is not determined
  std::optional<double> at_least;  ///< not determined, but smaller values would be visible
  std::string told_by;  ///< not determined: the part of the test program that would determine it; "" if none
};

/// Sources for machine files: of a number that is determined, and of one that is not and stays in use,
/// recognised by is_undetermined(). `from`: names of the traces and the date; `before`: source of the start
/// value.
Provenance identified_source(const IdentifiedParameter& parameter, const std::string& from);
Provenance undetermined_source(const IdentifiedParameter& parameter, const std::string& from,
                               const Provenance& before);

}  // namespace feedscope

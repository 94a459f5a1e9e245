#pragma once

#include <optional>
#include <string>

#include "core/identification/fit_parameter.h"
#include "core/machine/machine.h"

namespace feedscope {

/// What was found out about one number.
struct IdentifiedParameter {
  FitParameter parameter;
  double start = 0;        ///< of the machine that was begun with, in the unit of the key
  double value = 0;        ///< that explains the traces best; of one that is not told what stays in use
  double uncertainty = 0;  ///< that the value is within with 95 % probability; 0 if it is not told
  bool told = false;       ///< the traces say it
  std::string reason;      ///< why it is not told
  std::optional<double> at_least;  ///< not told, but smaller ones would show
  std::string told_by;             ///< not told: the part of the test program that tells it; "" if none does
};

/// Sources for machine files: of a number that is told, and of another one that stays in use, by which
/// is_undetermined() knows it. `from`: names of the traces and the date; `before`: source of the value that
/// was begun with.
Provenance identified_source(const IdentifiedParameter& parameter, const std::string& from);
Provenance undetermined_source(const IdentifiedParameter& parameter, const std::string& from,
                               const Provenance& before);

}  // namespace feedscope

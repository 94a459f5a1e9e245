#pragma once

#include <string>
#include <vector>

#include "core/analysis/run.h"

namespace feedscope {

/// A number of a machine or of a control's settings that is to be found: never 0 or below.
struct FitParameter {
  std::string key;   ///< as --set takes it: "X.acceleration"
  std::string unit;  ///< of the key: "m/s2"
  double least = 0;  ///< allowed, in this unit
  double most = 0;
};

/// Those of a setup that can be asked for. Limits of the axes and settings that are numbers, not counts.
std::vector<FitParameter> fit_parameters(const Setup& setup);
/// Those that are looked for without being asked for: limits of the axes, and settings that have a unit and
/// are no sampling period; no jerk where the model limits none. Settings without a value in `setup` are no
/// part of them.
std::vector<FitParameter> usual_fit_parameters(const Setup& setup);
/// Those with these keys. Throws InputError with the nearest key.
std::vector<FitParameter> fit_parameters_of(const Setup& setup, const std::vector<std::string>& keys);

/// In the unit of the key; 0 where it has no value.
double fit_value(const Setup& setup, const FitParameter& parameter);
void set_fit_value(Setup& setup, const FitParameter& parameter, double value);

}  // namespace feedscope

#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "core/analysis/run.h"

namespace feedscope {

/// A number of a machine or of a control's settings that is to be found: never below 0.
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
/// Of the drive of a linear axis: position gain, velocity feed-forward, lag, in the order of
/// axis_drive_specs(). They are found from set and actual positions (drive_fit.h), not by simulations, and
/// are no part of fit_parameters(); feed-forward and lag can be 0.
constexpr std::size_t drive_parameter_count = 3;
/// Which of them are looked for, in the same order.
using FreeDriveNumbers = std::array<bool, drive_parameter_count>;
FitParameter drive_parameter(char axis, std::size_t i);
bool is_drive_parameter(const FitParameter& parameter);

/// Those of fit_parameters() and of the drives of X, Y and Z with these keys. Throws InputError with the
/// nearest key.
std::vector<FitParameter> fit_parameters_of(const Setup& setup, const std::vector<std::string>& keys);

/// In the unit of the key; 0 where it has no value.
double fit_value(const Setup& setup, const FitParameter& parameter);
void set_fit_value(Setup& setup, const FitParameter& parameter, double value);

}  // namespace feedscope

#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "core/analysis/run/run.h"

namespace feedscope {

/// A number of a machine or of a control's settings to be identified: never below 0.
struct FitParameter {
  std::string key;   ///< as for --set: "X.acceleration"
  std::string unit;  ///< of the key: "m/s2"
  double least = 0;  ///< permitted, in this unit
  double most = 0;
};

/// Possible parameters of a setup: limits of the axes and settings that are numbers, not counts.
std::vector<FitParameter> fit_parameters(const Setup& setup);
/// Default parameters: limits of the axes, and settings with a unit other than sampling periods; no jerk if
/// the model does not limit it. Excludes settings without a value in `setup`.
std::vector<FitParameter> usual_fit_parameters(const Setup& setup);
/// Drive of a linear axis: position gain, velocity feed-forward, lag, in the order of axis_drive_specs().
/// These are identified from set and actual positions (drive_fit.h), not by simulation, and are not in
/// fit_parameters(); feed-forward and lag can be 0.
constexpr std::size_t drive_parameter_count = 3;
/// Which of them are searched, in the same order.
using FreeDriveNumbers = std::array<bool, drive_parameter_count>;
FitParameter drive_parameter(char axis, std::size_t i);
bool is_drive_parameter(const FitParameter& parameter);

/// Parameters with these keys, from fit_parameters() and the drives of X, Y and Z. Throws InputError with the
/// nearest key.
std::vector<FitParameter> fit_parameters_of(const Setup& setup, const std::vector<std::string>& keys);

/// Value in the unit of the key; 0 if there is none.
double fit_value(const Setup& setup, const FitParameter& parameter);
void set_fit_value(Setup& setup, const FitParameter& parameter, double value);

}  // namespace feedscope

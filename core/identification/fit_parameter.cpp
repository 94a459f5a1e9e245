#include "core/identification/fit_parameter.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/base/nearest_name.h"
#include "core/machine/contour_tolerance.h"

namespace feedscope {
namespace {

constexpr double least_value = 1e-6;
constexpr double most_value = 1e6;

FitParameter parameter_of(const SettingSpec& spec, std::string key) {
  return {std::move(key), spec.unit, std::max({spec.minimum, spec.least_above_zero, least_value}),
          std::min(spec.maximum, most_value)};
}

bool is_number(const SettingSpec& spec) {
  return spec.choices.empty() && !spec.whole;
}

bool is_period(const SettingSpec& spec) {
  return spec.key.find("period") != std::string::npos;
}

bool is_of_machine(const SettingSpec& spec) {
  return std::ranges::any_of(machine_settings(),
                             [&](const SettingSpec& other) { return other.key == spec.key; });
}

/// The merging of blocks is no number of the motion.
bool can_be_fitted(const SettingSpec& spec) {
  return is_number(spec) && !is_of_machine(spec) && spec.key != merge_collinear_key;
}

}  // namespace

std::vector<FitParameter> fit_parameters(const Setup& setup) {
  std::vector<FitParameter> all;
  for (const auto& [axis, kind] : setup.machine.axes.axes()) {
    for (const SettingSpec& spec : axis_limit_specs()) {
      all.push_back(parameter_of(spec, fmt::format("{}.{}", axis, spec.key)));
    }
  }
  for (const SettingSpec& spec : settings_of(*setup.model)) {
    if (can_be_fitted(spec)) {
      all.push_back(parameter_of(spec, spec.key));
    }
  }
  return all;
}

std::vector<FitParameter> usual_fit_parameters(const Setup& setup) {
  std::vector<FitParameter> all = fit_parameters(setup);
  const bool limits_jerk = setup.model->guarantees(setup.settings).limits_jerk;
  std::erase_if(all, [&](const FitParameter& parameter) {
    if (parameter.key.find('.') != std::string::npos) {
      return !limits_jerk && parameter.key.ends_with("jerk");
    }
    SettingSpec spec;
    spec.key = parameter.key;
    // Zero has a special meaning, such as no limit, and is kept.
    return parameter.unit.empty() || is_period(spec) || !(fit_value(setup, parameter) > 0);
  });
  return all;
}

FitParameter drive_parameter(char axis, std::size_t i) {
  const SettingSpec& spec = axis_drive_specs()[i];
  return {fmt::format("{}.{}", axis, spec.key), spec.unit, spec.minimum, std::min(spec.maximum, most_value)};
}

bool is_drive_parameter(const FitParameter& parameter) {
  const auto dot = parameter.key.find('.');
  return dot != std::string::npos &&
         std::any_of(axis_drive_specs().begin(), axis_drive_specs().begin() + drive_parameter_count,
                     [&](const SettingSpec& spec) { return spec.key == parameter.key.substr(dot + 1); });
}

std::vector<FitParameter> fit_parameters_of(const Setup& setup, const std::vector<std::string>& keys) {
  std::vector<FitParameter> all = fit_parameters(setup);
  for (const auto& [axis, kind] : setup.machine.axes.axes()) {
    for (std::size_t i = 0; i < drive_parameter_count; ++i) {
      all.push_back(drive_parameter(axis, i));
    }
  }
  std::vector<std::string> known;
  for (const FitParameter& parameter : all) {
    known.push_back(parameter.key);
  }
  std::vector<FitParameter> chosen;
  for (const std::string& key : keys) {
    bool any = false;
    for (const FitParameter& parameter : all) {
      const bool of_every_axis = parameter.key.ends_with("." + key);  // "jerk": of X, Y and Z
      if ((parameter.key == key || of_every_axis) &&
          std::ranges::find(chosen, parameter.key, &FitParameter::key) == chosen.end()) {
        chosen.push_back(parameter);
      }
      any = any || parameter.key == key || of_every_axis;
    }
    if (!any) {
      const std::string nearest = nearest_name(key, known);
      throw InputError(message(
          NC_("core", "'{}' is no number of model '{}' that can be fitted; {}"), key, setup.model->info().id,
          nearest.empty() ? message(NC_("core", "known: {}"), fmt::to_string(fmt::join(known, ", ")))
                          : message(NC_("core", "did you mean '{}'?"), nearest)));
    }
  }
  return chosen;
}

double fit_value(const Setup& setup, const FitParameter& parameter) {
  const auto dot = parameter.key.find('.');
  if (dot != std::string::npos) {
    const SettingValue value =
        axis_value(setup.machine, parameter.key.front(), parameter.key.substr(dot + 1));
    const double* number = std::get_if<double>(&value);
    return number != nullptr ? *number : 0;
  }
  return setup.settings.has(parameter.key) ? setup.settings.number(parameter.key) : 0;
}

void set_fit_value(Setup& setup, const FitParameter& parameter, double value) {
  const double allowed = std::clamp(value, parameter.least, parameter.most);
  const auto dot = parameter.key.find('.');
  if (dot != std::string::npos) {
    set_axis_value(setup.machine, parameter.key.front(), parameter.key.substr(dot + 1), allowed);
  } else {
    setup.settings.set(parameter.key, allowed);
  }
}

}  // namespace feedscope

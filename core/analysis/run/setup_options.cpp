#include "core/analysis/run/setup_options.h"

#include <fmt/format.h>

#include "core/machine/contour_tolerance.h"

namespace feedscope {
namespace {

SettingValue value_of(const Setup& setup, const std::string& key) {
  const bool of_axis = key.size() > 2 && key[1] == '.';
  return of_axis ? axis_value(setup.machine, key[0], key.substr(2)) : setup.settings.value(key);
}

/// False for a key of an axis that the machine lacks.
bool has(const Setup& setup, const std::string& key) {
  const bool of_axis = key.size() > 2 && key[1] == '.';
  return !of_axis || axis_names(setup.machine).find(key[0]) != std::string::npos;
}

}  // namespace

std::string assignment_text(const std::string& key, const SettingValue& value) {
  return key + '=' +
         (std::holds_alternative<double>(value) ? fmt::format("{}", std::get<double>(value))
                                                : std::get<std::string>(value));
}

std::string setup_options(const Setup& setup) {
  SetupRequest request;
  request.machine = setup.machine.id;
  request.model = setup.model->info().id;
  const Setup file = make_setup(request);
  std::string text = "--machine " + request.machine;
  if (request.model != file.machine.model) {
    text += " --model " + request.model;
  }
  const auto differs = [&](const std::string& key) { return value_of(setup, key) != value_of(file, key); };
  const bool has_tolerance = setup.settings.has(contour_tolerance_key) &&
                             !follows_program_tolerance(setup.settings) &&
                             (differs(contour_tolerance_key) || differs(program_tolerance_key));
  if (has_tolerance) {
    text += fmt::format(" --tolerance {}", setup.settings.number(contour_tolerance_key));
  }
  for (const std::string& key : assignable_keys(*setup.model)) {
    const bool said = has_tolerance && (key == contour_tolerance_key || key == program_tolerance_key);
    if (!said && has(setup, key) && differs(key)) {
      text += " --set " + assignment_text(key, value_of(setup, key));
    }
  }
  return text;
}

}  // namespace feedscope

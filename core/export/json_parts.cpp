#include "core/export/json_parts.h"

#include <fmt/format.h>

#include <cmath>

#include "core/drives/drive_response.h"

namespace feedscope {

Json with_format(const char* kind) {
  constexpr int version = 1;
  return {{"format", {{"name", fmt::format("feedscope-{}", kind)}, {"version", version}}}};
}

Json finite(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json settings_values(const Settings& settings) {
  Json values = Json::object();
  for (const auto& [key, value] : settings.values()) {
    std::visit([&, &name = key](const auto& v) { values[name] = v; }, value);
  }
  return values;
}

Json drives_json(const Machine& machine) {
  if (!has_drives(machine)) {
    return nullptr;
  }
  Json axes = Json::object();
  for (std::size_t i = 0; i < machine.drives.size(); ++i) {
    Json values = Json::object();
    for (const SettingSpec& spec : axis_drive_specs()) {
      const SettingValue value = axis_value(machine, machine.drives.name(i), spec.key);
      if (const double* number = std::get_if<double>(&value)) {
        values[file_key(spec)] = *number;
      }
    }
    axes[std::string(1, machine.drives.name(i))] = std::move(values);
  }
  return {{"axes", std::move(axes)}};
}

std::string text_of(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace feedscope

#include "core/machine/kinematics_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/base/error.h"
#include "core/machine/sourced_value.h"

namespace feedscope {
namespace {

constexpr std::array direction_keys{"x", "y", "z"};
constexpr std::array point_keys{"x_mm", "y_mm", "z_mm"};
constexpr const char* tool_length_key = "tool_length_mm";
constexpr double farthest_point = 1e6;  // [mm]

std::string table_name(char axis) {
  return fmt::format("[kinematics.{}]", axis);
}

RotaryAxis read_limits(const ConfigNode& table, char name, Machine& machine) {
  RotaryAxis axis;
  axis.name = name;
  const std::string where = fmt::format("[axes.{}]", name);
  std::vector<std::string> keys;
  for (const SettingSpec& spec : rotary_axis_specs()) {
    keys.push_back(file_key(spec));
  }
  table.check_keys(keys, where);
  for (std::size_t i = 0; i < rotary_axis_specs().size(); ++i) {
    SettingSpec spec = rotary_axis_specs()[i];
    const std::string key = fmt::format("{}.{}", name, spec.key);
    spec.key = file_key(spec);
    if (!spec.optional || table.find(spec.key) != nullptr) {
      set_rotary_value(axis, i, read_sourced_value(table, spec, where, machine.provenance[key]));
    }
  }
  return axis;
}

/// Reads a direction or a point, with its source.
Vec3 read_place(const ConfigNode& table, const char* key, const std::array<const char*, 3>& keys, char axis,
                Machine& machine) {
  const std::string where = table_name(axis);
  const std::string name = fmt::format("'{}' in {}", key, where);
  const ConfigNode& entry = table.need_table(key, where);
  entry.check_keys({keys[0], keys[1], keys[2], "source", "assumed"}, name);
  machine.provenance[fmt::format("kinematics.{}.{}", axis, key)] = read_provenance(entry, name);
  return read_vector(entry, keys, farthest_point, name);
}

}  // namespace

std::vector<std::string> rotary_tables(const ConfigNode& root) {
  std::vector<std::string> names;
  for (const std::string& key : root.need_table("axes", the_file).keys()) {
    if (key.size() == 1 && rotary_names.find(key[0]) != std::string_view::npos) {
      names.push_back(key);
    }
  }
  return names;
}

void read_kinematics(const ConfigNode& root, Machine& machine) {
  const std::vector<std::string> names = rotary_tables(root);
  if (root.find("kinematics") == nullptr) {
    if (!names.empty()) {
      root.need_table("axes", the_file)
          .need_table(names.front(), "[axes]")
          .fail(message(NC_("core",
                            "axis {} is a rotary axis, and the file does not say where it is; add "
                            "[kinematics] with its chain, and {} with direction and point"),
                        names.front(), table_name(names.front()[0])));
    }
    return;
  }
  const ConfigNode& table = root.need_table("kinematics", the_file);
  std::vector<std::string> keys{"chain", tool_length_key};
  keys.insert(keys.end(), names.begin(), names.end());
  for (const std::string& key : table.keys()) {
    if (key.size() == 1 && rotary_names.find(key[0]) != std::string_view::npos &&
        std::ranges::find(names, key) == names.end()) {
      table.fail(message(NC_("core", "{} has no limits; add [axes.{}]"), table_name(key[0]), key));
    }
  }
  table.check_keys(keys, "[kinematics]");
  MachineKinematics& kinematics = machine.kinematics;
  for (const std::string& name : names) {
    const char letter = name[0];
    RotaryAxis axis =
        read_limits(root.need_table("axes", the_file).need_table(name, "[axes]"), letter, machine);
    const ConfigNode& own = table.need_table(name, "[kinematics]");
    own.check_keys({"direction", "point"}, table_name(letter));
    axis.direction = read_place(own, "direction", direction_keys, letter, machine);
    axis.point = read_place(own, "point", point_keys, letter, machine);
    kinematics.rotary.push_back(axis);
  }
  if (table.find(tool_length_key) != nullptr) {
    SettingSpec spec{.key = tool_length_key, .maximum = farthest_point};
    kinematics.tool_length = std::get<double>(
        read_sourced_value(table, spec, "[kinematics]", machine.provenance["kinematics.tool_length"]));
  }
  const ConfigNode& chain = table.need_table("chain", "[kinematics]");
  chain.check_keys({"value", "source", "assumed"}, "'chain' in [kinematics]");
  machine.provenance["kinematics.chain"] = read_provenance(chain, "'chain' in [kinematics]");
  kinematics.chain = chain.need_text("value", "'chain' in [kinematics]");
  try {
    chain_of(kinematics);
  } catch (const InputError& error) {
    chain.fail(error.message());
  }
}

std::string write_rotary_axes(const Machine& machine) {
  std::string out;
  for (const RotaryAxis& axis : machine.kinematics.rotary) {
    out += fmt::format("\n[axes.{}]\n", axis.name);
    for (std::size_t i = 0; i < rotary_axis_specs().size(); ++i) {
      const SettingSpec& spec = rotary_axis_specs()[i];
      const SettingValue value = rotary_value(axis, i);
      if (value != SettingValue(std::string())) {
        out += toml_entry(machine, file_key(spec), fmt::format("{}.{}", axis.name, spec.key), value);
      }
    }
  }
  return out;
}

std::string write_kinematics(const Machine& machine) {
  if (machine.kinematics.empty()) {
    return "";
  }
  std::string out =
      "\n[kinematics]\n" + toml_entry(machine, "chain", "kinematics.chain", machine.kinematics.chain);
  if (machine.kinematics.tool_length) {
    out += toml_entry(machine, tool_length_key, "kinematics.tool_length", *machine.kinematics.tool_length);
  }
  for (const RotaryAxis& axis : machine.kinematics.rotary) {
    const std::string key = fmt::format("kinematics.{}.", axis.name);
    out += fmt::format("\n[kinematics.{}]\ndirection = {{ x = {}, y = {}, z = {}, {} }}\n", axis.name,
                       axis.direction.x(), axis.direction.y(), axis.direction.z(),
                       toml_provenance(machine, key + "direction"));
    out += fmt::format("point = {{ x_mm = {}, y_mm = {}, z_mm = {}, {} }}\n", axis.point.x(), axis.point.y(),
                       axis.point.z(), toml_provenance(machine, key + "point"));
  }
  return out;
}

}  // namespace feedscope

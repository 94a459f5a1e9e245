#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "core/base/geometry.h"
#include "core/machine/config_file.h"
#include "core/machine/kinematics_file.h"
#include "core/machine/machine.h"
#include "core/machine/sourced_value.h"

namespace feedscope {
namespace {

constexpr std::array offset_keys{"x_mm", "y_mm", "z_mm"};
constexpr double farthest_offset = 1e6;  // [mm]

class MachineReader {
 public:
  explicit MachineReader(const std::vector<SettingSpec>& model_settings) : settings_(common_settings()) {
    for (const SettingSpec& spec : model_settings) {
      if (spec.key == "model") {
        model_ = spec;
      } else {
        settings_.push_back(spec);
      }
    }
  }

  Machine read(const ConfigNode& root) {
    root.check_keys(
        {"id", "name", "control", "reference", "model", "axes", "settings", "work_offsets", "kinematics"},
        the_file);
    machine_.id = root.need_text("id", the_file);
    machine_.name = root.need_text("name", the_file);
    machine_.control = root.need_text("control", the_file);
    machine_.reference = root.need_text("reference", the_file);
    machine_.model = root.need_text("model", the_file);
    if (model_) {
      check_setting(*model_, machine_.model, root.need("model", the_file).place());
    }
    read_axes(root);
    read_settings(root);
    read_work_offsets(root);
    read_kinematics(root, machine_);
    return std::move(machine_);
  }

 private:
  /// Reads a value and stores its source under `provenance_key`.
  SettingValue value(const ConfigNode& table, const SettingSpec& spec, const std::string& where,
                     const std::string& provenance_key) {
    return read_sourced_value(table, spec, where, machine_.provenance[provenance_key]);
  }

  void read_axes(const ConfigNode& root) {
    const ConfigNode& axes = root.need_table("axes", the_file);
    std::vector<std::string> names;
    for (const AxisInfo& axis : known_axes) {
      names.emplace_back(1, axis.name);
    }
    const std::vector<std::string> rotary = rotary_tables(root);
    names.insert(names.end(), rotary.begin(), rotary.end());
    axes.check_keys(names, "[axes]");
    for (const auto& [axis, kind] : machine_.axes.axes()) {
      const ConfigNode& table = axes.need_table(std::string(1, axis), "[axes]");
      const std::string where = fmt::format("[axes.{}]", axis);
      std::vector<std::string> keys;
      for (const SettingSpec& spec : axis_specs()) {
        keys.push_back(file_key(spec));
      }
      table.check_keys(keys, where);
      for (const SettingSpec& known : axis_specs()) {
        SettingSpec spec = known;
        spec.key = file_key(known);
        if (known.optional && table.find(spec.key) == nullptr) {
          continue;
        }
        const std::string provenance_key = fmt::format("{}.{}", axis, known.key);
        const SettingValue number = value(table, spec, where, provenance_key);
        const Provenance provenance = machine_.provenance[provenance_key];
        set_axis_value(machine_, axis, known.key, number);
        machine_.provenance[provenance_key] = provenance;
      }
      const Message problem = drive_problem(*machine_.drives.find(axis), axis);
      if (!problem.empty()) {
        table.fail(problem);
      }
    }
  }

  void read_settings(const ConfigNode& root) {
    const ConfigNode& table = root.need_table("settings", the_file);
    std::vector<std::string> keys;
    for (const SettingSpec& spec : settings_) {
      keys.push_back(spec.key);
    }
    table.check_keys(keys, "[settings]");
    for (const SettingSpec& spec : settings_) {
      if (table.find(spec.key) != nullptr) {
        machine_.settings.set(spec.key, value(table, spec, "[settings]", spec.key));
      }
    }
  }

  /// Reads G55 = { x_mm = 100, y_mm = 0, z_mm = 0, source = "..." }; the table is optional.
  void read_work_offsets(const ConfigNode& root) {
    if (root.find("work_offsets") == nullptr) {
      return;
    }
    const ConfigNode& table = root.need_table("work_offsets", the_file);
    for (const std::string& key : table.keys()) {
      const ConfigNode& entry = table.need_table(key, "[work_offsets]");
      const std::string name = fmt::format("'{}' in [work_offsets]", key);
      if (WorkOffsets::key(key).empty()) {
        entry.fail(message(
            NC_("core",
                "{} is not a work offset; write it as programs name it, such as G55, \"G54.1 P3\" or G505"),
            name));
      }
      if (machine_.work_offsets.all().contains(WorkOffsets::key(key))) {
        entry.fail(message(NC_("core", "{} is given twice; remove one"), name));
      }
      entry.check_keys({"x_mm", "y_mm", "z_mm", "source", "assumed"}, name);
      machine_.provenance[WorkOffsets::key(key)] = read_provenance(entry, name);
      machine_.work_offsets.set(key, read_vector(entry, offset_keys, farthest_offset, name));
    }
  }

  std::vector<SettingSpec> settings_;
  std::optional<SettingSpec> model_;
  Machine machine_;
};

}  // namespace

std::string file_key(const SettingSpec& spec) {
  std::string unit = spec.unit;
  std::replace(unit.begin(), unit.end(), '/', '_');
  return unit.empty() ? spec.key : spec.key + "_" + unit;
}

Machine read_machine(const std::filesystem::path& file, const std::vector<SettingSpec>& model_settings) {
  return MachineReader(model_settings).read(read_config_file(file, NC_("core", "machine file")));
}

Machine parse_machine(const std::string& text, const std::string& name,
                      const std::vector<SettingSpec>& model_settings) {
  return MachineReader(model_settings).read(parse_config(text, name));
}

std::string write_machine(const Machine& machine) {
  std::string out;
  out += fmt::format("id = {}\nname = {}\ncontrol = {}\nreference = {}\nmodel = {}\n", toml_text(machine.id),
                     toml_text(machine.name), toml_text(machine.control), toml_text(machine.reference),
                     toml_text(machine.model));
  for (const auto& [axis, kind] : machine.axes.axes()) {
    out += fmt::format("\n[axes.{}]\n", axis);
    for (const SettingSpec& spec : axis_specs()) {
      const SettingValue value = axis_value(machine, axis, spec.key);
      if (value != SettingValue(std::string())) {
        out += toml_entry(machine, file_key(spec), fmt::format("{}.{}", axis, spec.key), value);
      }
    }
  }
  out += write_rotary_axes(machine);
  out += "\n[settings]\n";
  for (const auto& [key, value] : machine.settings.values()) {
    out += toml_entry(machine, key, key, value);
  }
  out += machine.work_offsets.empty() ? "" : "\n[work_offsets]\n";
  for (const auto& [name, zero] : machine.work_offsets.all()) {
    out += fmt::format("{} = {{ x_mm = {}, y_mm = {}, z_mm = {}, {} }}\n", toml_text(name), zero.x(),
                       zero.y(), zero.z(), toml_provenance(machine, name));
  }
  out += write_kinematics(machine);
  return out;
}

}  // namespace feedscope

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <optional>
#include <sstream>

#include "core/base/geometry.h"
#include "core/machine/config_file.h"
#include "core/machine/machine.h"

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
    root.check_keys({"id", "name", "control", "reference", "model", "axes", "settings", "work_offsets"},
                    "the file");
    machine_.id = root.need_text("id", "the file");
    machine_.name = root.need_text("name", "the file");
    machine_.control = root.need_text("control", "the file");
    machine_.reference = root.need_text("reference", "the file");
    machine_.model = root.need_text("model", "the file");
    if (model_) {
      check_setting(*model_, machine_.model, root.need("model", "the file").place());
    }
    read_axes(root);
    read_settings(root);
    read_work_offsets(root);
    return std::move(machine_);
  }

 private:
  /// Reads { value = ..., source = "..." } and notes the source under `provenance_key`.
  SettingValue value(const ConfigNode& table, const SettingSpec& spec, const std::string& where,
                     const std::string& provenance_key) {
    const std::string name = fmt::format("'{}' in {}", spec.key, where);
    const ConfigNode& entry = table.need(spec.key, where);
    if (entry.kind() != ConfigNode::Kind::table) {
      entry.fail(
          fmt::format("{} needs a source: write {{ value = ..., source = \"paper, table\" }} or {{ value = "
                      "..., assumed = \"reason\" }}",
                      name));
    }
    entry.check_keys({"value", "source", "assumed"}, name);
    machine_.provenance[provenance_key] = provenance(entry, name);

    const ConfigNode& given = entry.need("value", name);
    SettingValue result;
    if (given.is_text()) {
      result = given.text();
    } else if (given.is_number()) {
      result = given.number();
    } else {
      given.fail(fmt::format("value of {} must be a number{}", name, spec.choices.empty() ? "" : " or text"));
    }
    check_setting(spec, result, given.place());
    return result;
  }

  static Provenance provenance(const ConfigNode& entry, const std::string& name) {
    const bool assumed = entry.find("assumed") != nullptr;
    if (assumed == (entry.find("source") != nullptr)) {
      entry.fail(fmt::format("{} must have one of source = \"paper, table\" and assumed = \"reason\"", name));
    }
    return {entry.need_text(assumed ? "assumed" : "source", name), assumed};
  }

  void read_axes(const ConfigNode& root) {
    const ConfigNode& axes = root.need_table("axes", "the file");
    std::vector<std::string> names;
    for (const AxisInfo& axis : known_axes) {
      names.emplace_back(1, axis.name);
    }
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
      const std::string problem = drive_problem(*machine_.drives.find(axis), axis);
      if (!problem.empty()) {
        table.fail(problem);
      }
    }
  }

  void read_settings(const ConfigNode& root) {
    const ConfigNode& table = root.need_table("settings", "the file");
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

  /// G55 = { x_mm = 100, y_mm = 0, z_mm = 0, source = "..." }; the table may be missing.
  void read_work_offsets(const ConfigNode& root) {
    if (root.find("work_offsets") == nullptr) {
      return;
    }
    const ConfigNode& table = root.need_table("work_offsets", "the file");
    for (const std::string& key : table.keys()) {
      const ConfigNode& entry = table.need_table(key, "[work_offsets]");
      const std::string name = fmt::format("'{}' in [work_offsets]", key);
      if (WorkOffsets::key(key).empty()) {
        entry.fail(
            fmt::format("{} is not a work offset; write it as programs name it, such as G55, "
                        "\"G54.1 P3\" or G505",
                        name));
      }
      if (machine_.work_offsets.all().contains(WorkOffsets::key(key))) {
        entry.fail(fmt::format("{} is given twice; remove one", name));
      }
      entry.check_keys({"x_mm", "y_mm", "z_mm", "source", "assumed"}, name);
      machine_.provenance[WorkOffsets::key(key)] = provenance(entry, name);
      Vec3 zero;
      for (int axis = 0; axis < 3; ++axis) {
        SettingSpec spec;
        spec.key = offset_keys[static_cast<std::size_t>(axis)];
        spec.minimum = -farthest_offset;
        spec.maximum = farthest_offset;
        spec.minimum_allowed = true;
        const ConfigNode& given = entry.need(spec.key, name);
        if (!given.is_number()) {
          given.fail(fmt::format("{} of {} must be a number", spec.key, name));
        }
        check_setting(spec, given.number(), given.place());
        zero[axis] = given.number();
      }
      machine_.work_offsets.set(key, zero);
    }
  }

  std::vector<SettingSpec> settings_;
  std::optional<SettingSpec> model_;
  Machine machine_;
};

std::string in_quotes(const std::string& text) {
  std::ostringstream out;
  out << toml::toml_formatter{toml::value<std::string>(text), toml::format_flags::allow_unicode_strings};
  return out.str();
}

/// source = "paper, table"
std::string provenance_text(const Machine& machine, const std::string& key) {
  const auto found = machine.provenance.find(key);
  const Provenance provenance =
      found != machine.provenance.end() ? found->second : Provenance{"set by hand", false};
  return fmt::format("{} = {}", provenance.assumed ? "assumed" : "source", in_quotes(provenance.source));
}

std::string entry(const Machine& machine, const std::string& key, const std::string& provenance_key,
                  const SettingValue& value) {
  const double* number = std::get_if<double>(&value);
  return fmt::format("{} = {{ value = {}, {} }}\n", key,
                     number != nullptr ? fmt::format("{}", *number) : in_quotes(std::get<std::string>(value)),
                     provenance_text(machine, provenance_key));
}

}  // namespace

std::string file_key(const SettingSpec& spec) {
  std::string unit = spec.unit;
  std::replace(unit.begin(), unit.end(), '/', '_');
  return unit.empty() ? spec.key : spec.key + "_" + unit;
}

Machine read_machine(const std::filesystem::path& file, const std::vector<SettingSpec>& model_settings) {
  return MachineReader(model_settings).read(read_config_file(file, "machine file"));
}

Machine parse_machine(const std::string& text, const std::string& name,
                      const std::vector<SettingSpec>& model_settings) {
  return MachineReader(model_settings).read(parse_config(text, name));
}

std::string write_machine(const Machine& machine) {
  std::string out;
  out += fmt::format("id = {}\nname = {}\ncontrol = {}\nreference = {}\nmodel = {}\n", in_quotes(machine.id),
                     in_quotes(machine.name), in_quotes(machine.control), in_quotes(machine.reference),
                     in_quotes(machine.model));
  for (const auto& [axis, kind] : machine.axes.axes()) {
    out += fmt::format("\n[axes.{}]\n", axis);
    for (const SettingSpec& spec : axis_specs()) {
      const SettingValue value = axis_value(machine, axis, spec.key);
      if (value != SettingValue(std::string())) {
        out += entry(machine, file_key(spec), fmt::format("{}.{}", axis, spec.key), value);
      }
    }
  }
  out += "\n[settings]\n";
  for (const auto& [key, value] : machine.settings.values()) {
    out += entry(machine, key, key, value);
  }
  out += machine.work_offsets.empty() ? "" : "\n[work_offsets]\n";
  for (const auto& [name, zero] : machine.work_offsets.all()) {
    out += fmt::format("{} = {{ x_mm = {}, y_mm = {}, z_mm = {}, {} }}\n", in_quotes(name), zero.x(),
                       zero.y(), zero.z(), provenance_text(machine, name));
  }
  return out;
}

}  // namespace feedscope

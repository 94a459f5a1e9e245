#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <sstream>

#include "core/base/error.h"
#include "core/base/geometry.h"
#include "core/machine/machine.h"

namespace feedscope {
namespace {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;

constexpr std::streamsize largest_file = 1 << 20;  // bytes; a machine file is a few thousand

/// "velocity" in m/min is "velocity_m_min" in a file.
std::string file_key(const SettingSpec& limit) {
  std::string unit = limit.unit;
  std::replace(unit.begin(), unit.end(), '/', '_');
  return limit.key + "_" + unit;
}

std::string read_text(const fs::path& file) {
  std::error_code ignored;
  if (fs::is_directory(file, ignored)) {
    throw InputError(fmt::format("'{}' is a folder; give a machine file", file.string()));
  }
  std::ifstream in(file, std::ios::binary);
  if (!in) {
    throw InputError(fmt::format("cannot read machine file '{}': {}", file.string(),
                                 std::generic_category().message(errno)));
  }
  std::string text(static_cast<std::size_t>(largest_file) + 1, '\0');
  in.read(text.data(), largest_file + 1);
  if (in.gcount() > largest_file) {
    throw InputError(fmt::format("'{}' is larger than 1 MiB; that is no machine file", file.string()));
  }
  text.resize(static_cast<std::size_t>(in.gcount()));
  return text;
}

class MachineReader {
 public:
  MachineReader(std::string file, const std::vector<SettingSpec>& model_settings)
      : file_(std::move(file)), settings_(common_settings()) {
    settings_.insert(settings_.end(), model_settings.begin(), model_settings.end());
  }

  Machine read(const toml::table& root) {
    check_keys(root, {"id", "name", "control", "reference", "model", "axes", "settings"}, "the file");
    machine_.id = text(root, "id", "the file");
    machine_.name = text(root, "name", "the file");
    machine_.control = text(root, "control", "the file");
    machine_.reference = text(root, "reference", "the file");
    machine_.model = text(root, "model", "the file");
    read_axes(root);
    read_settings(root);
    return std::move(machine_);
  }

  std::string place(const toml::source_region& region) const {
    return fmt::format("{}:{}:{}", file_, region.begin.line, region.begin.column);
  }

 private:
  [[noreturn]] void fail(const toml::source_region& region, const std::string& message) const {
    throw InputError(fmt::format("{}: {}", place(region), message));
  }

  void check_keys(const toml::table& table, const Names& known, const std::string& where) const {
    for (const auto& [key, node] : table) {
      const std::string name(key.str());
      if (std::find(known.begin(), known.end(), name) == known.end()) {
        const std::string nearest = nearest_name(name, known);
        fail(key.source(), fmt::format("unknown key '{}' in {}; {}", name, where,
                                       nearest.empty() ? fmt::format("known: {}", fmt::join(known, ", "))
                                                       : fmt::format("did you mean '{}'?", nearest)));
      }
    }
  }

  const toml::node& need(const toml::table& table, const std::string& key, const std::string& where) const {
    const toml::node* node = table.get(key);
    if (node == nullptr) {
      fail(table.source(), fmt::format("key '{}' is missing in {}", key, where));
    }
    return *node;
  }

  const toml::table& need_table(const toml::table& table, const std::string& key,
                                const std::string& where) const {
    const toml::node& node = need(table, key, where);
    const toml::table* inner = node.as_table();
    if (inner == nullptr) {
      fail(node.source(), fmt::format("'{}' in {} must be a table", key, where));
    }
    return *inner;
  }

  std::string text(const toml::table& table, const std::string& key, const std::string& where) const {
    const toml::node& node = need(table, key, where);
    const auto* value = node.as_string();
    if (value == nullptr || value->get().empty()) {
      fail(node.source(), fmt::format("'{}' in {} must be a text in quotes", key, where));
    }
    return value->get();
  }

  /// Reads { value = ..., source = "..." } and notes the source under `provenance_key`.
  SettingValue value(const toml::table& table, const SettingSpec& spec, const std::string& where,
                     const std::string& provenance_key) {
    const std::string name = fmt::format("'{}' in {}", spec.key, where);
    const toml::node& node = need(table, spec.key, where);
    const toml::table* entry = node.as_table();
    if (entry == nullptr) {
      fail(node.source(),
           fmt::format("{} must say where it comes from: write {{ value = ..., source = \"paper, "
                       "table\" }} or {{ value = ..., assumed = \"reason\" }}",
                       name));
    }
    check_keys(*entry, {"value", "source", "assumed"}, name);
    const bool assumed = entry->contains("assumed");
    if (assumed == entry->contains("source")) {
      fail(node.source(),
           fmt::format("{} must have one of source = \"paper, table\" and assumed = \"reason\"", name));
    }
    machine_.provenance[provenance_key] = {text(*entry, assumed ? "assumed" : "source", name), assumed};

    const toml::node& given = need(*entry, "value", name);
    SettingValue result;
    if (const auto* words = given.as_string()) {
      result = words->get();
    } else if (given.is_number()) {
      result = *given.value<double>();
    } else {
      fail(given.source(),
           fmt::format("value of {} must be a number{}", name, spec.choices.empty() ? "" : " or text"));
    }
    check_setting(spec, result, place(given.source()));
    return result;
  }

  void read_axes(const toml::table& root) {
    const toml::table& axes = need_table(root, "axes", "the file");
    check_keys(axes, {"X", "Y", "Z"}, "[axes]");
    for (const char axis : axis_names) {
      const toml::table& table = need_table(axes, std::string(1, axis), "[axes]");
      const std::string where = fmt::format("[axes.{}]", axis);
      Names keys;
      for (const SettingSpec& spec : axis_limit_specs()) {
        keys.push_back(file_key(spec));
      }
      check_keys(table, keys, where);
      for (const SettingSpec& limit : axis_limit_specs()) {
        SettingSpec spec = limit;
        spec.key = file_key(limit);
        const std::string provenance_key = fmt::format("{}.{}", axis, limit.key);
        const SettingValue number = value(table, spec, where, provenance_key);
        const Provenance provenance = machine_.provenance[provenance_key];
        set_axis_limit(machine_, axis, limit.key, std::get<double>(number));
        machine_.provenance[provenance_key] = provenance;
      }
    }
  }

  void read_settings(const toml::table& root) {
    const toml::table& table = need_table(root, "settings", "the file");
    Names keys;
    for (const SettingSpec& spec : settings_) {
      keys.push_back(spec.key);
    }
    check_keys(table, keys, "[settings]");
    for (const SettingSpec& spec : settings_) {
      if (table.contains(spec.key)) {
        machine_.settings.set(spec.key, value(table, spec, "[settings]", spec.key));
      }
    }
  }

  std::string file_;
  std::vector<SettingSpec> settings_;
  Machine machine_;
};

std::string quoted(const std::string& text) {
  std::ostringstream out;
  out << toml::toml_formatter{toml::value<std::string>(text), toml::format_flags::allow_unicode_strings};
  return out.str();
}

std::string entry(const Machine& machine, const std::string& key, const std::string& provenance_key,
                  const SettingValue& value) {
  const auto found = machine.provenance.find(provenance_key);
  const Provenance provenance =
      found != machine.provenance.end() ? found->second : Provenance{"set by hand", true};
  const double* number = std::get_if<double>(&value);
  return fmt::format("{} = {{ value = {}, {} = {} }}\n", key,
                     number != nullptr ? fmt::format("{}", *number) : quoted(std::get<std::string>(value)),
                     provenance.assumed ? "assumed" : "source", quoted(provenance.source));
}

}  // namespace

Machine read_machine(const fs::path& file, const std::vector<SettingSpec>& model_settings) {
  const std::string text = read_text(file);
  MachineReader reader(file.string(), model_settings);
  try {
    return reader.read(toml::parse(text, file.string()));
  } catch (const toml::parse_error& error) {
    throw InputError(fmt::format("{}: no TOML: {}", reader.place(error.source()), error.description()));
  }
}

std::string write_machine(const Machine& machine) {
  std::string out;
  out += fmt::format("id = {}\nname = {}\ncontrol = {}\nreference = {}\nmodel = {}\n", quoted(machine.id),
                     quoted(machine.name), quoted(machine.control), quoted(machine.reference),
                     quoted(machine.model));
  for (const char axis : axis_names) {
    out += fmt::format("\n[axes.{}]\n", axis);
    for (const SettingSpec& limit : axis_limit_specs()) {
      out += entry(machine, file_key(limit), fmt::format("{}.{}", axis, limit.key),
                   axis_limit(machine, axis, limit.key));
    }
  }
  out += "\n[settings]\n";
  for (const auto& [key, value] : machine.settings.values()) {
    out += entry(machine, key, key, value);
  }
  return out;
}

}  // namespace feedscope

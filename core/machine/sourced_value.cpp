#include "core/machine/sourced_value.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <sstream>

#include "core/machine/key_unit.h"

namespace feedscope {

Provenance read_provenance(const ConfigNode& entry, const std::string& name) {
  const bool assumed = entry.find("assumed") != nullptr;
  if (assumed == (entry.find("source") != nullptr)) {
    entry.fail(
        message(NC_("core", "{} must have one of source = \"paper, table\" and assumed = \"reason\""), name));
  }
  return {entry.need_text(assumed ? "assumed" : "source", name), assumed};
}

SettingValue read_sourced_value(const ConfigNode& table, const SettingSpec& spec, const std::string& where,
                                Provenance& provenance) {
  const std::string name = fmt::format("'{}' in {}", spec.key, where);
  const ConfigNode& entry = table.need(spec.key, where);
  if (entry.kind() != ConfigNode::Kind::table) {
    entry.fail(message(NC_("core",
                           "{} needs a source: write {{ value = ..., source = \"paper, table\" }} or {{ "
                           "value = ..., assumed = \"reason\" }}"),
                       name));
  }
  entry.check_keys({"value", "source", "assumed"}, name);
  provenance = read_provenance(entry, name);

  const ConfigNode& given = entry.need("value", name);
  SettingValue result;
  if (given.is_text()) {
    const TypedNumber number = spec.choices.empty() ? typed_in_unit(given.text(), spec.unit) : TypedNumber();
    if (!number.problem.empty()) {
      given.fail(message(NC_("core", "{} = '{}': {}"), name, given.text(), number.problem));
    }
    result = number.value ? SettingValue(*number.value) : SettingValue(given.text());
  } else if (given.is_number()) {
    result = given.number();
  } else {
    given.fail(spec.choices.empty() ? message(NC_("core", "value of {} must be a number"), name)
                                    : message(NC_("core", "value of {} must be a number or text"), name));
  }
  check_setting(spec, result, given.place());
  return result;
}

Vec3 read_vector(const ConfigNode& entry, const std::array<const char*, 3>& keys, double most,
                 const std::string& name) {
  Vec3 vector;
  for (int axis = 0; axis < 3; ++axis) {
    SettingSpec spec{.key = keys[static_cast<std::size_t>(axis)],
                     .minimum = -most,
                     .maximum = most,
                     .minimum_allowed = true};
    const ConfigNode& given = entry.need(spec.key, name);
    if (!given.is_number()) {
      given.fail(message(NC_("core", "{} of {} must be a number"), spec.key, name));
    }
    check_setting(spec, given.number(), given.place());
    vector[axis] = given.number();
  }
  return vector;
}

std::string toml_text(const std::string& text) {
  std::ostringstream out;
  out << toml::toml_formatter{toml::value<std::string>(text), toml::format_flags::allow_unicode_strings};
  return out.str();
}

std::string toml_provenance(const Machine& machine, const std::string& key) {
  const auto found = machine.provenance.find(key);
  const Provenance provenance =
      found != machine.provenance.end() ? found->second : Provenance{"set by hand", false};
  return fmt::format("{} = {}", provenance.assumed ? "assumed" : "source", toml_text(provenance.source));
}

std::string toml_entry(const Machine& machine, const std::string& key, const std::string& provenance_key,
                       const SettingValue& value) {
  const double* number = std::get_if<double>(&value);
  return fmt::format("{} = {{ value = {}, {} }}\n", key,
                     number != nullptr ? fmt::format("{}", *number) : toml_text(std::get<std::string>(value)),
                     toml_provenance(machine, provenance_key));
}

}  // namespace feedscope

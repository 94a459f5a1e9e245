#include "core/machine/import/linuxcnc_kinematics.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <sstream>
#include <vector>

#include "core/base/error.h"
#include "core/base/units.h"

namespace feedscope {
namespace {

std::vector<std::string> words_of(std::string_view text) {
  std::istringstream stream{std::string(text)};
  std::vector<std::string> words;
  for (std::string word; stream >> word;) {
    if (word != "=>" && word != "<=" && word != "<=>" && word != "=") {
      words.push_back(word);
    }
  }
  return words;
}

constexpr double degrees_a_turn = 360;
constexpr double seconds_a_minute = 60;

/// Words of a HAL command; none for other entries.
std::vector<std::string> words_of_command(const SectionEntry& entry) {
  return entry.section == "HAL" && entry.key == "HALCMD" ? words_of(entry.value) : std::vector<std::string>();
}

}  // namespace

bool LinuxCncKinematics::read() {
  const SectionEntry* kins = file_.find("KINS", "KINEMATICS");
  const std::vector<std::string> words = words_of(kins == nullptr ? "" : kins->value);
  if (words.empty() || (words[0] != "xyzac-trt-kins" && words[0] != "xyzbc-trt-kins")) {
    return false;
  }
  component_ = words[0];
  const bool tilts_about_x = component_ == "xyzac-trt-kins";
  const char tilting = tilts_about_x ? 'A' : 'B';
  const Pin across = length(tilts_about_x ? "y-offset" : "x-offset");
  const Pin above = length("z-offset");
  std::vector<std::string> sources;
  Vec3 turn = Vec3::Zero();
  for (int i = 0; i < 3; ++i) {
    const Pin place = length(fmt::format("{}-rot-point", "xyz"[i]));
    turn[i] = place.value;
    if (!place.what.empty()) {
      sources.push_back(place.what);
    }
  }
  Vec3 tilt = turn;
  tilt[tilts_about_x ? 1 : 0] += across.value;
  tilt.z() += above.value;
  const auto joined = [](const std::vector<std::string>& texts) {
    std::string all;
    for (const std::string& text : texts) {
      all += (all.empty() ? "" : "; ") + text;
    }
    return all;
  };
  std::string of_turn = joined(sources);
  for (const Pin& offset : {across, above}) {
    if (!offset.what.empty()) {
      sources.push_back(offset.what);
    }
  }
  const std::string of_tilt = joined(sources);
  if (of_tilt.empty()) {
    draft_.note(Severity::warning, kins->place, "not-modelled",
                message(NC_("core", "the offsets of {} are not in the INI file; 0 is assumed"), component_),
                NC_("core", "write them into the machine file: [kinematics], 'point' of each axis"));
  }
  MachineKinematics& kinematics = draft_.machine().kinematics;
  kinematics.chain = fmt::format("C {} X Y frame Z", tilting);
  draft_.machine().provenance["kinematics.chain"] = {
      fmt::format("{}: {}; which linear axes carry the table is assumed", draft_.place_text(kins->place),
                  kins->given().what),
      false};
  // Newer releases have a pin that reverses the sense of rotation.
  counts_the_table_ = !is_on("conventional-directions");
  const double sign = counts_the_table_ ? -1 : 1;
  add_axis(tilting, tilts_about_x ? Vec3(sign, 0, 0) : Vec3(0, sign, 0), tilt, of_tilt);
  add_axis('C', Vec3(0, 0, sign), turn, of_turn);
  return true;
}

/// Command "setp COMPONENT.PIN 5", or "net SIGNAL COMPONENT.PIN" and "sets SIGNAL 5"; the last one applies.
/// Null if there is none.
const SectionEntry* LinuxCncKinematics::command_for(const std::string& pin) const {
  const std::string full = component_ + "." + pin;
  std::string signal;
  for (const SectionEntry& entry : file_.entries()) {
    const std::vector<std::string> words = words_of_command(entry);
    if (words.size() > 2 && words[0] == "net" && std::ranges::find(words, full) != words.end()) {
      signal = words[1];
    }
  }
  const SectionEntry* found = nullptr;
  for (const SectionEntry& entry : file_.entries()) {
    const std::vector<std::string> words = words_of_command(entry);
    if (words.size() == 3 && ((words[0] == "setp" && words[1] == full) ||
                              (words[0] == "sets" && !signal.empty() && words[1] == signal))) {
      found = &entry;
    }
  }
  return found;
}

LinuxCncKinematics::Pin LinuxCncKinematics::length(const std::string& pin) {
  const SectionEntry* command = command_for(pin);
  if (command == nullptr) {
    return {};
  }
  const std::string text = words_of_command(*command).back();
  const std::optional<double> value = draft_.number(text, command->given());
  return value ? Pin{*value * unit_, fmt::format("{}: {} {} = {} {}", draft_.place_text(command->place),
                                                 component_, pin, text, unit_name_)}
               : Pin();
}

bool LinuxCncKinematics::is_on(const std::string& pin) const {
  const SectionEntry* command = command_for(pin);
  const std::string text = command == nullptr ? "" : in_upper_case(words_of_command(*command).back());
  return text == "1" || text == "TRUE";
}

void LinuxCncKinematics::add_axis(char name, const Vec3& direction, const Vec3& point,
                                  const std::string& source) {
  constexpr double usual_velocity = 60;       // [deg/s]
  constexpr double usual_acceleration = 300;  // [deg/s2]
  constexpr double least_rise = 0.005;        // [s] to reach an acceleration without a jerk limit
  Machine& machine = draft_.machine();
  RotaryAxis axis;
  axis.name = name;
  axis.direction = direction;
  axis.point = point;
  give_limit(axis, "velocity", "MAX_VELOCITY", "deg/s", usual_velocity, degrees_a_turn / seconds_a_minute);
  give_limit(axis, "acceleration", "MAX_ACCELERATION", "deg/s2", usual_acceleration, degrees_a_turn);
  set(axis, "jerk", units::to_turns(axis.acceleration) / least_rise,
      {"LinuxCNC limits no jerk: for other models, so high that it hardly limits", true});
  give_travel(axis, "minimum", "MIN_LIMIT");
  give_travel(axis, "maximum", "MAX_LIMIT");
  machine.provenance[fmt::format("kinematics.{}.direction", name)] = {
      counts_the_table_ ? fmt::format("{}: it counts how the table turns", component_)
                        : fmt::format("{}: conventional-directions is set", component_),
      false};
  machine.provenance[fmt::format("kinematics.{}.point", name)] = {
      source.empty() ? fmt::format("{} gives no offsets", draft_.file()) : source, source.empty()};
  machine.kinematics.rotary.push_back(axis);
}

/// Sets `value` in the unit of the key; returns false, with a note, if it is out of bounds.
bool LinuxCncKinematics::set(RotaryAxis& axis, const char* key, double value, const Provenance& source,
                             const ConfigurationPlace& place) {
  const std::vector<SettingSpec>& specs = rotary_axis_specs();
  const auto spec = std::ranges::find(specs, key, &SettingSpec::key);
  try {
    set_rotary_value(axis, static_cast<std::size_t>(spec - specs.begin()), value);
  } catch (const InputError& error) {
    draft_.note(Severity::error, place, "limit-out-of-bounds",
                message(NC_("core", "{} of axis {} cannot be used: {}"), std::string_view(key), axis.name,
                        error.message()),
                NC_("core", "correct the file of the control; until then the value is assumed"));
    return false;
  }
  draft_.machine().provenance[fmt::format("{}.{}", axis.name, key)] = source;
  return true;
}

/// `per_unit`: degrees of the file per unit of the key.
void LinuxCncKinematics::give_limit(RotaryAxis& axis, const char* key, const char* name, const char* unit,
                                    double usual, double per_unit) {
  const std::string section = fmt::format("AXIS_{}", axis.name);
  const SectionEntry* entry = file_.find(section, name);
  const std::optional<double> value =
      entry == nullptr ? std::nullopt : draft_.number(entry->value, entry->given(unit));
  if (value && set(axis, key, *value / per_unit,
                   {fmt::format("{}: {}", draft_.place_text(entry->place), entry->given(unit).what), false},
                   entry->place)) {
    return;
  }
  if (entry == nullptr) {
    draft_.note(
        Severity::warning, file_.place_of(section), "limit-missing",
        message(NC_("core", "{} of axis {} is missing; it is assumed"), std::string_view(name), axis.name),
        message(NC_("core", "write {} into [{}]"), std::string_view(name), section));
  }
  set(axis, key, usual / per_unit,
      {fmt::format("{} does not give it: usual of such machines", draft_.file()), true});
}

/// None if the file has none: the axis turns without end.
void LinuxCncKinematics::give_travel(RotaryAxis& axis, const char* key, const char* name) {
  const SectionEntry* entry = file_.find(fmt::format("AXIS_{}", axis.name), name);
  const std::optional<double> value =
      entry == nullptr ? std::nullopt : draft_.number(entry->value, entry->given("deg"));
  if (value) {
    set(axis, key, *value,
        {fmt::format("{}: {}", draft_.place_text(entry->place), entry->given("deg").what), false},
        entry->place);
  }
}

}  // namespace feedscope

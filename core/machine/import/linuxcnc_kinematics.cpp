#include "core/machine/import/linuxcnc_kinematics.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <sstream>
#include <vector>

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

bool is_hal_command(const SectionEntry& entry) {
  return entry.section == "HAL" && entry.key == "HALCMD";
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
  const Pin across = pin(tilts_about_x ? "y-offset" : "x-offset");
  const Pin above = pin("z-offset");
  std::vector<std::string> sources;
  Vec3 turn = Vec3::Zero();
  for (int i = 0; i < 3; ++i) {
    const Pin place = pin(fmt::format("{}-rot-point", "xyz"[i]));
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
                fmt::format("the offsets of {} are not in the INI file; 0 is assumed", component_),
                "write them into the machine file: [kinematics], 'point' of each axis");
  }
  MachineKinematics& kinematics = draft_.machine().kinematics;
  kinematics.chain = fmt::format("C {} X Y frame Z", tilting);
  draft_.machine().provenance["kinematics.chain"] = {
      fmt::format("{}: {}; which linear axes carry the table is assumed", draft_.place_text(kins->place),
                  kins->given().what),
      false};
  add_axis(tilting, tilts_about_x ? Vec3(-Vec3::UnitX()) : Vec3(-Vec3::UnitY()), tilt, of_tilt);
  add_axis('C', -Vec3::UnitZ(), turn, of_turn);
  return true;
}

/// "setp COMPONENT.PIN 5", or "net SIGNAL COMPONENT.PIN" and "sets SIGNAL 5"; the last one holds.
LinuxCncKinematics::Pin LinuxCncKinematics::pin(const std::string& name) {
  const std::string full = component_ + "." + name;
  std::string signal;
  for (const SectionEntry& entry : file_.entries()) {
    const std::vector<std::string> words = is_hal_command(entry) ? words_of(entry.value) : words_of("");
    if (words.size() > 2 && words[0] == "net" && std::ranges::find(words, full) != words.end()) {
      signal = words[1];
    }
  }
  Pin found;
  for (const SectionEntry& entry : file_.entries()) {
    const std::vector<std::string> words = is_hal_command(entry) ? words_of(entry.value) : words_of("");
    const bool sets = words.size() == 3 && ((words[0] == "setp" && words[1] == full) ||
                                            (words[0] == "sets" && !signal.empty() && words[1] == signal));
    if (!sets) {
      continue;
    }
    if (const std::optional<double> value = draft_.number(words[2], entry.given())) {
      found = {*value * unit_, fmt::format("{}: {} {} = {} {}", draft_.place_text(entry.place), component_,
                                           name, words[2], unit_name_)};
    }
  }
  return found;
}

void LinuxCncKinematics::add_axis(char name, const Vec3& direction, const Vec3& point,
                                  const std::string& source) {
  constexpr double usual_velocity = 60;       // [deg/s]
  constexpr double usual_acceleration = 300;  // [deg/s2]
  constexpr double least_rise = 0.005;        // [s] in which an acceleration is reached that no jerk limits
  Machine& machine = draft_.machine();
  RotaryAxis axis;
  axis.name = name;
  axis.direction = direction;
  axis.point = point;
  give_limit(axis, &RotaryAxis::velocity, "velocity", "MAX_VELOCITY", "deg/s", usual_velocity);
  give_limit(axis, &RotaryAxis::acceleration, "acceleration", "MAX_ACCELERATION", "deg/s2",
             usual_acceleration);
  axis.jerk = axis.acceleration / least_rise;
  machine.provenance[fmt::format("{}.jerk", name)] = {
      "LinuxCNC limits no jerk: for other models, so high that it hardly limits", true};
  give_travel(axis, &RotaryAxis::minimum, "minimum", "MIN_LIMIT");
  give_travel(axis, &RotaryAxis::maximum, "maximum", "MAX_LIMIT");
  machine.provenance[fmt::format("kinematics.{}.direction", name)] = {
      fmt::format("{}: it counts how the table turns", component_), false};
  machine.provenance[fmt::format("kinematics.{}.point", name)] = {
      source.empty() ? fmt::format("{} gives no offsets", draft_.file()) : source, source.empty()};
  machine.kinematics.rotary.push_back(axis);
}

void LinuxCncKinematics::give_limit(RotaryAxis& axis, double RotaryAxis::*limit, const char* key,
                                    const char* name, const char* unit, double usual) {
  const std::string section = fmt::format("AXIS_{}", axis.name);
  Provenance& source = draft_.machine().provenance[fmt::format("{}.{}", axis.name, key)];
  if (const SectionEntry* entry = file_.find(section, name)) {
    const GivenValue given = entry->given(unit);
    const std::optional<double> value = draft_.number(entry->value, given);
    if (value && *value > 0) {
      axis.*limit = units::from_deg(*value);
      source = {fmt::format("{}: {}", draft_.place_text(given.place), given.what), false};
      return;
    }
  }
  draft_.note(Severity::warning, file_.place_of(section), "limit-missing",
              fmt::format("{} of axis {} is missing; it is assumed", name, axis.name),
              fmt::format("write {} into [{}]", name, section));
  axis.*limit = units::from_deg(usual);
  source = {fmt::format("{} does not give it: usual of such machines", draft_.file()), true};
}

/// None where the file gives none: the axis turns without end.
void LinuxCncKinematics::give_travel(RotaryAxis& axis, std::optional<double> RotaryAxis::*end,
                                     const char* key, const char* name) {
  const SectionEntry* entry = file_.find(fmt::format("AXIS_{}", axis.name), name);
  if (entry == nullptr) {
    return;
  }
  const GivenValue given = entry->given("deg");
  if (const std::optional<double> value = draft_.number(entry->value, given)) {
    axis.*end = units::from_deg(*value);
    draft_.machine().provenance[fmt::format("{}.{}", axis.name, key)] = {
        fmt::format("{}: {}", draft_.place_text(given.place), given.what), false};
  }
}

}  // namespace feedscope

#include "core/machine/machine.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/geometry.h"
#include "core/base/nearest_name.h"
#include "core/base/translatable.h"
#include "core/base/units.h"
#include "core/machine/key_unit.h"
#include "core/machine/limit_spec.h"

namespace feedscope {
namespace {

struct LimitField {
  double AxisLimits::*member;
  KeyConversion conversion;
};

/// In the order of axis_limit_specs().
constexpr std::array<LimitField, 4> limit_fields{{
    {&AxisLimits::velocity, {units::from_m_min, units::to_m_min}},
    {&AxisLimits::acceleration, {units::from_m, units::to_m}},
    {&AxisLimits::jerk, {units::from_m, units::to_m}},
    {&AxisLimits::blend_jerk, {units::from_m, units::to_m}},
}};

/// Axes as text: "X, Y and Z".
Message list_of(std::string_view axes) {
  std::vector<Message> names;
  for (const char axis : axes) {
    names.push_back(Message::as_written(std::string(1, axis)));
  }
  return listed(names);
}

void check_axis(const Machine& machine, char axis) {
  if (!machine.axes.axes().find(axis) && machine.kinematics.find(axis) == nullptr) {
    throw InputError(
        message(NC_("core", "unknown axis '{}'; the axes are {}"), axis, list_of(axis_names(machine))));
  }
}

/// Index of `key` in `specs`.
std::size_t place_of(const std::vector<SettingSpec>& specs, char axis, std::string_view key) {
  std::vector<std::string> keys;
  for (const SettingSpec& spec : specs) {
    keys.push_back(spec.key);
  }
  const auto found = std::find(keys.begin(), keys.end(), key);
  if (found == keys.end()) {
    const std::string nearest = nearest_name(key, keys);
    throw InputError(message(
        NC_("core", "unknown limit '{}' of axis {}; {}"), key, axis,
        nearest.empty() ? message(NC_("core", "the limits are {}"), fmt::to_string(fmt::join(keys, ", ")))
                        : message(NC_("core", "did you mean '{}'?"), nearest)));
  }
  return static_cast<std::size_t>(found - keys.begin());
}

SettingSpec spec_of_axis(const SettingSpec& spec, char axis) {
  SettingSpec named = spec;
  named.key = fmt::format("{}.{}", axis, spec.key);
  return named;
}

/// `drives` for these axes; axes without one follow exactly.
AxisVector<AxisDrive> for_axes(const AxisVector<AxisDrive>& drives, const AxisList& axes) {
  AxisVector<AxisDrive> all(axes);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (const AxisDrive* drive = drives.find(all.name(i))) {
      all[i] = *drive;
    }
  }
  return all;
}

void note_set_by_hand(Machine& machine, const std::string& key) {
  machine.provenance.insert_or_assign(key, Provenance{"set by hand", false});
}

/// Sets a limit or an end of the travel of a rotary axis that the machine has.
void set_rotary(Machine& machine, char axis, std::string_view key, const SettingValue& value) {
  const std::size_t place = place_of(rotary_axis_specs(), axis, key);
  RotaryAxis& target = *std::ranges::find(machine.kinematics.rotary, axis, &RotaryAxis::name);
  if (value == rotary_value(target, place)) {
    return;
  }
  set_rotary_value(target, place, value);
  const std::string full_key = fmt::format("{}.{}", axis, key);
  if (std::holds_alternative<double>(value)) {
    note_set_by_hand(machine, full_key);
  } else {
    machine.provenance.erase(full_key);
  }
}

}  // namespace

const std::vector<SettingSpec>& axis_limit_specs() {
  static const std::vector<SettingSpec> specs{
      limit_spec(
          "velocity", QT_TRANSLATE_NOOP("core", "Velocity"), "m/min",
          QT_TRANSLATE_NOOP(
              "core",
              "Maximum velocity of this axis; rapids run at the speed at which the first axis reaches it.")),
      limit_spec("acceleration", QT_TRANSLATE_NOOP("core", "Acceleration"), "m/s2",
                 QT_TRANSLATE_NOOP("core",
                                   "Maximum acceleration of this axis, along and across the path combined.")),
      limit_spec(
          "jerk", QT_TRANSLATE_NOOP("core", "Jerk"), "m/s3",
          QT_TRANSLATE_NOOP("core",
                            "Maximum rate of change of acceleration on programmed lines and arcs; small "
                            "values are gentle on the machine and cost most time on short blocks.")),
      limit_spec(
          "blend_jerk", QT_TRANSLATE_NOOP("core", "Jerk on blends"), "m/s3",
          QT_TRANSLATE_NOOP(
              "core",
              "Maximum rate of change of acceleration on the corner blends that the control inserts.")),
  };
  return specs;
}

double axis_limit(const Machine& machine, char axis, std::string_view limit) {
  check_axis(machine, axis);
  if (const RotaryAxis* rotary = machine.kinematics.find(axis)) {
    return std::get<double>(rotary_value(*rotary, place_of(rotary_axis_specs(), axis, limit)));
  }
  const LimitField& field = limit_fields[place_of(axis_limit_specs(), axis, limit)];
  return shortest_in_unit(machine.axes.find(axis)->*field.member, field.conversion);
}

void set_axis_limit(Machine& machine, char axis, std::string_view limit, double value) {
  check_axis(machine, axis);
  if (machine.kinematics.find(axis) != nullptr) {
    set_rotary(machine, axis, limit, value);
    return;
  }
  const std::size_t place = place_of(axis_limit_specs(), axis, limit);
  const SettingSpec spec = spec_of_axis(axis_limit_specs()[place], axis);
  check_setting(spec, value, "");
  double& target = machine.axes[*machine.axes.axes().find(axis)].*limit_fields[place].member;
  const double internal = limit_fields[place].conversion.to_internal(value);
  if (target != internal) {
    target = internal;
    note_set_by_hand(machine, spec.key);
  }
}

const std::vector<SettingSpec>& axis_specs() {
  static const std::vector<SettingSpec> specs = [] {
    std::vector<SettingSpec> all = axis_limit_specs();
    all.insert(all.end(), axis_drive_specs().begin(), axis_drive_specs().end());
    return all;
  }();
  return specs;
}

std::string axis_names(const Machine& machine) {
  std::string names;
  for (const AxisInfo& axis : machine.axes.axes()) {
    names += axis.name;
  }
  for (const RotaryAxis& axis : machine.kinematics.rotary) {
    names += axis.name;
  }
  return names;
}

const std::vector<SettingSpec>& axis_specs_of(char axis) {
  return rotary_names.find(axis) == std::string_view::npos ? axis_specs() : rotary_axis_specs();
}

SettingValue axis_value(const Machine& machine, char axis, std::string_view key) {
  check_axis(machine, axis);
  if (const RotaryAxis* rotary = machine.kinematics.find(axis)) {
    return rotary_value(*rotary, place_of(rotary_axis_specs(), axis, key));
  }
  const std::size_t limits = axis_limit_specs().size();
  const std::size_t place = place_of(axis_specs(), axis, key);
  if (place < limits) {
    return axis_limit(machine, axis, key);
  }
  const AxisDrive* drive = machine.drives.find(axis);
  return drive_value(drive == nullptr ? AxisDrive() : *drive, place - limits);
}

void set_axis_value(Machine& machine, char axis, std::string_view key, const SettingValue& value) {
  check_axis(machine, axis);
  if (machine.kinematics.find(axis) != nullptr) {
    set_rotary(machine, axis, key, value);
    return;
  }
  const std::size_t limits = axis_limit_specs().size();
  const std::size_t place = place_of(axis_specs(), axis, key);
  const SettingSpec spec = spec_of_axis(axis_specs()[place], axis);
  check_setting(spec, value, "");
  if (place < limits) {
    set_axis_limit(machine, axis, key, std::get<double>(value));
    return;
  }
  if (value == axis_value(machine, axis, key)) {
    return;
  }
  machine.drives = for_axes(machine.drives, machine.axes.axes());
  set_drive_value(machine.drives[*machine.drives.axes().find(axis)], place - limits, value);
  if (std::holds_alternative<double>(value)) {
    note_set_by_hand(machine, spec.key);
  } else {
    machine.provenance.erase(spec.key);
  }
}

void check_drives(const Machine& machine) {
  for (std::size_t i = 0; i < machine.drives.size(); ++i) {
    const Message problem = drive_problem(machine.drives[i], machine.drives.name(i));
    if (!problem.empty()) {
      throw InputError(message(NC_("core", "machine '{}': {}"), machine.id, problem));
    }
  }
}

}  // namespace feedscope

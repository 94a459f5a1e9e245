#include "core/machine/axis_drive.h"

#include <array>
#include <cmath>
#include <numbers>

#include "core/base/translatable.h"
#include "core/base/units.h"
#include "core/machine/key_unit.h"

namespace feedscope {
namespace {

struct DriveField {
  std::optional<double> AxisDrive::*member;
  KeyConversion conversion;
};

constexpr KeyConversion none{units::as_it_is, units::as_it_is};
constexpr KeyConversion milliseconds{units::from_ms, units::to_ms};
constexpr KeyConversion micrometres{units::from_um, units::to_um};

/// In the order of axis_drive_specs().
constexpr std::array<DriveField, 8> drive_fields{{
    {&AxisDrive::gain, none},
    {&AxisDrive::feedforward, none},
    {&AxisDrive::lag, milliseconds},
    {&AxisDrive::backlash, micrometres},
    {&AxisDrive::backlash_compensation, none},
    {&AxisDrive::friction_spike, micrometres},
    {&AxisDrive::friction_time, milliseconds},
    {&AxisDrive::steps_per_mm, none},
}};

SettingSpec drive_spec(std::string key, std::string title, std::string unit, double minimum, double maximum,
                       std::string explanation) {
  return {
      .key = std::move(key),
      .title = std::move(title),
      .unit = std::move(unit),
      .explanation = std::move(explanation),
      .minimum = minimum,
      .maximum = maximum,
      .optional = true,
  };
}

}  // namespace

const std::vector<SettingSpec>& axis_drive_specs() {
  // Bounds far beyond any drive: gains are 10 to 200 1/s, lags 1 to 20 ms, backlash and spikes some um.
  static const std::vector<SettingSpec> specs{
      drive_spec("kv", QT_TRANSLATE_NOOP("core", "Position gain Kv"), "1/s", 0.1, 1e5,
                 QT_TRANSLATE_NOOP("core",
                                   "Velocity that the position loop of the axis asks for, over the following "
                                   "error: without feed-forward the axis stays v/Kv behind. Without a value "
                                   "the axis follows its set values exactly.")),
      drive_spec("velocity_feedforward", QT_TRANSLATE_NOOP("core", "Velocity feed-forward"), "", 0, 1,
                 QT_TRANSLATE_NOOP("core",
                                   "Share of the set velocity that the position loop adds to its own; with 1 "
                                   "there is no following error at constant velocity.")),
      drive_spec("velocity_lag", QT_TRANSLATE_NOOP("core", "Lag of the velocity loop"), "ms", 0, 1000,
                 QT_TRANSLATE_NOOP("core",
                                   "Time constant with which the velocity loop of the axis reaches the "
                                   "velocity asked for; with feed-forward it makes circles grow with "
                                   "acceleration.")),
      drive_spec("backlash", QT_TRANSLATE_NOOP("core", "Backlash"), "um", 0, 1e4,
                 QT_TRANSLATE_NOOP("core",
                                   "Distance that the motor of the axis turns back at a reversal before the "
                                   "slide moves.")),
      drive_spec("backlash_compensation", QT_TRANSLATE_NOOP("core", "Backlash compensation"), "", 0, 1,
                 QT_TRANSLATE_NOOP("core", "Share of the backlash that the control makes up for.")),
      drive_spec("friction_spike", QT_TRANSLATE_NOOP("core", "Friction spike"), "um", 0, 1e4,
                 QT_TRANSLATE_NOOP("core",
                                   "Distance by which friction holds the axis back when it reverses; on a "
                                   "circle it shows as a spike where quadrants change.")),
      drive_spec("friction_time", QT_TRANSLATE_NOOP("core", "Decay of the friction spike"), "ms", 0.01, 1e4,
                 QT_TRANSLATE_NOOP("core", "Time constant with which the friction spike decays.")),
      drive_spec(
          "steps_per_mm", QT_TRANSLATE_NOOP("core", "Step resolution"), "", 0.01, 1e6,
          QT_TRANSLATE_NOOP("core",
                            "Steps of the motor over 1 mm of the axis: controls of stepper motors round "
                            "the ends of blocks to whole steps. Without a value they are not rounded.")),
  };
  return specs;
}

SettingValue drive_value(const AxisDrive& drive, std::size_t i) {
  const DriveField& field = drive_fields[i];
  const std::optional<double>& value = drive.*field.member;
  return value ? SettingValue(shortest_in_unit(*value, field.conversion)) : SettingValue(std::string());
}

void set_drive_value(AxisDrive& drive, std::size_t i, const SettingValue& value) {
  check_setting(axis_drive_specs()[i], value, "");
  const DriveField& field = drive_fields[i];
  const double* number = std::get_if<double>(&value);
  drive.*field.member =
      number != nullptr ? std::optional(field.conversion.to_internal(*number)) : std::nullopt;
}

Message drive_problem(const AxisDrive& drive, char axis) {
  const bool has_others = drive.feedforward || drive.lag || drive.backlash || drive.backlash_compensation ||
                          drive.friction_spike || drive.friction_time;
  if (drive.follows_exactly() && has_others) {
    return message(
        NC_("core",
            "axis {} has values of a drive but no position gain; give {}.kv in 1/s, or remove the others"),
        axis, axis);
  }
  if (drive.friction_spike.value_or(0) > 0 && !drive.friction_time) {
    return message(
        NC_("core",
            "axis {} has a friction spike but no time in which it decays; give {}.friction_time in ms"),
        axis, axis);
  }
  return {};
}

double drive_overshoot(const AxisDrive& drive) {
  const double product = drive.gain.value_or(0) * drive.lag.value_or(0);
  const double damping = product > 0 ? 1 / (2 * std::sqrt(product)) : 1;
  return damping < 1 ? std::exp(-std::numbers::pi * damping / std::sqrt(1 - damping * damping)) : 0;
}

}  // namespace feedscope

#include "core/models/klipper/klipper_model.h"

#include <algorithm>

#include "core/base/translatable.h"
#include "core/base/units.h"
#include "core/models/control_reading.h"
#include "core/models/klipper/klipper_reading.h"
#include "core/models/klipper/klipper_run.h"

namespace feedscope {
namespace {

SettingSpec setting(const char* key, const char* title, const char* unit, double minimum, double maximum,
                    const char* explanation) {
  SettingSpec spec;
  spec.key = key;
  spec.title = title;
  spec.unit = unit;
  spec.minimum = minimum;
  spec.maximum = maximum;
  spec.explanation = explanation;
  spec.optional = true;
  return spec;
}

std::vector<SettingSpec> own_settings() {
  std::vector<SettingSpec> specs{
      setting(
          "max_velocity_m_min", QT_TRANSLATE_NOOP("core", "Maximum velocity"), "m/min", 1e-6, 1e9,
          QT_TRANSLATE_NOOP("core",
                            "max_velocity of Klipper: of the tool along the path. Without a value the least "
                            "of the axes.")),
      setting(
          "max_acceleration_m_s2", QT_TRANSLATE_NOOP("core", "Maximum acceleration"), "m/s2", 1e-6, 1e9,
          QT_TRANSLATE_NOOP("core",
                            "max_accel of Klipper: of the tool along the path. Without a value the least of "
                            "the axes.")),
      setting("square_corner_velocity_mm_s", QT_TRANSLATE_NOOP("core", "Square corner velocity"), "mm/s", 0,
              1e6,
              QT_TRANSLATE_NOOP("core",
                                "Speed at which the tool may pass a corner of 90 degrees; other corners "
                                "accordingly.")),
      setting(
          "minimum_cruise_ratio", QT_TRANSLATE_NOOP("core", "Minimum cruise ratio"), "", 0, 0.999,
          QT_TRANSLATE_NOOP("core",
                            "Part of a way between two slow places that is left for constant speed, so that "
                            "short zigzags do not accelerate all the time.")),
      setting("arc_resolution_mm", QT_TRANSLATE_NOOP("core", "Arc resolution"), "mm", 1e-3, 1e6,
              QT_TRANSLATE_NOOP("core", "Length of the chords that arcs are cut into.")),
      setting("max_z_velocity_m_min", QT_TRANSLATE_NOOP("core", "Maximum velocity of Z"), "m/min", 1e-6, 1e9,
              QT_TRANSLATE_NOOP("core", "Without a value that along the path.")),
      setting("max_z_acceleration_m_s2", QT_TRANSLATE_NOOP("core", "Maximum acceleration of Z"), "m/s2", 1e-6,
              1e9, QT_TRANSLATE_NOOP("core", "Without a value that along the path.")),
  };
  const auto give = [&](std::size_t i, double value) {
    specs[i].optional = false;
    specs[i].fallback = value;
  };
  give(2, 5);
  give(3, 0.5);
  give(4, 1);
  specs.push_back(refuse_setting());
  return specs;
}

double least(const Machine& machine, double AxisLimits::*limit) {
  double value = std::numeric_limits<double>::infinity();
  for (const AxisLimits& axis : machine.axes) {
    if (axis.*limit > 0) {
      value = std::min(value, axis.*limit);
    }
  }
  return value;
}

}  // namespace

KlipperSettings::KlipperSettings(const Machine& machine, const Settings& settings)
    : square_corner_velocity(settings.number("square_corner_velocity_mm_s")),
      minimum_cruise_ratio(settings.number("minimum_cruise_ratio")),
      arc_resolution(settings.number("arc_resolution_mm")) {
  const auto given = [&](const char* key, double (*from)(double), double otherwise) {
    return settings.has(key) ? from(settings.number(key)) : otherwise;
  };
  max_velocity = given("max_velocity_m_min", units::from_m_min, least(machine, &AxisLimits::velocity));
  max_acceleration = given("max_acceleration_m_s2", units::from_m, least(machine, &AxisLimits::acceleration));
  max_z_velocity = given("max_z_velocity_m_min", units::from_m_min, max_velocity);
  max_z_acceleration = given("max_z_acceleration_m_s2", units::from_m, max_acceleration);
}

const ModelInfo& KlipperModel::info() const {
  static const ModelInfo info{
      "klipper",
      QT_TRANSLATE_NOOP("core", "Open control Klipper"),
      "Klipper of 2025, rebuilt from a description of its look-ahead and compared with results of its own "
      "code",
      QT_TRANSLATE_NOOP(
          "core",
          "Velocity and acceleration are limited along the path; corners are passed as they are programmed, "
          "at a "
          "speed that the square corner velocity sets, without any limit of the jerk. The look-ahead has no "
          "end, "
          "and a part of every way is kept for constant speed. Every line must begin with its command."),
      own_settings(),
      {},
      {QT_TRANSLATE_NOOP("core", "No jerk is limited, and in corners the velocity of an axis jumps."),
       QT_TRANSLATE_NOOP("core",
                         "Rapids are lines at the feed in force; those of a program that is run as it is "
                         "meant run at the maximum velocity.")},
      {.jumps_in_corners = true,
       .along_path = true,
       .sources = {{FormulaId::square_corner, "Klipper, square corner velocity"},
                   {FormulaId::corner_within_blocks, "Klipper, corner within half of each block"},
                   {FormulaId::braking_evenly, "Klipper, constant acceleration"},
                   {FormulaId::path_velocity, "Klipper, max_velocity"},
                   {FormulaId::level_acceleration, "Klipper, max_accel"},
                   {FormulaId::path_acceleration, "Klipper, max_z_accel"},
                   {FormulaId::axis_velocity, "Klipper, max_z_velocity"}}}};
  return info;
}

Guarantees KlipperModel::guarantees(const Settings&) const {
  Guarantees promised;
  promised.meets_tangent_ends = false;
  promised.stops_at_rapids = promised.stops_at_reversals = false;
  promised.rapids_of_axes = promised.limits_jerk = false;
  promised.arcs_are_chords = true;
  promised.begins_again_at_stops = false;  // where the path turns back it stands still, but plans across
  return promised;
}

ControlReading KlipperModel::do_read(const std::shared_ptr<const Toolpath>& toolpath,
                                     const Settings& settings) const {
  if (settings.text("refuse") == "off") {
    return {toolpath, {}};
  }
  return reading_of(read_as_klipper(toolpath->source), *toolpath);
}

Trajectory KlipperModel::do_simulate(const std::shared_ptr<const Toolpath>& toolpath, const Machine& machine,
                                     const Settings& settings, Progress* progress) const {
  return KlipperRun(toolpath, machine, KlipperSettings(machine, settings)).run(progress);
}

}  // namespace feedscope

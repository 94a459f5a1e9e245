#include "core/program/controls/klipper_settings.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/units.h"

namespace feedscope {
namespace {

double least_limit(const Machine& machine, double AxisLimits::*limit) {
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
  max_velocity = given("max_velocity_m_min", units::from_m_min, least_limit(machine, &AxisLimits::velocity));
  max_acceleration =
      given("max_acceleration_m_s2", units::from_m, least_limit(machine, &AxisLimits::acceleration));
  max_z_velocity = given("max_z_velocity_m_min", units::from_m_min, max_velocity);
  max_z_acceleration = given("max_z_acceleration_m_s2", units::from_m, max_acceleration);
  const double share = extrude_only_share(0.4, 1.75);
  max_extrude_velocity = given("max_extrude_velocity_mm_s", units::as_it_is, share * max_velocity);
  max_extrude_acceleration = given("max_extrude_acceleration_m_s2", units::from_m, share * max_acceleration);
}

double KlipperSettings::extrude_time(double length, double feed) const {
  const double cruise = max_acceleration * (1 - minimum_cruise_ratio);
  const double most = std::min(feed, max_extrude_velocity);
  const double speed = std::min(most, std::sqrt(length * std::min(max_extrude_acceleration, cruise)));
  return length / speed + speed / max_extrude_acceleration;
}

double extrude_only_share(double nozzle, double filament) {
  return 4 * nozzle * nozzle / (units::pi / 4 * filament * filament);
}

}  // namespace feedscope

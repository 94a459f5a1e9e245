#include "core/machine/machine.h"

#include <fast_float/fast_float.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/geometry.h"
#include "core/base/nearest_name.h"
#include "core/base/translatable.h"
#include "core/base/units.h"

namespace feedscope {
namespace {

struct LimitField {
  double AxisLimits::*member;
  double (*to_internal)(double);
  double (*to_unit)(double);
};

/// In the order of axis_limit_specs().
constexpr std::array<LimitField, 4> limit_fields{{
    {&AxisLimits::velocity, units::from_m_min, units::to_m_min},
    {&AxisLimits::acceleration, units::from_m, units::to_m},
    {&AxisLimits::jerk, units::from_m, units::to_m},
    {&AxisLimits::blend_jerk, units::from_m, units::to_m},
}};

SettingSpec limit_spec(std::string key, std::string title, std::string unit, std::string explanation) {
  SettingSpec spec;
  spec.key = std::move(key);
  spec.title = std::move(title);
  spec.unit = std::move(unit);
  spec.explanation = std::move(explanation);
  // Far beyond any machine; further out the units of the models overflow.
  spec.minimum = 1e-6;
  spec.maximum = 1e9;
  return spec;
}

struct LimitPlace {
  std::size_t axis;
  std::size_t limit;
};

/// "X, Y and Z".
std::string list_of(const AxisList& axes) {
  std::string list;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    list += i == 0 ? "" : i + 1 == axes.size() ? " and " : ", ";
    list += axes[i].name;
  }
  return list;
}

LimitPlace place_of(const AxisList& axes, char axis, std::string_view limit) {
  const auto found_axis = axes.find(axis);
  if (!found_axis) {
    throw InputError(fmt::format("unknown axis '{}'; the axes are {}", axis, list_of(axes)));
  }
  std::vector<std::string> keys;
  for (const SettingSpec& spec : axis_limit_specs()) {
    keys.push_back(spec.key);
  }
  const auto found = std::find(keys.begin(), keys.end(), limit);
  if (found == keys.end()) {
    const std::string nearest = nearest_name(limit, keys);
    throw InputError(fmt::format("unknown limit '{}' of axis {}; {}", limit, axis,
                                 nearest.empty() ? fmt::format("the limits are {}", fmt::join(keys, ", "))
                                                 : fmt::format("did you mean '{}'?", nearest)));
  }
  return {*found_axis, static_cast<std::size_t>(found - keys.begin())};
}

/// The shortest decimal number that converts to exactly `internal`: 20, not 20.000000000000004.
double shortest_in_unit(double internal, const LimitField& field) {
  const double plain = field.to_unit(internal);
  for (int digits = 1; digits <= 16; ++digits) {
    const std::string text = fmt::format("{:.{}g}", plain, digits);
    double rounded = 0;
    fast_float::from_chars(text.data(), text.data() + text.size(), rounded);
    if (field.to_internal(rounded) == internal) {
      return rounded;
    }
  }
  // Converting there and back may miss by one unit in the last place.
  for (const double neighbour : {std::nextafter(plain, 0.0), std::nextafter(plain, 2 * plain)}) {
    if (field.to_internal(neighbour) == internal) {
      return neighbour;
    }
  }
  return plain;
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
  const LimitPlace place = place_of(machine.axes.axes(), axis, limit);
  const LimitField& field = limit_fields[place.limit];
  return shortest_in_unit(machine.axes[place.axis].*field.member, field);
}

void set_axis_limit(Machine& machine, char axis, std::string_view limit, double value) {
  const LimitPlace place = place_of(machine.axes.axes(), axis, limit);
  SettingSpec spec = axis_limit_specs()[place.limit];
  spec.key = fmt::format("{}.{}", axis, limit);
  check_setting(spec, value, "");
  double& target = machine.axes[place.axis].*limit_fields[place.limit].member;
  const double internal = limit_fields[place.limit].to_internal(value);
  if (target != internal) {
    target = internal;
    machine.provenance.insert_or_assign(spec.key, Provenance{"set by hand", false});
  }
}

}  // namespace feedscope

#include "core/machine/rotary_axis.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "core/base/error.h"
#include "core/base/translatable.h"
#include "core/base/units.h"
#include "core/machine/key_unit.h"
#include "core/machine/limit_spec.h"

namespace feedscope {
namespace {

constexpr std::string_view frame_word = "frame";

constexpr std::array<KeyConversion, 5> rotary_conversions{{
    {units::from_turns_min, units::to_turns_min},
    {units::from_turns, units::to_turns},
    {units::from_turns, units::to_turns},
    {units::from_deg, units::to_deg},
    {units::from_deg, units::to_deg},
}};
constexpr std::size_t rotary_limit_count = 3;

constexpr std::array<double RotaryAxis::*, rotary_limit_count> rotary_limits{
    &RotaryAxis::velocity, &RotaryAxis::acceleration, &RotaryAxis::jerk};
constexpr std::array<std::optional<double> RotaryAxis::*, 2> rotary_travel{&RotaryAxis::minimum,
                                                                           &RotaryAxis::maximum};

SettingSpec travel_spec(std::string key, std::string title, std::string explanation) {
  constexpr double farthest = 1e6;
  SettingSpec spec = limit_spec(std::move(key), std::move(title), "deg", std::move(explanation));
  spec.minimum = -farthest;
  spec.maximum = farthest;
  spec.optional = true;
  return spec;
}

[[noreturn]] void refuse_chain(const std::string& chain, const Message& what) {
  throw InputError(message(NC_("core",
                               "the chain '{}' {}; name X, Y, Z and the rotary axes once each from the part "
                               "to the tool, with the word frame between those that carry the part and those "
                               "that carry the tool, as in \"C A Y frame X Z\""),
                           chain, what));
}

}  // namespace

const RotaryAxis* MachineKinematics::find(char axis) const {
  const auto found = std::ranges::find(rotary, axis, &RotaryAxis::name);
  return found == rotary.end() ? nullptr : &*found;
}

KinematicChain chain_of(const MachineKinematics& kinematics) {
  std::vector<ChainAxis> axes;
  std::istringstream words(kinematics.chain);
  bool carries_part = true;
  for (std::string word; words >> word;) {
    if (word == frame_word) {
      if (!carries_part) {
        refuse_chain(kinematics.chain, NC_("core", "has the word frame twice"));
      }
      carries_part = false;
      continue;
    }
    const auto linear = std::ranges::find(coordinate_names, word[0]);
    const RotaryAxis* rotary = kinematics.find(word[0]);
    if (word.size() != 1 || (linear == coordinate_names.end() && rotary == nullptr)) {
      refuse_chain(kinematics.chain,
                   message(NC_("core", "has '{}', which is no axis of this machine"), word));
    }
    if (std::ranges::find(axes, word[0], &ChainAxis::name) != axes.end()) {
      refuse_chain(kinematics.chain, message(NC_("core", "has {} twice"), word));
    }
    // ISO 841: the coordinate grows as the tool moves along the axis, or turns about it, against the part.
    const double sense = carries_part ? -1 : 1;
    ChainAxis axis;
    axis.name = word[0];
    axis.carries_part = carries_part;
    if (rotary == nullptr) {
      axis.direction = sense * Vec3::Unit(linear - coordinate_names.begin());
    } else {
      axis.rotary = true;
      axis.direction = sense * rotary->direction;
      if (rotary->minimum && rotary->maximum && !(*rotary->minimum < *rotary->maximum)) {
        throw InputError(message(NC_("core", "the travel of axis {} is empty, from {:g} to {:g} degrees"),
                                 rotary->name, units::to_deg(*rotary->minimum),
                                 units::to_deg(*rotary->maximum)));
      }
      axis.point = rotary->point;
      axis.least = rotary->minimum.value_or(axis.least);
      axis.most = rotary->maximum.value_or(axis.most);
    }
    axes.push_back(axis);
  }
  if (carries_part) {
    refuse_chain(kinematics.chain, NC_("core", "lacks the word frame"));
  }
  for (const RotaryAxis& axis : kinematics.rotary) {
    if (std::ranges::find(axes, axis.name, &ChainAxis::name) == axes.end()) {
      refuse_chain(kinematics.chain, message(NC_("core", "lacks axis {}"), axis.name));
    }
  }
  return KinematicChain(std::move(axes), Vec3::Zero(), Vec3::UnitZ());
}

const std::vector<SettingSpec>& rotary_axis_specs() {
  static const std::vector<SettingSpec> specs{
      limit_spec("velocity", QT_TRANSLATE_NOOP("core", "Velocity"), "rev/min",
                 QT_TRANSLATE_NOOP("core", "Maximum velocity of this rotary axis.")),
      limit_spec("acceleration", QT_TRANSLATE_NOOP("core", "Acceleration"), "rev/s2",
                 QT_TRANSLATE_NOOP("core", "Maximum acceleration of this rotary axis.")),
      limit_spec(
          "jerk", QT_TRANSLATE_NOOP("core", "Jerk"), "rev/s3",
          QT_TRANSLATE_NOOP("core", "Maximum rate of change of the acceleration of this rotary axis.")),
      travel_spec(
          "minimum", QT_TRANSLATE_NOOP("core", "Minimum position"),
          QT_TRANSLATE_NOOP("core",
                            "Lower end of the travel of this rotary axis; without it the axis has no end.")),
      travel_spec(
          "maximum", QT_TRANSLATE_NOOP("core", "Maximum position"),
          QT_TRANSLATE_NOOP("core",
                            "Upper end of the travel of this rotary axis; without it the axis has no end.")),
  };
  return specs;
}

SettingValue rotary_value(const RotaryAxis& axis, std::size_t i) {
  if (i < rotary_limit_count) {
    return shortest_in_unit(axis.*rotary_limits[i], rotary_conversions[i]);
  }
  const std::optional<double>& end = axis.*rotary_travel[i - rotary_limit_count];
  return end ? SettingValue(shortest_in_unit(*end, rotary_conversions[i])) : SettingValue(std::string());
}

void set_rotary_value(RotaryAxis& axis, std::size_t i, const SettingValue& value) {
  SettingSpec spec = rotary_axis_specs()[i];
  spec.key = fmt::format("{}.{}", axis.name, spec.key);
  check_setting(spec, value, "");
  const double* number = std::get_if<double>(&value);
  if (i < rotary_limit_count) {
    axis.*rotary_limits[i] = rotary_conversions[i].to_internal(*number);
  } else {
    axis.*rotary_travel[i - rotary_limit_count] =
        number == nullptr ? std::nullopt : std::optional(rotary_conversions[i].to_internal(*number));
  }
}

namespace {

/// Motion over D from rest to rest with limits V, A, J: the speed v reached is the largest whose two ramps
/// fit, v t(v) <= D with the ramp's time t(v) = 2 sqrt(v/J) up to v = A^2/J, v/A + A/J above; the rest of D
/// is run at v.
struct RestToRest {
  double reached = 0;     ///< v
  double ramp = 0;        ///< t(v) [s]
  double jerk_phase = 0;  ///< each of the two jerk phases of a ramp [s]
  double duration = 0;    ///< total [s]

  RestToRest(double way, double velocity, double acceleration, double jerk) {
    const double knee = acceleration * acceleration / jerk;
    double fits = std::cbrt(way * way * jerk / 4);
    if (fits > knee) {
      fits = (std::sqrt(knee * knee + 4 * acceleration * way) - knee) / 2;
    }
    reached = std::min(fits, velocity);
    jerk_phase = reached <= knee ? std::sqrt(reached / jerk) : acceleration / jerk;
    ramp = reached <= knee ? 2 * jerk_phase : reached / acceleration + jerk_phase;
    duration = ramp + way / reached;
  }

  /// On the first ramp: jerk, constant acceleration, negative jerk.
  RestToRestPlace on_ramp(double time, double jerk) const {
    const double t1 = std::min(time, jerk_phase);
    const double a = jerk * t1;
    RestToRestPlace at{jerk * t1 * t1 * t1 / 6, a * t1 / 2, a, time < jerk_phase ? jerk : 0};
    const double t2 = std::clamp(time - jerk_phase, 0.0, ramp - 2 * jerk_phase);
    at.way += t2 * (at.velocity + t2 * a / 2);
    at.velocity += t2 * a;
    const double t3 = std::clamp(time - (ramp - jerk_phase), 0.0, jerk_phase);
    return {at.way + t3 * (at.velocity + t3 * (a / 2 - t3 * jerk / 6)),
            at.velocity + t3 * (a - t3 * jerk / 2), a - t3 * jerk, t3 > 0 ? -jerk : at.jerk};
  }
};

}  // namespace

double rest_to_rest_time(double way, double velocity, double acceleration, double jerk) {
  return way == 0 ? 0 : RestToRest(way, velocity, acceleration, jerk).duration;
}

RestToRestPlace rest_to_rest_at(double time, double way, double velocity, double acceleration, double jerk) {
  const RestToRest law(way, velocity, acceleration, jerk);
  if (!(time > 0) || time >= law.duration) {  // at rest
    return {time > 0 ? way : 0, 0, 0, 0};
  }
  if (time <= law.ramp) {
    return law.on_ramp(time, jerk);
  }
  if (time < law.duration - law.ramp) {
    return {law.reached * (time - law.ramp / 2), law.reached, 0, 0};
  }
  const RestToRestPlace mirrored = law.on_ramp(law.duration - time, jerk);
  return {way - mirrored.way, mirrored.velocity, -mirrored.acceleration, mirrored.jerk};
}

RestToRestPlace rest_to_rest_peaks(double way, double velocity, double acceleration, double jerk) {
  const RestToRest law(way, velocity, acceleration, jerk);
  return {way, law.reached, jerk * law.jerk_phase, jerk};
}

double turning_time(const RotaryAxis& axis, double angle, double feed) {
  const double velocity = feed > 0 ? std::min(feed, axis.velocity) : axis.velocity;
  return rest_to_rest_time(std::abs(angle), velocity, axis.acceleration, axis.jerk);
}

}  // namespace feedscope

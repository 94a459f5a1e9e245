#include "core/machine/settings.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/base/error.h"
#include "core/base/translatable.h"
#include "core/base/typed_number.h"
#include "core/machine/contour_tolerance.h"

namespace feedscope {
namespace {

SettingSpec number_spec(std::string key, std::string title, std::string unit, double fallback,
                        std::string explanation) {
  SettingSpec spec;
  spec.key = std::move(key);
  spec.title = std::move(title);
  spec.unit = std::move(unit);
  spec.explanation = std::move(explanation);
  spec.fallback = fallback;
  spec.minimum_allowed = false;
  return spec;
}

SettingSpec optional_spec(std::string key, std::string title, std::string unit, std::string explanation) {
  SettingSpec spec =
      number_spec(std::move(key), std::move(title), std::move(unit), 0, std::move(explanation));
  spec.minimum_allowed = true;
  spec.optional = true;
  return spec;
}

std::vector<SettingSpec> make_common_settings() {
  SettingSpec tolerance = number_spec(
      "contour_tolerance_mm", QT_TRANSLATE_NOOP("core", "Contour tolerance"), "mm", 0.01,
      QT_TRANSLATE_NOOP("core",
                        "Maximum distance of the path from the programmed corners; with larger values the "
                        "control slows down less there. 0: it stops in every corner."));
  tolerance.minimum_allowed = true;
  tolerance.least_above_zero = least_tolerance;
  tolerance.maximum = 10;
  SettingSpec own{
      .key = "program_tolerance",
      .title = QT_TRANSLATE_NOOP("core", "Tolerance of the program"),
      .explanation = QT_TRANSLATE_NOOP(
          "core",
          "on: where the program asks for a tolerance (CTOL, CYCLE832, G64 P, cycle 32) or a blend distance "
          "(ADIS), it is used; off: that of the settings is used everywhere. Exact stops are always used."),
      .choices = {QT_TRANSLATE_NOOP("core", "on"), QT_TRANSLATE_NOOP("core", "off")},
  };
  SettingSpec period =
      number_spec("interpolation_period_s", QT_TRANSLATE_NOOP("core", "Interpolation period"), "s", 0.002,
                  QT_TRANSLATE_NOOP("core",
                                    "Time between two set points of the control; a block shorter than the "
                                    "distance that the feed covers in one period is run more slowly."));
  period.maximum = 1;
  SettingSpec lookahead =
      number_spec("lookahead_blocks", QT_TRANSLATE_NOOP("core", "Look-ahead (blocks)"), "", 100,
                  QT_TRANSLATE_NOOP("core",
                                    "Number of blocks the control plans ahead; it must be able to stop "
                                    "within them, so a small number keeps the feed low on short blocks."));
  lookahead.minimum = 1;
  lookahead.minimum_allowed = true;
  lookahead.maximum = 1e6;
  lookahead.whole = true;
  SettingSpec acceleration_share = number_spec(
      "radial_acceleration_share", QT_TRANSLATE_NOOP("core", "Radial share of acceleration"), "", 0.2,
      QT_TRANSLATE_NOOP("core",
                        "Share of the acceleration of every axis that is available for radial acceleration "
                        "on a corner blend; the rest is left for accelerating and braking along the path."));
  acceleration_share.minimum = 0.01;
  acceleration_share.maximum = 0.99;
  acceleration_share.minimum_allowed = true;
  SettingSpec jerk_share = acceleration_share;
  jerk_share.key = "radial_jerk_share";
  jerk_share.title = QT_TRANSLATE_NOOP("core", "Radial share of jerk");
  jerk_share.explanation =
      QT_TRANSLATE_NOOP("core",
                        "Share of the jerk of every axis that is available for radial jerk on a corner "
                        "blend; the rest is left for accelerating and braking along the path.");
  SettingSpec curvilinear =
      number_spec("curvilinear_jerk_m_s3", QT_TRANSLATE_NOOP("core", "Curvilinear jerk"), "m/s3", 10,
                  QT_TRANSLATE_NOOP("core",
                                    "Maximum jerk along the path; it limits the feed on arcs to the cube "
                                    "root of jerk times radius squared."));
  SettingSpec tangential = number_spec(
      "tangential_share", QT_TRANSLATE_NOOP("core", "Tangential share of curvilinear jerk"), "", 0.6,
      QT_TRANSLATE_NOOP("core",
                        "Share of the curvilinear jerk used in the tangential direction; the rest is used in "
                        "the normal direction."));
  tangential.maximum = 1;
  SettingSpec merge = optional_spec(
      merge_collinear_key, QT_TRANSLATE_NOOP("core", "Merge collinear blocks"), "mm",
      QT_TRANSLATE_NOOP("core",
                        "Successive lines of one feed and one direction are planned as one block if every "
                        "point between them lies within this distance of it, so that corner blends are not "
                        "limited by half of a part of a line. Without it, or 0, every line is a block."));
  merge.maximum = 0.001;
  merge.least_above_zero = 1e-9;
  SettingSpec block_time = optional_spec(
      block_time_key, QT_TRANSLATE_NOOP("core", "Block time"), "ms",
      QT_TRANSLATE_NOOP("core",
                        "Least time that the control takes to prepare a block: the feed on a block is "
                        "at most its length by this time. Without it, or 0, blocks are prepared at "
                        "once."));
  block_time.maximum = 1000;
  SettingSpec stop_window = optional_spec(
      exact_stop_window_key, QT_TRANSLATE_NOOP("core", "Exact stop window"), "um",
      QT_TRANSLATE_NOOP(
          "core",
          "At exact stops (G9, G60 with G601 or G602, G61), before pauses and at the end the control "
          "waits until every axis is within this distance of its set position, by the gain of its "
          "drive. Without it, or 0, it does not wait."));
  stop_window.maximum = 10000;
  stop_window.least_above_zero = 0.001;
  std::vector<SettingSpec> specs{tolerance,   own,        period, lookahead,  acceleration_share, jerk_share,
                                 curvilinear, tangential, merge,  block_time, stop_window};
  specs.insert(specs.end(), machine_settings().begin(), machine_settings().end());
  return specs;
}

std::vector<SettingSpec> make_machine_settings() {
  constexpr double longest_time = 3600;
  constexpr double farthest = 1e5;
  std::vector<SettingSpec> specs{
      optional_spec(
          "tool_change_time_s", QT_TRANSLATE_NOOP("core", "Tool change time"), "s",
          QT_TRANSLATE_NOOP("core",
                            "Time of a tool change, from the end of the last motion to the start of the next "
                            "one; without it tool changes are not included in the cycle time.")),
      optional_spec("spindle_start_time_s", QT_TRANSLATE_NOOP("core", "Spindle start time"), "s",
                    QT_TRANSLATE_NOOP("core",
                                      "Time until the spindle has reached its speed, during which the axes "
                                      "wait; without it spindle starts are not included in the cycle time.")),
  };
  for (SettingSpec& spec : specs) {
    spec.maximum = longest_time;
  }
  struct Position {
    std::string_view key;
    std::array<const char*, 3> titles;  // of X, Y and Z
    std::string_view explanation;
  };
  constexpr std::array positions{
      Position{
          "home",
          {QT_TRANSLATE_NOOP("core", "Home position X"), QT_TRANSLATE_NOOP("core", "Home position Y"),
           QT_TRANSLATE_NOOP("core", "Home position Z")},
          QT_TRANSLATE_NOOP(
              "core",
              "Machine coordinate of the reference point that G28 and G74 move to; without it such a move is "
              "neither drawn nor timed.")},
      Position{"tool_change",
               {QT_TRANSLATE_NOOP("core", "Tool change position X"),
                QT_TRANSLATE_NOOP("core", "Tool change position Y"),
                QT_TRANSLATE_NOOP("core", "Tool change position Z")},
               QT_TRANSLATE_NOOP("core",
                                 "Machine coordinate of the position that G30 and G75 move to; without it "
                                 "such a move is neither "
                                 "drawn nor timed.")},
      Position{
          "part_zero",
          {QT_TRANSLATE_NOOP("core", "Part zero X"), QT_TRANSLATE_NOOP("core", "Part zero Y"),
           QT_TRANSLATE_NOOP("core", "Part zero Z")},
          QT_TRANSLATE_NOOP(
              "core",
              "Machine coordinate of the zero point of the coordinates shown, 0 where work offsets are given "
              "in machine coordinates; without it moves to machine positions are neither drawn nor timed.")},
  };
  for (const Position& position : positions) {
    for (std::size_t axis = 0; axis < position.titles.size(); ++axis) {
      SettingSpec spec = optional_spec(fmt::format("{}_{}_mm", position.key, "xyz"[axis]),
                                       position.titles[axis], "mm", std::string(position.explanation));
      spec.minimum = -farthest;
      spec.maximum = farthest;
      specs.push_back(std::move(spec));
    }
  }
  SettingSpec override = optional_spec(
      feed_override_key, QT_TRANSLATE_NOOP("core", "Feed override"), "%",
      QT_TRANSLATE_NOOP("core",
                        "All feeds of the program in percent of what it says, as the dial of the control "
                        "sets them; rapids stay. Without it 100 %."));
  override.minimum = 1;
  override.fallback = 100;
  override.maximum = 1000;
  specs.push_back(std::move(override));
  constexpr std::array cutting_feeds{QT_TRANSLATE_NOOP("core", "Cutting feed X"),
                                     QT_TRANSLATE_NOOP("core", "Cutting feed Y"),
                                     QT_TRANSLATE_NOOP("core", "Cutting feed Z")};
  for (std::size_t axis = 0; axis < cutting_feeds.size(); ++axis) {
    SettingSpec spec = optional_spec(
        cutting_feed_key(static_cast<int>(axis)), cutting_feeds[axis], "m/min",
        QT_TRANSLATE_NOOP("core",
                          "Largest velocity of this axis in feed moves, where the control has one below that "
                          "of its rapids; without it, or 0, the velocity of the axis."));
    spec.maximum = 1000;
    specs.push_back(std::move(spec));
  }
  SettingSpec tool_length = optional_spec(
      "tool_length_mm", QT_TRANSLATE_NOOP("core", "Tool length"), "mm",
      QT_TRANSLATE_NOOP("core",
                        "From the gauge point of the spindle to the tip of the tool; it says how X, Y and Z "
                        "follow rotary axes. Without it the one of the machine's kinematics."));
  tool_length.maximum = farthest;
  specs.push_back(std::move(tool_length));
  SettingSpec orientation = optional_spec(
      "orientation_tolerance_deg", QT_TRANSLATE_NOOP("core", "Orientation tolerance"), "deg",
      QT_TRANSLATE_NOOP("core",
                        "How far rotary axes may leave their programmed angles where blocks meet along which "
                        "they turn at different rates; without it 0.05 degrees."));
  orientation.minimum_allowed = false;
  orientation.fallback = usual_orientation_tolerance_deg;
  orientation.maximum = 10;
  specs.push_back(std::move(orientation));
  constexpr std::array part_angles{QT_TRANSLATE_NOOP("core", "Angle of the part about X"),
                                   QT_TRANSLATE_NOOP("core", "Angle of the part about Y"),
                                   QT_TRANSLATE_NOOP("core", "Angle of the part about Z")};
  for (std::size_t axis = 0; axis < part_angles.size(); ++axis) {
    SettingSpec spec = optional_spec(
        fmt::format("part_angle_{}_deg", "xyz"[axis]), part_angles[axis], "deg",
        QT_TRANSLATE_NOOP(
            "core",
            "How the part is turned in the clamping, about X, then Y, then Z, against how the "
            "program was made for; rotary axes stand as if the program had been posted again."));
    spec.minimum = -360;
    spec.maximum = 360;
    specs.push_back(std::move(spec));
  }
  return specs;
}

/// Bounds as text: "above 0 s and at most 1 s"; "0, or at least 0.000001 mm and at most 10 mm".
Message bounds_text(const SettingSpec& spec) {
  const auto bound = [&](double value) {
    const Message digits = Message::number(plain_text(value));
    return spec.unit.empty() ? digits : message(NC_("core", "{} {}"), digits, spec.unit);
  };
  const bool has_most = std::isfinite(spec.maximum);
  if (!std::isfinite(spec.minimum)) {
    return has_most ? message(NC_("core", "at most {}"), bound(spec.maximum))
                    : Message(NC_("core", "finite"));
  }
  Message text = spec.least_above_zero > 0
                     ? message(NC_("core", "0, or at least {}"), bound(spec.least_above_zero))
                 : spec.minimum_allowed ? message(NC_("core", "at least {}"), bound(spec.minimum))
                                        : message(NC_("core", "above {}"), bound(spec.minimum));
  if (has_most) {
    text = message(NC_("core", "{} and at most {}"), text, bound(spec.maximum));
  }
  return spec.whole ? message(NC_("core", "a whole number {}"), text) : text;
}

[[noreturn]] void refuse(std::string_view place, const Message& why) {
  throw InputError(place.empty() ? why : at_place(std::string(place), why));
}

}  // namespace

const std::vector<SettingSpec>& common_settings() {
  static const std::vector<SettingSpec> specs = make_common_settings();
  return specs;
}

const std::vector<SettingSpec>& machine_settings() {
  static const std::vector<SettingSpec> specs = make_machine_settings();
  return specs;
}

bool Settings::has(std::string_view key) const {
  return values_.find(key) != values_.end();
}

double Settings::number(std::string_view key) const {
  const auto found = values_.find(key);
  if (found == values_.end()) {
    throw InputError(message(NC_("core", "setting '{}' has no value"), key));
  }
  const double* number = std::get_if<double>(&found->second);
  if (number == nullptr) {
    throw InputError(message(NC_("core", "setting '{}' is the text '{}', not a number"), key,
                             std::get<std::string>(found->second)));
  }
  return *number;
}

const std::string& Settings::text(std::string_view key) const {
  const auto found = values_.find(key);
  if (found == values_.end()) {
    throw InputError(message(NC_("core", "setting '{}' has no value"), key));
  }
  const std::string* text = std::get_if<std::string>(&found->second);
  if (text == nullptr) {
    throw InputError(message(NC_("core", "setting '{}' is the number {}, not a text"), key,
                             std::get<double>(found->second)));
  }
  return *text;
}

void Settings::set(std::string key, SettingValue value) {
  if (value == SettingValue(std::string())) {
    values_.erase(key);
  } else {
    values_.insert_or_assign(std::move(key), std::move(value));
  }
}

SettingValue Settings::value(std::string_view key) const {
  const auto found = values_.find(key);
  return found == values_.end() ? SettingValue(std::string()) : found->second;
}

std::string cutting_feed_key(int axis) {
  return fmt::format("cutting_feed_{}_m_min", static_cast<char>('x' + axis));
}

double number_in_force(const Settings& settings, const SettingSpec& spec) {
  return spec.optional && !settings.has(spec.key) ? spec.fallback : settings.number(spec.key);
}

SettingValue parse_setting(const SettingSpec& spec, std::string_view text) {
  SettingValue value = std::string(text);
  if (spec.choices.empty() && !(spec.optional && text.empty())) {
    const TypedNumber number = typed_in_unit(text, spec.unit);
    if (!number.value) {
      throw InputError(number.problem.empty()
                           ? message(NC_("core", "{} = '{}' is not a number; it must be {}"), spec.key, text,
                                     bounds_text(spec))
                           : message(NC_("core", "{} = '{}': {}"), spec.key, text, number.problem));
    }
    value = *number.value;
  }
  check_setting(spec, value, "");
  return value;
}

void check_setting(const SettingSpec& spec, const SettingValue& value, std::string_view place) {
  const double* number = std::get_if<double>(&value);
  if (spec.optional && value == SettingValue(std::string())) {
    return;
  }
  if (!spec.choices.empty()) {
    const std::string text = number != nullptr ? fmt::format("{}", *number) : std::get<std::string>(value);
    if (number != nullptr ||
        std::find(spec.choices.begin(), spec.choices.end(), text) == spec.choices.end()) {
      refuse(place, message(NC_("core", "{} = '{}' is not a valid choice; it must be one of: {}"), spec.key,
                            text, fmt::to_string(fmt::join(spec.choices, ", "))));
    }
    return;
  }
  if (number == nullptr) {
    refuse(place, message(NC_("core", "{} = '{}' is text; it must be a number {}"), spec.key,
                          std::get<std::string>(value), bounds_text(spec)));
  }
  const bool above = spec.minimum_allowed ? *number >= spec.minimum : *number > spec.minimum;
  const bool whole = !spec.whole || *number == std::floor(*number);
  const bool too_small = *number > 0 && *number < spec.least_above_zero;
  if (!std::isfinite(*number) || !above || too_small || !(*number <= spec.maximum) || !whole) {
    refuse(place, message(NC_("core", "{} = {} is out of bounds; it must be {}"), spec.key, *number,
                          bounds_text(spec)));
  }
}

double nearest_within(const SettingSpec& spec, double value) {
  const double bounded = std::clamp(value, spec.minimum, spec.maximum);
  return bounded > 0 ? std::max(bounded, spec.least_above_zero) : bounded;
}

std::string plain_text(double number) {
  constexpr double least = 1e-9;
  constexpr double usual = 1e-4;  // from here on {} writes no exponent
  const double size = std::abs(number);
  if (size < least || size >= usual) {
    return fmt::format("{}", number);
  }
  std::string text = fmt::format("{:.9f}", number);
  text.erase(text.find_last_not_of('0') + 1);
  return text;
}

}  // namespace feedscope

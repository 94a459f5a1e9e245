// The part of HeidenhainCore for cycles.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/base/units.h"
#include "core/program/cycles/hole_patterns.h"
#include "core/program/heidenhain/heidenhain_core.h"
#include "core/program/path/plane_points.h"
#include "core/program/text/message.h"
#include "core/program/text/read_fault.h"

namespace feedscope {

namespace {

constexpr int circle_pattern = 220;
constexpr int grid_pattern = 221;
constexpr int datum_setting = 247;
constexpr int traverse_on_circle = 365;

/// Contour geometry and data, orientation, load and vibration control.
constexpr auto motionless_cycles = std::to_array<int>({13, 14, 20, 239, 270, 332, 392});

constexpr double largest_value = 1e9;

/// F words may stand for a number: what the largest number means too.
constexpr double rapid_feed = 99999.999;

std::string_view text_of(DrillingFault fault) {
  switch (fault) {
    case DrillingFault::none:
      break;
    case DrillingFault::depth:
      return "its depth Q201 is above the surface; write it negative";
    case DrillingFault::by_diameter:
      return "centring to a diameter needs the tool's point angle; write Q343=0 and the depth";
    case DrillingFault::tool_radius:
      return "the radius of the tool is not known; write a TOOL DEF with R before the tool call";
    case DrillingFault::pitch:
      return "it has no pitch or the spindle no speed; write S in the tool call";
    case DrillingFault::steps:
      return "it would take more than 10000 infeeds, or its infeeds are negative; check Q202 and alike";
    case DrillingFault::infeeds:
      return "what it does between infeeds (Q202 below its depth) is not read; write Q202=0 for one";
    case DrillingFault::counterbore:
      return "its depth Q249 is not above zero; write it positive";
    case DrillingFault::direction:
      return "the direction Q214 in which the tool passes the hole is not 1 to 4";
  }
  return "";
}

}  // namespace

void HeidenhainCore::read_cycle_parameters(Scanner& scanner, QParameters& into) {
  bool began = false;
  while (!scanner.at_end()) {
    const std::size_t before = scanner.at();
    const std::uint32_t column = scanner.column();
    const std::optional<QName> name = take_parameter(scanner);
    if (!name || !scanner.take('=')) {
      if (began) {
        throw ReadFault{"cycle-parameter", column, fmt::format("{} is no parameter", quoted(scanner.rest())),
                        "write parameters as Q200=2"};
      }
      // The title.
      scanner.move_to(std::max(before, static_cast<std::size_t>(column) - 1) + 1);
      continue;
    }
    began = true;
    if (scanner.take_keyword("PREDEF")) {
      const std::optional<double> value = predefined_.get(*name);
      if (!value) {
        throw ReadFault{"cycle-parameter", column,
                        fmt::format("no GLOBAL DEF says what PREDEF is for {}", name->text()),
                        "write a number, or the GLOBAL DEF before it"};
      }
      into.set(*name, *value);
      continue;
    }
    const bool f = scanner.take('F');
    if (scanner.take_keyword("MAX")) {
      into.set(*name, rapid_feed);
    } else if (tool_feed_word_ == FeedWord::value && scanner.take_keyword("AUTO")) {
      into.set(*name, tool_feed_);
    } else if (f && scanner.take('U') && !is_inch()) {
      into.set(*name, formulas_.read_value(scanner) * spindle_speed_);
    } else if (f || scanner.take_keyword("AUTO")) {
      throw ReadFault{"cycle-parameter", column, fmt::format("the value of {} is not read", name->text()),
                      "write a number"};
    } else {
      into.set(*name, formulas_.read_value(scanner));
    }
  }
}

void HeidenhainCore::define_cycle(int number, std::string_view title, Scanner& parameters,
                                  std::uint32_t column) {
  const auto known = parameters_of_drilling(number);
  for (const CycleParameter& parameter : known) {
    if (parameter.otherwise) {
      const double unit = parameter.unit == CycleUnit::plain ? 1 : unit_;
      parameters_.set_global(parameter.q, *parameter.otherwise / unit);
    }
  }
  if (number == circle_pattern) {
    parameters_.set_global(traverse_on_circle, 0);
  }
  read_cycle_parameters(parameters, parameters_);
  if (number == circle_pattern || number == grid_pattern) {
    run_pattern(number, column);
  } else if (number == datum_setting) {
    set_preset("cycle 247", false, column);
  } else if (known.empty()) {
    leave_out_cycle(number, title, column);
  } else {
    set_cycle({number, CycleKind::drilling, {}});
  }
}

void HeidenhainCore::set_old_drilling(int number, int part, double value) {
  enum class Value { clearance, depth, infeed, dwell, feed, pitch, none };
  using V = Value;
  constexpr std::array pecking{V::clearance, V::depth, V::infeed, V::dwell, V::feed};
  constexpr std::array tapping{V::clearance, V::depth, V::dwell, V::feed, V::none};
  constexpr std::array rigid{V::clearance, V::depth, V::pitch, V::none, V::none};
  const auto& values = number == 1 ? pecking : number == 2 ? tapping : rigid;
  const Value which =
      part <= static_cast<int>(values.size()) ? values[static_cast<std::size_t>(part - 1)] : V::none;
  switch (which) {
    case V::clearance:
      old_drilling_.clearance = to_mm(value);
      break;
    case V::depth:
      old_drilling_.depth = to_mm(value);
      break;
    case V::infeed:
      old_drilling_.infeed = to_mm(value);
      break;
    case V::dwell:
      old_drilling_.dwell = value;
      break;
    case V::feed:
      old_drilling_.feed = to_feed(value);
      break;
    case V::pitch:
      old_drilling_.pitch = to_mm(value);
      break;
    case V::none:
      break;
  }
}

void HeidenhainCore::leave_out_cycle(int number, std::string_view title, std::uint32_t column) {
  const auto name = [&] {
    return title.empty() ? fmt::format("cycle {}", number) : fmt::format("cycle {} ({})", number, title);
  };
  if (std::find(motionless_cycles.begin(), motionless_cycles.end(), number) != motionless_cycles.end()) {
    report(Severity::info, "unread-cycle", number, column, [&] {
      return Text{fmt::format("{} is not read", name()), "it does not move by itself"};
    });
    return;
  }
  set_cycle({number, CycleKind::left_out, {}});
  report(Severity::error, "unread-cycle", number, column, [&] {
    return Text{fmt::format("{} is not read", name()), "its motion is left out wherever it is called"};
  });
}

void HeidenhainCore::call_cycle(std::uint32_t column, double surface_offset) {
  end_contour(column);
  const DrillingPlace place{path(), contour_.plane(), spindle_speed_ / 60, tool_radius_};
  DrillingFault fault = DrillingFault::none;
  switch (cycle_.kind) {
    case CycleKind::none:
      report(Severity::error, "cycle-call", 0, column, [] {
        return Text{"a cycle is called, but none is defined", "the call is left out"};
      });
      break;
    case CycleKind::drilling:
      if (const auto words = drilling_words(column)) {
        Drilling shifted = *words;
        shifted.surface += surface_offset;
        fault = drill(cycle_.number, shifted, place);
      }
      break;
    case CycleKind::old_drilling:
      fault = drill_old(cycle_.number, old_drilling_, place);
      break;
    case CycleKind::program:
      call_program(cycle_.program, column);
      break;
    case CycleKind::left_out:
      break;
  }
  report_drilling_fault(fault, column);
}

void HeidenhainCore::call_cycle_at(const MotionWords& words, std::uint32_t column) {
  modal_cycle_ = false;
  // Its F holds for the way there only.
  const ContourFeed feed = feed_;
  MotionWords in_plane = words;
  OptionalWord& along = in_plane.axes[static_cast<std::size_t>(normal_axis(plane()))];
  const double raised = along.given ? along.value : 0;
  along.given = false;
  run_path(PathKind::line, in_plane);
  feed_ = feed;
  call_cycle(column, raised);
}

void HeidenhainCore::call_cycle_at_pattern(const MotionWords& words, std::uint32_t column) {
  if (pattern_.empty() || cycle_.kind == CycleKind::program) {
    report(Severity::error, "cycle-call", 1, column, [&] {
      return Text{pattern_.empty() ? "CYCL CALL PAT without PATTERN DEF"
                                   : "CYCL CALL PAT of a program (cycle 12) is not read",
                  "the calls are left out"};
    });
    return;
  }
  if (cycle_.kind == CycleKind::left_out) {
    return;
  }
  modal_cycle_ = false;
  const ContourFeed feed = feed_;
  run_functions(words);
  MotionWords way;
  way.feed_word = words.feed_word == FeedWord::rapid ? FeedWord::rapid : FeedWord::none;
  way.first_column = column;
  const int axis = normal_axis(plane());
  const double start = contour_.position()[axis];
  const auto drilling = cycle_.kind == CycleKind::drilling ? drilling_words(column) : std::nullopt;
  for (const Vec3& place : pattern_) {
    MotionWords up = way;
    up.feed_word = FeedWord::rapid;
    Vec3 target = contour_.position();
    const double safe = drilling ? drilling->surface + place[axis] + drilling->second_clearance : start;
    target[axis] = std::max(start, safe);
    if (target[axis] > contour_.position()[axis]) {
      contour_.add(element_of(up, target));
    }
    ContourElement element = element_of(way, from_plane(in_plane(place, plane()), plane(), target));
    element.place.axes = 7;
    contour_.add(element);
    call_cycle(column, place[axis]);
  }
  feed_ = feed;
}

void HeidenhainCore::report_drilling_fault(DrillingFault fault, std::uint32_t column) {
  if (fault != DrillingFault::none) {
    report(Severity::error, "cycle-value", cycle_.number * 10 + static_cast<int>(fault), column, [&] {
      return Text{fmt::format("cycle {} cannot run: {}", cycle_.number, text_of(fault)),
                  "its motion is left out"};
    });
  }
}

std::optional<Drilling> HeidenhainCore::drilling_words(std::uint32_t column) {
  Drilling words;
  for (const CycleParameter& parameter : parameters_of_drilling(cycle_.number)) {
    const std::optional<double> value = parameters_.global(parameter.q);
    if (!value) {
      report(Severity::error, "cycle-parameter", parameter.q, column, [&] {
        return Text{fmt::format("cycle {} lacks Q{}", cycle_.number, parameter.q),
                    "the cycle is left out; write all of its parameters"};
      });
      return std::nullopt;
    }
    if (!(std::abs(*value) <= largest_value)) {
      throw ReadFault{"cycle-parameter", column,
                      fmt::format("cycle {}: Q{} is {}, beyond the largest number, 1000000000", cycle_.number,
                                  parameter.q, *value),
                      "the cycle is left out"};
    }
    words.*parameter.value = parameter.unit == CycleUnit::length ? to_mm(*value)
                             : parameter.unit != CycleUnit::feed ? *value
                             : *value >= rapid_feed              ? std::numeric_limits<double>::infinity()
                                                                 : to_feed(*value);
  }
  if (words.to_shoulder != 0) {
    report(Severity::warning, "cycle-value", cycle_.number * 10, column, [&] {
      return Text{fmt::format("cycle {}: Q395=1 counts the depth to the drill's cylinder", cycle_.number),
                  "how long its point is only the tool table knows; it is shown as the depth of the tip"};
    });
  }
  return words;
}

std::vector<Vec2> HeidenhainCore::pattern_places(int number, std::uint32_t column) {
  constexpr double most = 10000;
  const auto value = [&](int q) {
    return std::clamp(parameters_.global(q).value_or(0), -largest_value, largest_value);
  };
  const auto count = [&](int q) {
    if (!(value(q) >= 1 && value(q) <= most)) {
      throw ReadFault{
          "cycle-parameter", column,
          fmt::format("cycle {}: Q{} is {}, not a number of places from 1 to {}", number, q, value(q), most),
          "the pattern is left out"};
    }
    return static_cast<int>(value(q));
  };
  if (number == circle_pattern) {
    const double start = units::from_deg(value(245));
    const double step = units::from_deg(value(247));
    const int holes = count(241);
    return places_of(
        CirclePattern{.center = {to_mm(value(216)), to_mm(value(217))},
                      .diameter = to_mm(value(244)),
                      .start = start,
                      .step = step != 0 ? step : step_between(start, units::from_deg(value(246)), holes),
                      .count = holes});
  }
  return places_of(GridPattern{.start = {to_mm(value(225)), to_mm(value(226))},
                               .column_spacing = to_mm(value(237)),
                               .row_spacing = to_mm(value(238)),
                               .columns = count(242),
                               .rows = count(243),
                               .angle = units::from_deg(value(224))});
}

Drilling HeidenhainCore::pattern_heights() const {
  const auto value = [&](int q) {
    return to_mm(std::clamp(parameters_.global(q).value_or(0), -largest_value, largest_value));
  };
  Drilling heights;
  heights.clearance = value(200);
  heights.surface = value(203);
  heights.second_clearance = value(204);
  return heights;
}

/// The cycles of older programs start where the tool is.
DrillingFault HeidenhainCore::drill_in_pattern(const Drilling& words, const DrillingPlace& place) {
  if (cycle_.kind == CycleKind::drilling) {
    return drill(cycle_.number, words, place);
  }
  const int axis = normal_axis(place.plane);
  Vec3 at = path().position();
  at[axis] = words.surface + words.clearance;
  path().rapid(at);
  const DrillingFault fault = drill_old(cycle_.number, old_drilling_, place);
  at = path().position();
  at[axis] = words.surface + std::max(words.second_clearance, words.clearance);
  if (at[axis] != path().position()[axis]) {
    path().rapid(at);
  }
  return fault;
}

void HeidenhainCore::run_pattern(int number, std::uint32_t column) {
  if (cycle_.kind == CycleKind::left_out) {
    return;
  }
  const bool is_old = cycle_.kind == CycleKind::old_drilling;
  if (cycle_.kind != CycleKind::drilling && !is_old) {
    throw ReadFault{"cycle-call", column,
                    fmt::format("cycle {} repeats a cycle, but none is defined", number),
                    "the pattern is left out; define a cycle from 200 to 209 or 240 before it"};
  }
  if (number == circle_pattern && parameters_.global(traverse_on_circle).value_or(0) != 0) {
    report(Severity::info, "cycle-value", number * 10, column, [] {
      return Text{"cycle 220: Q365=1 goes from place to place on the circle",
                  "the holes are right, the way between them is shown straight"};
    });
  }
  const std::vector<Vec2> places = pattern_places(number, column);
  const auto words = is_old ? std::optional(pattern_heights()) : drilling_words(column);
  if (!words) {
    return;
  }
  const bool high = parameters_.global(301).value_or(1) != 0;
  const Plane plane = contour_.plane();
  const int axis = normal_axis(plane);
  end_contour(column);
  Drilling between = *words;
  between.second_clearance = high ? words->second_clearance : words->clearance;
  const DrillingPlace place{path(), plane, spindle_speed_ / 60, tool_radius_};
  path().program_axes();
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (i == 0) {
      Vec3 up = path().position();
      up[axis] = words->surface + std::max(words->second_clearance, words->clearance);
      path().rapid(up);
    }
    path().rapid(from_plane(places[i], plane, path().position()));
    const DrillingFault fault = drill_in_pattern(i + 1 < places.size() ? between : *words, place);
    if (fault != DrillingFault::none) {
      report_drilling_fault(fault, column);
      return;
    }
  }
}

}  // namespace feedscope

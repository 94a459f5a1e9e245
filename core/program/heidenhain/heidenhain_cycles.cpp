// The part of HeidenhainCore for cycles.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/units.h"
#include "core/program/heidenhain/heidenhain_core.h"
#include "core/program/heidenhain/hole_patterns.h"
#include "core/program/path/plane_points.h"
#include "core/program/text/message.h"
#include "core/program/text/read_fault.h"

namespace feedscope {

namespace {

constexpr int circle_pattern = 220;
constexpr int grid_pattern = 221;
constexpr int datum_setting = 247;

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
  }
  return "";
}

}  // namespace

void HeidenhainCore::read_cycle_parameters(Scanner& scanner) {
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
    const bool f = scanner.take('F');
    if (scanner.take_name("MAX")) {
      parameters_.set(*name, rapid_feed);
    } else if (scanner.take_name("AUTO")) {
      parameters_.set(*name, tool_feed_);
    } else if (f || scanner.take_name("PREDEF")) {
      throw ReadFault{"cycle-parameter", column, fmt::format("the value of {} is not read", name->text()),
                      "write a number"};
    } else {
      parameters_.set(*name, formulas_.read_value(scanner));
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
  read_cycle_parameters(parameters);
  if (number == circle_pattern || number == grid_pattern) {
    run_pattern(number, column);
  } else if (number == datum_setting) {
    set_datum("cycle 247", column);
  } else if (known.empty()) {
    leave_out_cycle(number, title, column);
  } else {
    cycle_ = {number, CycleKind::drilling, {}};
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
  cycle_ = {number, CycleKind::left_out, {}};
  report(Severity::error, "unread-cycle", number, column, [&] {
    return Text{title.empty() ? fmt::format("cycle {} is not read", number)
                              : fmt::format("cycle {} ({}) is not read", number, title),
                "what it does is left out"};
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
                             : parameter.unit == CycleUnit::feed ? to_feed(*value)
                                                                 : *value;
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
    return places_of(CirclePattern{.center = {to_mm(value(216)), to_mm(value(217))},
                                   .diameter = to_mm(value(244)),
                                   .start = units::from_deg(value(245)),
                                   .stop = units::from_deg(value(246)),
                                   .step = units::from_deg(value(247)),
                                   .count = count(241)});
  }
  return places_of(GridPattern{.start = {to_mm(value(225)), to_mm(value(226))},
                               .column_spacing = to_mm(value(237)),
                               .row_spacing = to_mm(value(238)),
                               .columns = count(242),
                               .rows = count(243),
                               .angle = units::from_deg(value(224))});
}

void HeidenhainCore::run_pattern(int number, std::uint32_t column) {
  if (cycle_.kind == CycleKind::left_out) {
    return;
  }
  if (cycle_.kind != CycleKind::drilling) {
    throw ReadFault{"cycle-call", column,
                    fmt::format("cycle {} repeats a cycle, but none is defined", number),
                    "the pattern is left out; define a cycle from 200 to 209 or 240 before it"};
  }
  const std::vector<Vec2> places = pattern_places(number, column);
  const auto words = drilling_words(column);
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
    const DrillingFault fault = drill(cycle_.number, i + 1 < places.size() ? between : *words, place);
    if (fault != DrillingFault::none) {
      report_drilling_fault(fault, column);
      return;
    }
  }
}

}  // namespace feedscope

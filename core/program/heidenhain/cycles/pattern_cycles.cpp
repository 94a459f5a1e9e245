#include "core/program/heidenhain/cycles/pattern_cycles.h"

#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "core/program/cycles/hole_patterns.h"
#include "core/program/path/plane_points.h"
#include "core/program/text/read_fault.h"

namespace feedscope::heidenhain {

namespace {

constexpr int circle_pattern = 220;
constexpr int grid_pattern = 221;
constexpr int traverse_on_circle = 365;

}  // namespace

bool PatternCycles::has(int number) {
  return number == circle_pattern || number == grid_pattern;
}

void PatternCycles::set_defaults(int number) {
  if (number == circle_pattern) {
    parameters().set_global(traverse_on_circle, 0);
  }
}

std::vector<Vec2> PatternCycles::places(int number, std::uint32_t column) const {
  constexpr double most = 10000;
  const auto value = [&](int q) { return parameters_.value(q); };
  const auto count = [&](int q) {
    if (!(value(q) >= 1 && value(q) <= most)) {
      throw ReadFault{"cycle-parameter", column,
                      message(NC_("core", "cycle {}: Q{} is {}, not a number of places from 1 to {}"), number,
                              q, value(q), most),
                      NC_("core", "the pattern is skipped")};
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

DrillingParameters PatternCycles::heights() const {
  DrillingParameters heights;
  heights.clearance = to_mm(parameters_.value(200));
  heights.surface = to_mm(parameters_.value(203));
  heights.second_clearance = to_mm(parameters_.value(204));
  return heights;
}

/// The cycles of older programs start at the tool's position.
DrillingFault PatternCycles::drill_one(const Cycle& repeated, const DrillingParameters& words,
                                       const DrillingPlace& place) const {
  if (repeated.kind == Cycle::Kind::drilling) {
    return drill(repeated.number, words, place);
  }
  const int axis = normal_axis(place.plane);
  Vec3 at = path().position();
  at[axis] = words.surface + words.clearance;
  path().rapid(at);
  const DrillingFault fault = drill_old(repeated.number, repeated.old, place);
  at = path().position();
  at[axis] = words.surface + std::max(words.second_clearance, words.clearance);
  if (at[axis] != path().position()[axis]) {
    path().rapid(at);
  }
  return fault;
}

void PatternCycles::run(int number, const Cycle& repeated, std::uint32_t column) {
  if (repeated.kind == Cycle::Kind::unsupported) {
    return;
  }
  const bool is_old = repeated.kind == Cycle::Kind::old_drilling;
  if (repeated.kind != Cycle::Kind::drilling && !is_old) {
    throw ReadFault{"cycle-call", column,
                    message(NC_("core", "cycle {} repeats a cycle, but none is defined"), number),
                    NC_("core", "the pattern is skipped; define a cycle from 200 to 209 or 240 before it")};
  }
  if (number == circle_pattern && parameters().global(traverse_on_circle).value_or(0) != 0) {
    report(Severity::info, "cycle-value", number * 10, column, [] {
      return Text{NC_("core", "cycle 220: Q365=1 goes from place to place on the circle"),
                  NC_("core", "the holes are right, the way between them is shown straight")};
    });
  }
  const std::vector<Vec2> places = this->places(number, column);
  const auto words = is_old ? std::optional(heights()) : parameters_.drilling(repeated.number, column);
  if (!words) {
    return;
  }
  const bool high = parameters().global(301).value_or(1) != 0;
  const Plane plane = this->plane();
  const int axis = normal_axis(plane);
  end_contour(column);
  DrillingParameters between = *words;
  between.second_clearance = high ? words->second_clearance : words->clearance;
  const DrillingPlace place = drilling_place(context_);
  path().program_axes();
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (i == 0) {
      Vec3 up = path().position();
      up[axis] = words->surface + std::max(words->second_clearance, words->clearance);
      path().rapid(up);
    }
    path().rapid(from_plane(places[i], plane, path().position()));
    const DrillingFault fault = drill_one(repeated, i + 1 < places.size() ? between : *words, place);
    if (fault != DrillingFault::none) {
      report_fault(context_, repeated.number, fault, column);
      return;
    }
  }
}

}  // namespace feedscope::heidenhain

#include "core/program/heidenhain/drilling_cycles.h"

#include <algorithm>
#include <cmath>

#include "core/program/heidenhain/boring_cycles.h"
#include "core/program/heidenhain/spindle_moves.h"

namespace feedscope {

namespace {

void drill_in_steps(const Drilling& words, const Hole& hole, Spindle& spindle) {
  const double step = whole_depth_if_none(words);
  double reached = words.surface;
  while (true) {
    const double next = std::max(reached - step, hole.bottom);
    spindle.cut(next, words.feed);
    reached = next;
    if (reached <= hole.bottom) {
      break;
    }
    spindle.rapid(hole.top);
    spindle.dwell(words.top_dwell);
    spindle.rapid(std::min(reached + words.clearance, hole.top));
  }
  spindle.dwell(words.bottom_dwell);
  spindle.rapid(hole.top);
}

constexpr double least_step = 1e-3;

/// The infeed after `step`, made smaller but not below the least one.
double smaller(double step, const Drilling& words) {
  return std::max(step - words.decrement, std::min(step, std::max(words.least_infeed, least_step)));
}

constexpr double most_steps = 10000;

bool has_too_many_steps(const Drilling& words) {
  double step = whole_depth_if_none(words);
  if (words.decrement != 0) {
    step = std::min(step, std::max(words.least_infeed, least_step));
  }
  if (words.break_infeed > 0) {
    step = std::min(step, words.break_infeed);
  }
  return -words.depth > most_steps * step || words.decrement < 0;
}

void drill_universal(const Drilling& words, const Hole& hole, Spindle& spindle) {
  const double back = or_else(words.retract_feed, words.feed);
  double step = whole_depth_if_none(words);
  double reached = words.surface;
  double breaks = 0;
  while (true) {
    reached = std::max(reached - step, hole.bottom);
    spindle.cut(reached, words.feed);
    if (reached <= hole.bottom) {
      break;
    }
    if (breaks < words.breaks) {
      ++breaks;
      spindle.cut(reached + words.break_distance, back);
    } else {
      breaks = 0;
      spindle.cut(hole.top, back);
      spindle.dwell(words.top_dwell);
      spindle.rapid(std::min(reached + words.clearance, hole.top));
    }
    step = smaller(step, words);
  }
  spindle.dwell(words.bottom_dwell);
  spindle.cut(hole.top, back);
}

/// From `from` down to `to`, with chip breaks.
void peck_once(const Drilling& words, double from, double to, Spindle& spindle) {
  if (words.break_infeed > 0) {
    for (double at = from - words.break_infeed; at > to; at -= words.break_infeed) {
      spindle.cut(at, words.feed);
      spindle.cut(at + words.break_distance, words.feed);
    }
  }
  spindle.cut(to, words.feed);
}

void peck(const Drilling& words, const Hole& hole, Spindle& spindle) {
  double reached = words.surface - std::abs(words.start_depth);
  if (words.start_depth != 0) {
    spindle.cut(reached + words.clearance, or_else(words.start_feed, words.feed));
  }
  const double whole = reached - hole.bottom;
  const double first = whole_depth_if_none(words);
  double step = first;
  while (true) {
    const double next = std::max(reached - step, hole.bottom);
    peck_once(words, reached, next, spindle);
    reached = next;
    if (reached <= hole.bottom) {
      break;
    }
    spindle.rapid(hole.top);
    const double done = std::clamp(1 - (reached - hole.bottom) / whole, 0.0, 1.0);
    const double stop = words.upper_stop + done * (words.lower_stop - words.upper_stop);
    spindle.rapid(std::min(reached + stop, hole.top));
    step = smaller(step, words);
  }
  spindle.dwell(words.bottom_dwell);
  spindle.cut(hole.top, or_else(words.retract_feed, words.feed));
}

/// Cycle 241: with one infeed, as a drill with one lip is fed.
void drill_deep(const Drilling& words, const Hole& hole, Spindle& spindle) {
  const double start = words.surface - std::abs(words.start_depth);
  if (words.start_depth != 0) {
    spindle.cut(start + words.clearance, or_else(words.start_feed, words.feed));
  }
  double speed = words.feed;
  if (words.dwell_depth > 0 && words.dwell_depth < -words.depth) {
    spindle.cut(words.surface - words.dwell_depth, speed);
    spindle.dwell(words.bottom_dwell);
    speed *= or_else(words.feed_factor, 100) / 100;
  }
  spindle.cut(hole.bottom, speed);
  spindle.dwell(words.bottom_dwell);
  spindle.cut(hole.top, or_else(words.retract_feed, words.feed));
}

void tap(const Drilling& words, const Hole& hole, double speed, Spindle& spindle) {
  spindle.cut(hole.bottom, speed);
  spindle.dwell(words.bottom_dwell);
  spindle.cut(hole.top, speed);
}

void tap_with_breaks(const Drilling& words, const Hole& hole, double speed, Spindle& spindle) {
  const double back = speed * or_else(words.retract_factor, 1);
  if (words.break_infeed > 0) {
    for (double at = words.surface - words.break_infeed; at > hole.bottom; at -= words.break_infeed) {
      spindle.cut(at, speed);
      spindle.cut(words.break_distance > 0 ? at + words.break_distance : hole.top, back);
    }
  }
  spindle.cut(hole.bottom, speed);
  spindle.cut(hole.top, back);
}

DrillingFault check_back_boring(const Drilling& words) {
  if (!(words.counterbore > 0)) {
    return DrillingFault::counterbore;
  }
  return words.retreat >= 1 && words.retreat < 5 ? DrillingFault::none : DrillingFault::direction;
}

DrillingFault check(int number, const Drilling& words, const DrillingPlace& place) {
  const bool taps_by_pitch = number == 207 || number == 209;
  if (number == 204) {
    return check_back_boring(words);
  }
  if (words.depth > 0) {
    return DrillingFault::depth;
  }
  if (words.by_diameter != 0) {
    return DrillingFault::by_diameter;
  }
  if (taps_by_pitch && (words.pitch == 0 || !(place.spindle_speed > 0))) {
    return DrillingFault::pitch;
  }
  if (number == 208 && !place.tool_radius) {
    return DrillingFault::tool_radius;
  }
  if (number == 241 && words.infeed > 0 && words.infeed < -words.depth) {
    return DrillingFault::infeeds;
  }
  const bool wrong_turns =
      number == 208 && !(words.helix_infeed * most_steps > words.clearance - words.depth);
  return wrong_turns || has_too_many_steps(words) ? DrillingFault::steps : DrillingFault::none;
}

}  // namespace

DrillingFault drill(int number, const Drilling& words, const DrillingPlace& place) {
  const DrillingFault fault = check(number, words, place);
  const bool does_nothing = number != 204 && words.depth == 0;
  if (does_nothing || fault != DrillingFault::none) {
    return does_nothing ? DrillingFault::none : fault;
  }
  const double tapping_speed = std::abs(words.pitch) * place.spindle_speed;
  Spindle spindle(place);
  const Hole hole(words);
  spindle.rapid(hole.top);
  switch (number) {
    case 200:
      drill_in_steps(words, hole, spindle);
      break;
    case 201:
    case 202:
      bore(words, hole, spindle);
      break;
    case 203:
      drill_universal(words, hole, spindle);
      break;
    case 204:
      bore_backwards(words, hole, spindle);
      break;
    case 205:
      peck(words, hole, spindle);
      break;
    case 206:
      tap(words, hole, words.feed, spindle);
      break;
    case 207:
      tap(words, hole, tapping_speed, spindle);
      break;
    case 208:
      run(spindle.plan(), place.path, place.path.position());
      mill_bore(words, hole, place);
      return DrillingFault::none;
    case 209:
      tap_with_breaks(words, hole, tapping_speed, spindle);
      break;
    case 241:
      drill_deep(words, hole, spindle);
      break;
    default:
      spindle.cut(hole.bottom, words.feed);
      spindle.dwell(words.bottom_dwell);
      spindle.rapid(hole.top);
      break;
  }
  spindle.rapid(hole.out);
  run(spindle.plan(), place.path, place.path.position());
  return DrillingFault::none;
}

DrillingFault drill_old(int number, const OldDrilling& words, const DrillingPlace& place) {
  constexpr double shallow = 30;
  constexpr double deepest_stop = 7;
  const double speed = number == 17 ? std::abs(words.pitch) * place.spindle_speed : words.feed;
  if (words.depth == 0) {
    return DrillingFault::none;
  }
  if (number == 17 && !(speed > 0)) {
    return DrillingFault::pitch;
  }
  if (number == 1 && words.infeed != 0 && std::abs(words.depth) > most_steps * std::abs(words.infeed)) {
    return DrillingFault::steps;
  }
  Spindle spindle(place);
  const double start = spindle.height();
  const double down = words.depth < 0 ? -1 : 1;
  const double depth = std::abs(words.depth);
  const double surface = start + down * std::abs(words.clearance);
  const double step = number == 1 && words.infeed != 0 ? std::abs(words.infeed) : depth;
  const double stop = depth <= shallow ? 0.6 : std::min(depth / 50, deepest_stop);
  double reached = 0;
  while (true) {
    reached = std::min(reached + step, depth);
    spindle.cut(surface + down * reached, speed);
    if (reached >= depth) {
      break;
    }
    spindle.rapid(start);
    spindle.rapid(surface + down * std::max(reached - stop, 0.0));
  }
  spindle.dwell(words.dwell);
  if (number == 1) {
    spindle.rapid(start);
  } else {
    spindle.cut(start, speed);
  }
  run(spindle.plan(), place.path, place.path.position());
  return DrillingFault::none;
}

}  // namespace feedscope

#include "core/program/heidenhain/cycles/drilling_cycles.h"

#include <algorithm>
#include <cmath>

#include "core/program/heidenhain/cycles/boring_cycles.h"
#include "core/program/heidenhain/geometry/tool_axis_moves.h"

namespace feedscope::heidenhain {

namespace {

void drill_in_steps(const DrillingParameters& words, const Hole& hole, ToolAxisMoves& moves) {
  const double step = whole_depth_if_none(words);
  double reached = words.surface;
  while (true) {
    const double next = std::max(reached - step, hole.bottom);
    moves.cut(next, words.feed);
    reached = next;
    if (reached <= hole.bottom) {
      break;
    }
    moves.rapid(hole.top);
    moves.dwell(words.top_dwell);
    moves.rapid(std::min(reached + words.clearance, hole.top));
  }
  moves.dwell(words.bottom_dwell);
  moves.rapid(hole.top);
}

constexpr double min_step = 1e-3;

/// Infeed after `step`: decreased, but not below the smallest one.
double smaller(double step, const DrillingParameters& words) {
  return std::max(step - words.decrement, std::min(step, std::max(words.min_infeed, min_step)));
}

constexpr double max_steps = 10000;

bool has_too_many_steps(const DrillingParameters& words) {
  double step = whole_depth_if_none(words);
  if (words.decrement != 0) {
    step = std::min(step, std::max(words.min_infeed, min_step));
  }
  if (words.break_infeed > 0) {
    step = std::min(step, words.break_infeed);
  }
  return -words.depth > max_steps * step || words.decrement < 0;
}

void drill_universal(const DrillingParameters& words, const Hole& hole, ToolAxisMoves& moves) {
  const double back = or_else(words.retract_feed, words.feed);
  double step = whole_depth_if_none(words);
  double reached = words.surface;
  double breaks = 0;
  while (true) {
    reached = std::max(reached - step, hole.bottom);
    moves.cut(reached, words.feed);
    if (reached <= hole.bottom) {
      break;
    }
    if (breaks < words.breaks) {
      ++breaks;
      moves.cut(reached + words.break_distance, back);
    } else {
      breaks = 0;
      moves.cut(hole.top, back);
      moves.dwell(words.top_dwell);
      moves.rapid(std::min(reached + words.clearance, hole.top));
    }
    step = smaller(step, words);
  }
  moves.dwell(words.bottom_dwell);
  moves.cut(hole.top, back);
}

/// From `from` down to `to`, with chip breaks.
void peck_once(const DrillingParameters& words, double from, double to, ToolAxisMoves& moves) {
  if (words.break_infeed > 0) {
    for (double at = from - words.break_infeed; at > to; at -= words.break_infeed) {
      moves.cut(at, words.feed);
      moves.cut(at + words.break_distance, words.feed);
    }
  }
  moves.cut(to, words.feed);
}

void peck(const DrillingParameters& words, const Hole& hole, ToolAxisMoves& moves) {
  double reached = words.surface - std::abs(words.start_depth);
  if (words.start_depth != 0) {
    moves.cut(reached + words.clearance, or_else(words.start_feed, words.feed));
  }
  const double whole = reached - hole.bottom;
  const double first = whole_depth_if_none(words);
  double step = first;
  while (true) {
    const double next = std::max(reached - step, hole.bottom);
    peck_once(words, reached, next, moves);
    reached = next;
    if (reached <= hole.bottom) {
      break;
    }
    moves.rapid(hole.top);
    const double done = std::clamp(1 - (reached - hole.bottom) / whole, 0.0, 1.0);
    const double stop = words.upper_stop + done * (words.lower_stop - words.upper_stop);
    moves.rapid(std::min(reached + stop, hole.top));
    step = smaller(step, words);
  }
  moves.dwell(words.bottom_dwell);
  moves.cut(hole.top, or_else(words.retract_feed, words.feed));
}

/// Cycle 241: with a single infeed, as for a single-lip drill.
void drill_deep(const DrillingParameters& words, const Hole& hole, ToolAxisMoves& moves) {
  const double start = words.surface - std::abs(words.start_depth);
  if (words.start_depth != 0) {
    moves.cut(start + words.clearance, or_else(words.start_feed, words.feed));
  }
  double speed = words.feed;
  if (words.dwell_depth > 0 && words.dwell_depth < -words.depth) {
    moves.cut(words.surface - words.dwell_depth, speed);
    moves.dwell(words.bottom_dwell);
    speed *= or_else(words.feed_factor, 100) / 100;
  }
  moves.cut(hole.bottom, speed);
  moves.dwell(words.bottom_dwell);
  moves.cut(hole.top, or_else(words.retract_feed, words.feed));
}

/// Cycles 206, 207 and 209; `speed` in mm/s.
Tapping thread_of(const DrillingParameters& words, const Hole& hole, double speed) {
  speed = std::isinf(speed) ? 0 : speed;  // as fast as the axes allow
  return {.safe = hole.top,
          .surface = words.surface,
          .bottom = hole.bottom,
          .dwell = words.bottom_dwell,
          .down = DrillFeed{speed},
          .back = DrillFeed{speed}};
}

Tapping thread_with_breaks(const DrillingParameters& words, const Hole& hole, double speed) {
  Tapping thread = thread_of(words, hole, speed);
  thread.stroke = words.break_infeed;
  thread.lift = words.break_distance;
  thread.back->value *= or_else(words.retract_factor, 1);
  return thread;
}

DrillingFault check_back_boring(const DrillingParameters& words) {
  if (!(words.counterbore > 0)) {
    return DrillingFault::counterbore;
  }
  return words.retreat >= 1 && words.retreat < 5 ? DrillingFault::none : DrillingFault::direction;
}

DrillingFault check(int number, const DrillingParameters& words, const DrillingPlace& place) {
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
  const bool wrong_turns = number == 208 && !(words.helix_infeed * max_steps > words.clearance - words.depth);
  return wrong_turns || has_too_many_steps(words) ? DrillingFault::steps : DrillingFault::none;
}

}  // namespace

DrillingFault drill(int number, const DrillingParameters& words, const DrillingPlace& place) {
  const DrillingFault fault = check(number, words, place);
  const bool does_nothing = number != 204 && words.depth == 0;
  if (does_nothing || fault != DrillingFault::none) {
    return does_nothing ? DrillingFault::none : fault;
  }
  const double tapping_speed = std::abs(words.pitch) * place.spindle_speed;
  ToolAxisMoves moves(place);
  const Hole hole(words);
  moves.rapid(hole.top);
  switch (number) {
    case 200:
      drill_in_steps(words, hole, moves);
      break;
    case 201:
    case 202:
      bore(words, hole, moves);
      break;
    case 203:
      drill_universal(words, hole, moves);
      break;
    case 204:
      bore_backwards(words, hole, moves);
      break;
    case 205:
      peck(words, hole, moves);
      break;
    case 206:
      moves.tap(thread_of(words, hole, words.feed));
      break;
    case 207:
      moves.tap(thread_of(words, hole, tapping_speed));
      break;
    case 208:
      run(moves.plan(), place.path, place.path.position());
      mill_bore(words, hole, place);
      return DrillingFault::none;
    case 209:
      moves.tap(thread_with_breaks(words, hole, tapping_speed));
      break;
    case 241:
      drill_deep(words, hole, moves);
      break;
    default:
      moves.cut(hole.bottom, words.feed);
      moves.dwell(words.bottom_dwell);
      moves.rapid(hole.top);
      break;
  }
  moves.rapid(hole.out);
  run(moves.plan(), place.path, place.path.position());
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
  if (number == 1 && words.infeed != 0 && std::abs(words.depth) > max_steps * std::abs(words.infeed)) {
    return DrillingFault::steps;
  }
  ToolAxisMoves moves(place);
  const double start = moves.height();
  const double down = words.depth < 0 ? -1 : 1;
  const double depth = std::abs(words.depth);
  const double surface = start + down * std::abs(words.clearance);
  const double step = number == 1 && words.infeed != 0 ? std::abs(words.infeed) : depth;
  const double stop = depth <= shallow ? 0.6 : std::min(depth / 50, deepest_stop);
  double reached = 0;
  while (true) {
    reached = std::min(reached + step, depth);
    moves.cut(surface + down * reached, speed);
    if (reached >= depth) {
      break;
    }
    moves.rapid(start);
    moves.rapid(surface + down * std::max(reached - stop, 0.0));
  }
  moves.dwell(words.dwell);
  if (number == 1) {
    moves.rapid(start);
  } else {
    moves.cut(start, speed);
  }
  run(moves.plan(), place.path, place.path.position());
  return DrillingFault::none;
}

}  // namespace feedscope::heidenhain

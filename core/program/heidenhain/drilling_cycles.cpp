#include "core/program/heidenhain/drilling_cycles.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace feedscope {

namespace {

using D = Drilling;
using P = CycleParameter;
constexpr CycleUnit length = CycleUnit::length;
constexpr CycleUnit feed = CycleUnit::feed;
constexpr CycleUnit plain = CycleUnit::plain;

constexpr P clearance{200, &D::clearance, length, {}};
constexpr P depth{201, &D::depth, length, {}};
constexpr P infeed{202, &D::infeed, length, {}};
constexpr P surface{203, &D::surface, length, {}};
constexpr P second_clearance{204, &D::second_clearance, length, {}};
constexpr P plunge_feed{206, &D::feed, feed, {}};
constexpr P bottom_dwell{211, &D::bottom_dwell, plain, 0};
constexpr P retract_feed{208, &D::retract_feed, feed, 0};
constexpr P top_dwell{210, &D::top_dwell, plain, 0};
constexpr P decrement{212, &D::decrement, length, 0};
constexpr P least_infeed{205, &D::least_infeed, length, 0};
constexpr P break_distance{256, &D::break_distance, length, 0.2};
constexpr P break_infeed{257, &D::break_infeed, length, 0};
constexpr P pitch{239, &D::pitch, length, {}};

constexpr std::array drilling{clearance, depth,   plunge_feed,      infeed,
                              top_dwell, surface, second_clearance, bottom_dwell};
constexpr std::array reaming{clearance,    depth,   plunge_feed,     bottom_dwell,
                             retract_feed, surface, second_clearance};
constexpr std::array boring{clearance,    depth,   plunge_feed,      bottom_dwell,
                            retract_feed, surface, second_clearance, P{214, &D::retreat, plain, 0}};
constexpr std::array universal_drilling{clearance,        depth,        plunge_feed,
                                        infeed,           top_dwell,    surface,
                                        second_clearance, decrement,    P{213, &D::breaks, plain, 0},
                                        least_infeed,     bottom_dwell, retract_feed,
                                        break_distance};
constexpr std::array pecking{clearance,
                             depth,
                             plunge_feed,
                             infeed,
                             surface,
                             second_clearance,
                             decrement,
                             least_infeed,
                             P{258, &D::upper_stop, length, 0.2},
                             P{259, &D::lower_stop, length, 0.2},
                             break_infeed,
                             break_distance,
                             bottom_dwell,
                             P{379, &D::start_depth, length, 0},
                             P{253, &D::start_feed, feed, 0},
                             retract_feed};
constexpr std::array tapping{clearance, depth, plunge_feed, bottom_dwell, surface, second_clearance};
constexpr std::array rigid_tapping{clearance, depth, pitch, surface, second_clearance};
constexpr std::array bore_milling{clearance,
                                  depth,
                                  plunge_feed,
                                  P{334, &D::helix_infeed, length, {}},
                                  surface,
                                  second_clearance,
                                  P{335, &D::diameter, length, {}},
                                  P{351, &D::climb, plain, 1}};
constexpr std::array breaking_tapping{clearance,        depth,        pitch,         surface,
                                      second_clearance, break_infeed, break_distance};
constexpr std::array centering{
    clearance,       P{343, &D::by_diameter, plain, 0}, depth, plunge_feed, bottom_dwell, surface,
    second_clearance};

/// Moves along the tool axis, at one place of the plane.
class Spindle {
 public:
  explicit Spindle(const DrillingPlace& place)
      : path_(place.path), axis_(normal_axis(place.plane)), plane_(place.plane) {
    path_.set_feed_mode(FeedMode::per_minute);
  }

  double height() const { return path_.position()[axis_]; }
  void rapid(double to) {
    if (to != height()) {
      path_.rapid(at(to));
    }
  }
  void cut(double to, double speed) {
    if (to != height()) {
      path_.set_feed(speed);
      path_.line(at(to));
    }
  }
  void dwell(double seconds) {
    if (seconds > 0) {
      path_.dwell(seconds);
    }
  }
  /// In the plane, by an offset.
  void shift(int direction, double by) {
    Vec3 target = path_.position();
    const int axis = direction % 2 == 1 ? first_axis(plane_) : second_axis(plane_);
    target[axis] += direction <= 2 ? -by : by;
    path_.rapid(target);
  }

 private:
  Vec3 at(double height) const {
    Vec3 target = path_.position();
    target[axis_] = height;
    return target;
  }

  PathWriter& path_;
  int axis_;
  Plane plane_;
};

/// Heights of a hole.
struct Hole {
  explicit Hole(const Drilling& words)
      : top(words.surface + words.clearance),
        bottom(words.surface + words.depth),
        out(words.surface + std::max(words.second_clearance, words.clearance)) {}

  double top;
  double bottom;
  double out;
};

double or_else(double value, double otherwise) {
  return value > 0 ? value : otherwise;
}

double whole_depth_if_none(const Drilling& words) {
  return words.infeed > 0 ? words.infeed : -words.depth;
}

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

void bore(const Drilling& words, const Hole& hole, Spindle& spindle) {
  constexpr double off_the_wall = 0.2;
  spindle.cut(hole.bottom, words.feed);
  spindle.dwell(words.bottom_dwell);
  const bool retreats = words.retreat >= 1 && words.retreat <= 4;
  const int retreat = retreats ? static_cast<int>(words.retreat) : 0;
  if (retreats) {
    spindle.shift(retreat, off_the_wall);
  }
  spindle.cut(hole.top, or_else(words.retract_feed, words.feed));
  spindle.rapid(hole.out);
  if (retreats) {
    spindle.shift(retreat, -off_the_wall);
  }
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

void tap(const Drilling& words, const Hole& hole, double speed, Spindle& spindle) {
  spindle.cut(hole.bottom, speed);
  spindle.dwell(words.bottom_dwell);
  spindle.cut(hole.top, speed);
}

void tap_with_breaks(const Drilling& words, const Hole& hole, double speed, Spindle& spindle) {
  if (words.break_infeed > 0) {
    for (double at = words.surface - words.break_infeed; at > hole.bottom; at -= words.break_infeed) {
      spindle.cut(at, speed);
      spindle.cut(words.break_distance > 0 ? at + words.break_distance : hole.top, speed);
    }
  }
  tap(words, hole, speed, spindle);
}

/// From the centre on a half circle to the wall, down a helix, once round and back to the centre.
void mill_bore(const Drilling& words, const Hole& hole, double radius, const DrillingPlace& place) {
  PathWriter& path = place.path;
  const int axis = normal_axis(place.plane);
  const Vec3 side = Vec3::Unit(first_axis(place.plane));
  Vec3 center = path.position();
  path.set_feed(words.feed);
  ArcRequest arc;
  arc.axis = words.climb < 0 ? Vec3(-normal_of(place.plane)) : normal_of(place.plane);
  const auto half_circle = [&](double direction) {
    arc.target = path.position() + direction * radius * side;
    arc.center = path.position() + direction * radius / 2 * side;
    arc.extra_turns = 0;
    path.arc_by_center(arc);
  };
  half_circle(1);
  const double turns = std::max(1.0, std::ceil((hole.top - hole.bottom) / words.helix_infeed - 1e-9));
  arc.target = path.position();
  arc.target[axis] = hole.bottom;
  arc.center = center;
  arc.extra_turns = turns - 1;
  path.arc_by_center(arc);
  arc.extra_turns = 0;
  path.arc_by_center(arc);
  half_circle(-1);
}

DrillingFault check(int number, const Drilling& words, const DrillingPlace& place) {
  const bool taps_by_pitch = number == 207 || number == 209;
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
  const bool wrong_turns =
      number == 208 && !(words.helix_infeed * most_steps > words.clearance - words.depth);
  return wrong_turns || has_too_many_steps(words) ? DrillingFault::steps : DrillingFault::none;
}

void run_bore_milling(const Drilling& words, const Hole& hole, const DrillingPlace& place, Spindle& spindle) {
  const double radius = words.diameter / 2 - *place.tool_radius;
  if (radius > same_point) {
    mill_bore(words, hole, radius, place);
  } else {
    spindle.cut(hole.bottom, words.feed);
  }
  spindle.rapid(hole.top);
}

}  // namespace

std::span<const CycleParameter> parameters_of_drilling(int number) {
  switch (number) {
    case 200:
      return drilling;
    case 201:
      return reaming;
    case 202:
      return boring;
    case 203:
      return universal_drilling;
    case 205:
      return pecking;
    case 206:
      return tapping;
    case 207:
      return rigid_tapping;
    case 208:
      return bore_milling;
    case 209:
      return breaking_tapping;
    case 240:
      return centering;
    default:
      return {};
  }
}

DrillingFault drill(int number, const Drilling& words, const DrillingPlace& place) {
  const DrillingFault fault = check(number, words, place);
  if (words.depth == 0 || fault != DrillingFault::none) {
    return words.depth == 0 ? DrillingFault::none : fault;
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
      run_bore_milling(words, hole, place, spindle);
      break;
    case 209:
      tap_with_breaks(words, hole, tapping_speed, spindle);
      break;
    default:
      spindle.cut(hole.bottom, words.feed);
      spindle.dwell(words.bottom_dwell);
      spindle.rapid(hole.top);
      break;
  }
  spindle.rapid(hole.out);
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
  return DrillingFault::none;
}

}  // namespace feedscope

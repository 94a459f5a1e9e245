// The part of IsoReader that runs drilling cycles: G73 to G89.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "core/program/cycles/hole_patterns.h"
#include "core/program/iso/drilling_cycle.h"
#include "core/program/iso/iso_reader.h"
#include "core/program/path/plane_points.h"
#include "core/program/text/message.h"

namespace feedscope {

namespace {

constexpr std::string_view axis_letters = "XYZ";
constexpr int fine_boring = 760;
constexpr int back_boring = 870;
/// Lift of a chip break, and distance at which a peck begins; a parameter of the control [mm].
constexpr double clearance = 0.254;
constexpr double most_pecks = 100000;
constexpr double most_repeats = 100000;

DrillingMotion motion_of(int code) {
  switch (code) {
    case 730:
      return DrillingMotion::chip_break;
    case 830:
      return DrillingMotion::peck;
    case fine_boring:
      return DrillingMotion::fine_bore;
    case back_boring:
      return DrillingMotion::back_bore;
    case 740:
    case 840:
    case 842:
    case 843:
    case 850:
    case 890:
      return DrillingMotion::feed_out;
    default:
      return DrillingMotion::rapid_out;
  }
}

bool needs_peck(int code) {
  return code == 730 || code == 830;
}

bool steps_aside(int code) {
  return code == fine_boring || code == back_boring;
}

}  // namespace

void IsoReader::begin_cycle(const GCode& code, const Word& word) {
  const bool threads = words_.has_any("IJ") && !words_.has('R') && !state_.cycle.has_retract;
  if (code.number == fine_boring && (follows_linuxcnc(dialect_) || threads)) {
    report(Severity::error, "unread-g", fine_boring, word.column, [] {
      return Text{"G76 (threading cycle) is not read", "positions are left out up to the next G0 to G3"};
    });
    words_.other_codes = true;
    state_.motion = MotionMode::unread;
    return;
  }
  if (state_.motion != MotionMode::cycle) {
    state_.before_cycle = state_.motion;
    state_.cycle = {};
    state_.motion = MotionMode::cycle;
  }
  state_.cycle.code = code.number;
}

void IsoReader::gather_cycle() {
  CycleState& cycle = state_.cycle;
  const int axis = normal_axis(state_.plane);
  const char depth = axis_letters[static_cast<std::size_t>(axis)];
  if (!cycle.begun) {
    cycle.begun = true;
    cycle.initial = path().position()[axis];
    cycle.retract = cycle.initial;
  }
  if (words_.has('R')) {
    cycle.retract = state_.to_mm(words_['R'].value) + (state_.incremental ? cycle.initial : 0);
    cycle.has_retract = true;
  }
  if (!path().knows(axis)) {
    return_to_retract_plane();
  }
  if (words_.has(depth)) {
    cycle.bottom = state_.to_mm(words_[depth].value);
    cycle.bottom_from_retract = state_.incremental;
    cycle.has_bottom = true;
  }
  gather_pecks();
  if (words_.has('P')) {
    const Word& word = words_['P'];
    cycle.dwell =
        std::max(0.0, follows_linuxcnc(dialect_) || word.has_point ? word.value : word.value / 1000);
  }
}

/// The level before the cycle is not known, so G98 has none to return to.
void IsoReader::return_to_retract_plane() {
  CycleState& cycle = state_.cycle;
  cycle.initial = cycle.retract;
  report(Severity::warning, "unknown-position", 1, words_.first_column("XYZR"), [&] {
    return Text{fmt::format("{} begins while the position of {} is not known", g_name(cycle.code),
                            axis_names[static_cast<std::size_t>(normal_axis(state_.plane))]),
                "the tool returns to R after each hole; program the height before the cycle"};
  });
}

void IsoReader::gather_pecks() {
  CycleState& cycle = state_.cycle;
  const auto length = [&](char letter) {
    return words_.has(letter) ? std::abs(state_.to_mm(words_[letter].value)) : 0;
  };
  if (words_.has('Q')) {
    cycle.peck = length('Q');
    cycle.aside = Vec3::Zero();
  }
  if (follows_linuxcnc(dialect_) || !words_.has_any("IJ")) {
    return;
  }
  if (steps_aside(cycle.code)) {
    const auto way = [&](char letter) { return words_.has(letter) ? state_.to_mm(words_[letter].value) : 0; };
    cycle.aside = {way('I'), way('J'), way('K')};
  } else if (needs_peck(cycle.code) && words_.has('I')) {
    cycle.peck = length('I');
    cycle.peck_less = length('J');
    cycle.peck_least = length('K');
  }
}

bool IsoReader::check_cycle(std::uint32_t column) {
  const CycleState& cycle = state_.cycle;
  const double bottom = cycle.bottom + (cycle.bottom_from_retract ? cycle.retract : 0);
  const char depth = axis_letters[static_cast<std::size_t>(normal_axis(state_.plane))];
  if (!cycle.has_bottom) {
    report(Severity::error, "cycle-words", 0, column, [&] {
      return Text{fmt::format("{} without {}, the bottom of the hole", g_name(cycle.code), depth),
                  "the hole is left out; write it in the cycle's first block"};
    });
    return false;
  }
  if (!cycle.has_retract) {
    report(Severity::error, "cycle-words", 1, column, [&] {
      return Text{fmt::format("{} without R, the retract plane", g_name(cycle.code)),
                  "the level before the cycle is taken; write it in the cycle's first block"};
    });
  }
  if (cycle.code == back_boring ? bottom < cycle.retract : bottom > cycle.retract) {
    report(Severity::error, "cycle-words", 2, column, [&] {
      return Text{fmt::format("the bottom of the hole at {} {:.4f} mm lies on the wrong side of R {:.4f} mm",
                              depth, bottom, cycle.retract),
                  "the hole is left out; correct one of them"};
    });
    return false;
  }
  if (steps_aside(cycle.code) && cycle.peck > 0 && cycle.aside.isZero()) {
    report(Severity::info, "cycle-aside", cycle.code, column, [&] {
      return Text{fmt::format("the direction in which {} moves off the wall is a setting of the control",
                              g_name(cycle.code)),
                  "the positive direction of the plane's first axis is taken"};
    });
  }
  return true;
}

double IsoReader::cycle_repeats() {
  const bool is_least_peck = words_.has('I') && !follows_linuxcnc(dialect_);
  const char letter = words_.has('L') || is_least_peck ? 'L' : 'K';
  if (!words_.has(letter)) {
    return 1;
  }
  const Word& word = words_[letter];
  if (word.value >= 0 && word.value <= most_repeats && word.value == std::floor(word.value)) {
    return word.value;
  }
  report(Severity::error, "cycle-words", 3, word.column, [&] {
    return Text{fmt::format("{}{} is no number of repeats from 0 to {}", letter, word.value, most_repeats),
                "the cycle runs once"};
  });
  return 1;
}

std::optional<DrillingCycle> IsoReader::drilling_cycle(std::uint32_t column, double repeats) {
  const CycleState& state = state_.cycle;
  if (!check_cycle(column)) {
    return std::nullopt;
  }
  DrillingCycle cycle;
  cycle.motion = motion_of(state.code);
  cycle.axis = normal_axis(state_.plane);
  cycle.initial = state.initial;
  cycle.retract = state.retract;
  cycle.bottom = state.bottom + (state.bottom_from_retract ? state.retract : 0);
  cycle.peck = needs_peck(state.code) ? state.peck : 0;
  cycle.peck_least = state.peck_least;
  cycle.peck_less = state.peck_least > 0 ? state.peck_less : 0;
  cycle.clearance = clearance;
  cycle.dwell = state.dwell;
  if (steps_aside(state.code)) {
    cycle.aside =
        state.aside.isZero() ? Vec3(state.peck * Vec3::Unit(first_axis(state_.plane))) : state.aside;
  }
  cycle.to_initial = state_.to_initial_level;
  const bool too_fine = peck_count(cycle) * repeats > most_pecks;
  if (needs_peck(state.code) && (cycle.peck == 0 || too_fine)) {
    report(Severity::error, "cycle-words", 4, words_.has('Q') ? words_['Q'].column : column, [&] {
      return Text{fmt::format("{} {}", g_name(state.code),
                              too_fine ? fmt::format("with pecks of {} mm", cycle.peck) : "without Q"),
                  "the hole is drilled at once; write Q with the depth of a peck"};
    });
    cycle.peck = 0;
  }
  return cycle;
}

void IsoReader::run_cycle() {
  gather_cycle();
  const double repeats = cycle_repeats();
  if (repeats == 0) {
    return;
  }
  if (const std::optional<DrillingCycle> cycle = drilling_cycle(words_.first_column("XYZR"), repeats)) {
    for (double i = 0; i < repeats; ++i) {
      drill(path(), *cycle, target_of_block());
    }
  }
}

/// Haas, about where the tool is: G70 I radius, J first angle, L holes on a circle; G71 the same, K degrees
/// apart; G72 L holes on a line at the angle J, I apart.
void IsoReader::drill_pattern(int code, std::uint32_t column) {
  constexpr int circle = 700;
  constexpr int line = 720;
  const double count = words_.has('L') ? words_['L'].value : 0;
  const bool sound = state_.motion == MotionMode::cycle && state_.cycle.begun && words_.has('I') &&
                     count >= 1 && count <= most_repeats && count == std::floor(count);
  if (!sound) {
    report(Severity::error, "cycle-words", code, column, [&] {
      return Text{fmt::format("{} drills a pattern of holes: it needs a drilling cycle before it, I and L",
                              g_name(code)),
                  "nothing is drilled; the units inch and mm are G20 and G21"};
    });
    return;
  }
  const std::optional<DrillingCycle> cycle = drilling_cycle(column, count);
  if (!cycle) {
    return;
  }
  const double size = state_.to_mm(words_['I'].value);
  const double first = words_.has('J') ? units::from_deg(words_['J'].value) : 0;
  const double apart = words_.has('K') ? units::from_deg(words_['K'].value) : 0;
  const Vec3 from = path().position();
  const Vec2 middle = in_plane(from, state_.plane);
  const int holes = static_cast<int>(count);
  const std::vector<Vec2> places =
      code == line ? places_of(RowPattern{.start = middle, .spacing = size, .angle = first, .count = holes})
                   : places_of(CirclePattern{.center = middle,
                                             .diameter = 2 * size,
                                             .start = first,
                                             .step = code == circle ? 2 * units::pi / count : apart,
                                             .count = holes});
  path().program_axes();
  for (const Vec2& place : places) {
    drill(path(), *cycle, from_plane(place, state_.plane, from));
  }
}

}  // namespace feedscope

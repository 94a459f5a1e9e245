#include "core/program/iso/cycles/cycles.h"

#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "core/program/cycles/hole_patterns.h"
#include "core/program/path/plane_points.h"
#include "core/program/text/message.h"

namespace feedscope::iso {

namespace {

constexpr int fine_boring = 760;
constexpr int back_boring = 870;
constexpr int boring_with_dwell = 890;
/// Lift of a chip break, and distance at which a peck begins; a parameter of the control [mm].
constexpr double clearance = 0.254;
constexpr double max_pecks = 100000;
constexpr double max_repeats = 100000;

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
      return DrillingMotion::tap;
    case 850:
    case boring_with_dwell:
      return DrillingMotion::feed_out;
    default:
      return DrillingMotion::rapid_out;
  }
}

bool needs_peck(int code) {
  return code == 730 || code == 830;
}

/// Q of G74 and G84: rigid tapping in strokes (Fanuc Series 30i operator's manual, peck rigid tapping cycle).
bool may_peck(int code, bool is_linuxcnc) {
  return needs_peck(code) || (motion_of(code) == DrillingMotion::tap && !is_linuxcnc);
}

bool steps_aside(int code) {
  return code == fine_boring || code == back_boring;
}

}  // namespace

void Cycles::begin(const GCode& code, const Word& word) {
  const bool threads = words_.has_any("IJ") && !words_.has('R') && !series_.has_retract;
  if (code.number == fine_boring && (is_linuxcnc() || threads)) {
    report(Severity::error, "unread-g", fine_boring, word.column, [] {
      return Text{NC_("core", "G76 (threading cycle) is not supported"),
                  NC_("core", "positions are skipped up to the next G0 to G3")};
    });
    words_.other_codes = true;
    modal_.motion = MotionMode::unread;
    return;
  }
  if (modal_.motion != MotionMode::cycle) {
    before_ = modal_.motion;
    series_ = {};
    modal_.motion = MotionMode::cycle;
  }
  if (code.number != modal_.cycle_code && motion_of(code.number) == DrillingMotion::tap) {
    // Pecks of a previous drilling cycle are not strokes of a thread.
    series_.peck = 0;
  }
  modal_.cycle_code = code.number;
}

void Cycles::cancel() {
  if (modal_.motion == MotionMode::cycle && !is_linuxcnc()) {
    modal_.motion = before_;
  } else if (is_linuxcnc() || modal_.motion == MotionMode::unread) {
    modal_.after_g80 = modal_.after_g80 || modal_.motion != MotionMode::none;
    modal_.motion = MotionMode::none;
  }
}

void Cycles::gather() {
  const int axis = normal_axis(modal_.plane);
  const char depth = axis_letters[static_cast<std::size_t>(axis)];
  if (!series_.begun) {
    series_.begun = true;
    series_.initial = path().position()[axis];
    series_.retract = series_.initial;
  }
  targets_.check_point('R', Targets::implausible_length);
  if (words_.has('R')) {
    series_.retract = length('R') + (modal_.incremental ? series_.initial : 0);
    series_.has_retract = true;
  }
  if (!path().knows(axis)) {
    return_to_retract_plane();
  }
  if (words_.has(depth)) {
    series_.bottom = length(depth);
    series_.bottom_from_retract = modal_.incremental;
    series_.has_bottom = true;
  }
  gather_pecks();
  if (words_.has('P')) {
    const Word& word = words_['P'];
    series_.dwell = std::max(0.0, is_linuxcnc() || word.has_point ? word.value : word.value / 1000);
  }
}

/// The level before the cycle is not known, so G98 cannot return to it.
void Cycles::return_to_retract_plane() {
  series_.initial = series_.retract;
  report(Severity::warning, "unknown-position", 1, words_.first_column("XYZR"), [&] {
    return Text{
        message(NC_("core", "{} begins while the position of {} is not known"), g_name(modal_.cycle_code),
                coordinate_names[static_cast<std::size_t>(normal_axis(modal_.plane))]),
        NC_("core", "the tool returns to R after each hole; program the height before the cycle")};
  });
}

void Cycles::gather_pecks() {
  targets_.check_point('Q', Targets::implausible_peck);
  if (words_.has('Q')) {
    series_.peck = std::abs(length('Q'));
    series_.aside = Vec3::Zero();
  }
  if (is_linuxcnc() || !words_.has_any("IJ")) {
    return;
  }
  if (steps_aside(modal_.cycle_code)) {
    series_.aside = {length_or('I', 0), length_or('J', 0), length_or('K', 0)};
  } else if (needs_peck(modal_.cycle_code) && words_.has('I')) {
    series_.peck = std::abs(length('I'));
    series_.peck_less = std::abs(length_or('J', 0));
    series_.peck_least = std::abs(length_or('K', 0));
  }
}

bool Cycles::check(std::uint32_t column) const {
  const double bottom = this->bottom();
  const char depth = axis_letters[static_cast<std::size_t>(normal_axis(modal_.plane))];
  if (!series_.has_bottom) {
    report(Severity::error, "cycle-words", 0, column, [&] {
      return Text{
          message(NC_("core", "{} without {}, the bottom of the hole"), g_name(modal_.cycle_code), depth),
          NC_("core", "the hole is skipped; program it in the cycle's first block")};
    });
    return false;
  }
  if (!series_.has_retract) {
    report(Severity::error, "cycle-words", 1, column, [&] {
      return Text{message(NC_("core", "{} without R, the retract plane"), g_name(modal_.cycle_code)),
                  NC_("core", "the level before the cycle is used; program it in the cycle's first block")};
    });
  }
  if (modal_.cycle_code == back_boring ? bottom < series_.retract : bottom > series_.retract) {
    report(Severity::error, "cycle-words", 2, column, [&] {
      return Text{
          message(NC_("core", "the bottom of the hole at {} {:.4f} mm is on the wrong side of R {:.4f} mm"),
                  depth, bottom, series_.retract),
          NC_("core", "the hole is skipped; correct one of them")};
    });
    return false;
  }
  if (steps_aside(modal_.cycle_code) && series_.peck > 0 && series_.aside.isZero()) {
    report(Severity::info, "cycle-aside", modal_.cycle_code, column, [&] {
      return Text{
          message(NC_("core", "the direction in which {} retracts from the wall is a control setting"),
                  g_name(modal_.cycle_code)),
          NC_("core", "the positive direction of the plane's first axis is used")};
    });
  }
  return true;
}

double Cycles::repeats() const {
  const bool is_least_peck = words_.has('I') && !is_linuxcnc();
  const char letter = words_.has('L') || is_least_peck ? 'L' : 'K';
  if (!words_.has(letter)) {
    return 1;
  }
  const Word& word = words_[letter];
  if (word.value >= 0 && word.value <= max_repeats && word.value == std::floor(word.value)) {
    return word.value;
  }
  report(Severity::error, "cycle-words", 3, word.column, [&] {
    return Text{
        message(NC_("core", "{}{} is not a number of repeats from 0 to {}"), letter, word.value, max_repeats),
        NC_("core", "the cycle runs once")};
  });
  return 1;
}

std::optional<DrillingCycle> Cycles::drilling_cycle(std::uint32_t column, double repeats) const {
  if (!check(column)) {
    return std::nullopt;
  }
  DrillingCycle cycle;
  cycle.motion = motion_of(modal_.cycle_code);
  cycle.axis = normal_axis(modal_.plane);
  cycle.initial = series_.initial;
  cycle.retract = series_.retract;
  cycle.bottom = this->bottom();
  cycle.peck = may_peck(modal_.cycle_code, is_linuxcnc()) ? series_.peck : 0;
  cycle.peck_least = series_.peck_least;
  cycle.peck_less = series_.peck_least > 0 ? series_.peck_less : 0;
  cycle.clearance = clearance;
  cycle.dwell = series_.dwell;
  if (steps_aside(modal_.cycle_code)) {
    cycle.aside =
        series_.aside.isZero() ? Vec3(series_.peck * Vec3::Unit(first_axis(modal_.plane))) : series_.aside;
  }
  cycle.to_initial = modal_.to_initial_level;
  cycle.feeds_to_the_end = is_linuxcnc() && modal_.cycle_code == boring_with_dwell;
  const bool too_fine = peck_count(cycle) * repeats > max_pecks;
  if (too_fine || (needs_peck(modal_.cycle_code) && cycle.peck == 0)) {
    report(Severity::error, "cycle-words", 4, words_.column_or('Q', column), [&] {
      return Text{too_fine
                      ? message(NC_("core", "{} with pecks of {} mm"), g_name(modal_.cycle_code), cycle.peck)
                      : message(NC_("core", "{} without {}"), g_name(modal_.cycle_code), 'Q'),
                  NC_("core", "the hole is drilled in one infeed; write Q with the depth of a peck")};
    });
    cycle.peck = 0;
  }
  return cycle;
}

void Cycles::run() {
  gather();
  const double repeats = this->repeats();
  if (repeats == 0) {
    return;
  }
  if (const std::optional<DrillingCycle> cycle = drilling_cycle(words_.first_column("XYZR"), repeats)) {
    const PathControl modal = path().path_control();
    if (is_linuxcnc()) {  // it runs cycles as under G61, but not the way up before them
      rise(path(), *cycle);
      PathControl exact = modal;
      exact.mode = PathMode::exact_stop;
      exact.exact_path = true;
      path().set_path_control(exact);
    }
    for (double i = 0; i < repeats; ++i) {
      drill(path(), *cycle, targets_.target());
    }
    path().set_path_control(modal);
  }
}

/// G70 I radius, J first angle, L holes on a circle; G71 the same, K degrees
/// apart; G72 L holes on a line at the angle J, I apart.
void Cycles::run_pattern(int code, std::uint32_t column) {
  constexpr int circle = 700;
  constexpr int line = 720;
  const double count = words_.value_or('L', 0);
  const bool sound = modal_.motion == MotionMode::cycle && series_.begun && words_.has('I') && count >= 1 &&
                     count <= max_repeats && count == std::floor(count);
  if (!sound) {
    report(Severity::error, "cycle-words", code, column, [&] {
      return Text{
          message(NC_("core", "{} (hole pattern) needs an active drilling cycle, I and L"), g_name(code)),
          NC_("core", "nothing is drilled; for the units inch and mm program G20 or G21")};
    });
    return;
  }
  const std::optional<DrillingCycle> cycle = drilling_cycle(column, count);
  if (!cycle) {
    return;
  }
  const double size = length('I');
  const double first = units::from_deg(words_.value_or('J', 0));
  const double apart = units::from_deg(words_.value_or('K', 0));
  const Vec3 from = path().position();
  const Vec2 middle = in_plane(from, modal_.plane);
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
    drill(path(), *cycle, from_plane(place, modal_.plane, from));
  }
}

}  // namespace feedscope::iso

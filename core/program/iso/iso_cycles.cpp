// The part of IsoReader that runs drilling cycles: G73 to G89.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/program/iso/iso_reader.h"
#include "core/program/path/drilling_cycle.h"
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
  if (code.number == fine_boring && (follows_linuxcnc(dialect_) || words_.has_any("IJ"))) {
    report(Severity::error, "unread-g", fine_boring, word.column, [] {
      return Text{"G76 (threading cycle) is not read", "positions are left out up to the next G0 to G3"};
    });
    words_.other_codes = true;
    state_.motion = MotionMode::unread;
    return;
  }
  if (state_.motion != MotionMode::cycle) {
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
  if (words_.has(depth)) {
    cycle.bottom = state_.to_mm(words_[depth].value);
    cycle.bottom_from_retract = state_.incremental;
    cycle.has_bottom = true;
  }
  if (words_.has('Q')) {
    cycle.peck = std::abs(state_.to_mm(words_['Q'].value));
  }
  if (words_.has('P')) {
    const Word& word = words_['P'];
    cycle.dwell =
        std::max(0.0, follows_linuxcnc(dialect_) || word.has_point ? word.value : word.value / 1000);
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
  if (steps_aside(cycle.code) && cycle.peck > 0) {
    report(Severity::info, "cycle-aside", cycle.code, column, [&] {
      return Text{fmt::format("the direction in which {} moves off the wall is a setting of the control",
                              g_name(cycle.code)),
                  "the positive direction of the plane's first axis is taken"};
    });
  }
  return true;
}

double IsoReader::cycle_repeats() {
  const char letter = words_.has('L') ? 'L' : 'K';
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

void IsoReader::run_cycle() {
  gather_cycle();
  const double repeats = cycle_repeats();
  const std::uint32_t column = words_.first_column("XYZR");
  const CycleState& state = state_.cycle;
  if (repeats == 0 || !check_cycle(column)) {
    return;
  }
  DrillingCycle cycle;
  cycle.motion = motion_of(state.code);
  cycle.axis = normal_axis(state_.plane);
  cycle.initial = state.initial;
  cycle.retract = state.retract;
  cycle.bottom = state.bottom + (state.bottom_from_retract ? state.retract : 0);
  cycle.peck = needs_peck(state.code) ? state.peck : 0;
  cycle.clearance = clearance;
  cycle.dwell = state.dwell;
  cycle.aside =
      steps_aside(state.code) ? Vec3(state.peck * Vec3::Unit(first_axis(state_.plane))) : Vec3::Zero();
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
  for (double i = 0; i < repeats; ++i) {
    drill(path(), cycle, target_of_block());
  }
}

}  // namespace feedscope

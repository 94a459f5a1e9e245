// The motion half of IsoReader: what a block whose words are gathered moves.
#include <fmt/format.h>

#include <cmath>

#include "core/program/iso_reader.h"

namespace feedscope {

namespace {

using Text = DiagnosticLog::Text;

constexpr std::string_view axis_letters = "XYZ";
constexpr std::string_view center_letters = "IJK";
constexpr std::string_view straight_instead = "a straight line to the end is taken instead";

}  // namespace

void IsoReader::move() {
  if (words_.dwell > 0) {
    dwell();
    return;
  }
  const bool is_arc = state_.motion == MotionMode::arc_cw || state_.motion == MotionMode::arc_ccw;
  const bool moves = words_.has_any("XYZ") || (is_arc && words_.has_any("IJKR"));
  if (words_.own_words || !moves) {
    return;
  }
  if (state_.motion == MotionMode::none) {
    report(Severity::warning, "motion-mode", 0, words_.first_column("XYZ"), [] {
      return Text{"position words before any of G0, G1, G2, G3", "taken as G0; write the G word"};
    });
    state_.motion = MotionMode::rapid;
  }
  const Vec3 target = target_of_block();
  switch (state_.motion) {
    case MotionMode::rapid:
      add_motion(Motion::rapid, target);
      break;
    case MotionMode::line:
      add_motion(Motion::line, target);
      break;
    case MotionMode::arc_cw:
    case MotionMode::arc_ccw:
      arc(target);
      break;
    case MotionMode::none:
    case MotionMode::unread:
      break;
  }
}

void IsoReader::dwell() {
  constexpr double shortest_plain_p = 50;
  for (const char letter : {'P', 'X', 'U', 'F'}) {
    if (!words_.has(letter)) {
      continue;
    }
    const Word& word = words_[letter];
    if (word.value < 0) {
      report(Severity::error, "dwell-time", 0, word.column, [&] {
        return Text{fmt::format("dwell time {}{} is negative", letter, word.value), "the dwell is left out"};
      });
      return;
    }
    const bool milliseconds = letter == 'P' && !word.has_point;
    if (milliseconds && word.value > 0 && word.value < shortest_plain_p) {
      report(Severity::info, "dwell-unit", 0, word.column, [&] {
        return Text{fmt::format("P{0} without a decimal point is taken as {0} milliseconds", word.value),
                    fmt::format("write P{}.0 for seconds", word.value)};
      });
    }
    if (word.value > 0) {
      MotionBlock block;
      block.target = state_.position;
      block.dwell = milliseconds ? word.value / 1000 : word.value;
      block.line = line_;
      block.motion = Motion::dwell;
      program_.motions.push_back(block);
    }
    return;
  }
  report(Severity::error, "dwell-time", 1, words_.dwell, [] {
    return Text{"G4 without a time", "the dwell is left out; write P, X or U with the time"};
  });
}

void IsoReader::arc(const Vec3& target) {
  if (!words_.has_any("IJKR")) {
    report(Severity::error, "arc-center", 0, words_.first_column("XYZ"), [] {
      return Text{"the arc has neither a centre (I, J, K) nor a radius (R)", std::string(straight_instead)};
    });
    add_motion(Motion::line, target);
    return;
  }
  if (words_.has('R') && words_.has_any("IJK")) {
    report(Severity::error, "arc-center", 1, words_.first_column("IJK"), [] {
      return Text{"the arc has both a centre (I, J, K) and a radius (R)", "R counts; remove one of them"};
    });
  }
  const Vec3 normal = normal_of(state_.plane);
  const Vec3 axis = state_.motion == MotionMode::arc_ccw ? normal : Vec3(-normal);
  ArcSolution solution;
  if (words_.has('R')) {
    const double radius = state_.to_mm(words_['R'].value);
    solution = solve_radius_arc(state_.position, target, radius, axis, extra_turns());
  } else {
    check_center_axis();
    const Vec3 center = center_of_block(state_.absolute_centers);
    solution = solve_center_arc(state_.position, target, center, axis, extra_turns());
  }
  if (solution.fault != ArcFault::none) {
    report_arc_fault(solution, target, axis);
    add_motion(Motion::line, target);
    return;
  }
  for (int i = 0; i < solution.count; ++i) {
    const ArcSolution::Piece& piece = solution.pieces[static_cast<std::size_t>(i)];
    program_.arcs.push_back(piece.words);
    add_motion(Motion::arc, piece.target, static_cast<std::int32_t>(program_.arcs.size() - 1));
  }
}

double IsoReader::extra_turns() {
  constexpr double most_turns = 10000;
  if (!words_.has('P')) {
    return 0;
  }
  const Word& word = words_['P'];
  if (word.value >= 1 && word.value <= most_turns && word.value == std::floor(word.value)) {
    return word.value - 1;
  }
  report(Severity::error, "arc-turns", 0, word.column, [&] {
    return Text{fmt::format("P{} is not a number of turns from 1 to {}", word.value, most_turns),
                "one turn is taken"};
  });
  return 0;
}

void IsoReader::check_center_axis() {
  const char letter = center_letters[static_cast<std::size_t>(state_.plane)];
  if (words_.has(letter) && words_[letter].value != 0 && !state_.absolute_centers) {
    report(Severity::warning, "unused-word", letter, words_[letter].column, [&] {
      return Text{fmt::format("{}{} lies across the plane of the arc", letter, words_[letter].value),
                  "it is left out; is a G17, G18 or G19 missing?"};
    });
  }
}

void IsoReader::report_arc_fault(const ArcSolution& solution, const Vec3& target, const Vec3& axis) {
  const std::uint32_t column = words_.first_column(words_.has('R') ? "R" : "IJK");
  switch (solution.fault) {
    case ArcFault::none:
      break;
    case ArcFault::center_at_start:
      report(Severity::error, "arc-center", 2, column, [] {
        return Text{"the arc's centre is its start point", std::string(straight_instead)};
      });
      break;
    case ArcFault::radius_mismatch:
      report(Severity::error, "arc-radius", 0, column, [&] {
        const Vec3 other_center = center_of_block(!state_.absolute_centers);
        const ArcSolution other = solve_center_arc(state_.position, target, other_center, axis, 0);
        const std::string_view other_mode = state_.absolute_centers ? "offset (G91.1)" : "position (G90.1)";
        const std::string advice = other.fault == ArcFault::none
                                       ? fmt::format("the centre would fit as a {}", other_mode)
                                       : "check the centre";
        return Text{fmt::format("the arc's radius is {:.4f} mm at its start but {:.4f} mm at its end",
                                solution.start_radius, solution.end_radius),
                    fmt::format("{}; {}", advice, straight_instead)};
      });
      break;
    case ArcFault::radius_too_small:
      report(Severity::error, "arc-radius", 1, column, [&] {
        return Text{fmt::format("radius {:.4f} mm is too small for ends {:.4f} mm apart",
                                solution.start_radius, 2 * solution.end_radius),
                    fmt::format("write R of at least half the distance; {}", straight_instead)};
      });
      break;
    case ArcFault::same_ends:
      report(Severity::error, "arc-ends", 0, column, [] {
        return Text{"an arc with R must not end where it starts", "write a full circle with I, J, K"};
      });
      break;
  }
}

double IsoReader::usable_feed() {
  if (state_.feed == 0 && state_.feed_per_minute && !feed_missed_) {
    feed_missed_ = true;
    report(Severity::error, "feed-missing", 0, words_.first_column("XYZIJKR"), [] {
      return Text{"a feed move without a feed", "it runs as fast as the axes allow; write F before it"};
    });
  }
  return state_.feed;
}

void IsoReader::add_motion(Motion motion, const Vec3& target, std::int32_t arc_index) {
  extend_bounds(motion, target);
  MotionBlock block;
  block.target = target;
  block.feed = motion == Motion::rapid ? 0 : usable_feed();
  block.line = line_;
  block.arc = arc_index;
  block.motion = motion;
  program_.motions.push_back(block);
  state_.position = target;
}

void IsoReader::extend_bounds(Motion motion, const Vec3& target) {
  for (int axis = 0; axis < 3; ++axis) {
    bool& known = axis_known_[static_cast<std::size_t>(axis)];
    if (!known && motion != Motion::rapid) {
      program_.bounds.add(axis, state_.position[axis]);
      known = true;
    }
    known = known || words_.has(axis_letters[static_cast<std::size_t>(axis)]);
    if (known) {
      program_.bounds.add(axis, target[axis]);
    }
  }
}

Vec3 IsoReader::target_of_block() const {
  Vec3 target = state_.position;
  for (int axis = 0; axis < 3; ++axis) {
    const char letter = axis_letters[static_cast<std::size_t>(axis)];
    if (words_.has(letter)) {
      const double value = state_.to_mm(words_[letter].value);
      target[axis] = state_.incremental ? target[axis] + value : value;
    }
  }
  return target;
}

Vec3 IsoReader::center_of_block(bool absolute) const {
  Vec3 center = state_.position;
  for (int axis = 0; axis < 3; ++axis) {
    const char letter = center_letters[static_cast<std::size_t>(axis)];
    if (words_.has(letter)) {
      const double value = state_.to_mm(words_[letter].value);
      center[axis] = absolute ? value : center[axis] + value;
    }
  }
  return center;
}

}  // namespace feedscope

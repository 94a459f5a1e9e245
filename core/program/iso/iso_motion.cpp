// The motion half of IsoReader: what a block whose words are gathered moves.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "core/base/units.h"
#include "core/program/iso/iso_reader.h"
#include "core/program/iso/printer_words.h"

namespace feedscope {

namespace {

constexpr std::string_view axis_letters = "XYZ";
constexpr std::string_view center_letters = "IJK";
constexpr std::string_view straight_instead = "a straight line to the end is taken instead";

/// Its interpreter takes 2 sqrt(2) of 0.01 mm or 0.001 inch, or 0.1 %, but not a hundred times the former.
ArcTolerance linuxcnc_tolerance(bool inch) {
  const double least = 2 * std::numbers::sqrt2 * (inch ? units::from_inch(0.001) : 0.01);
  return {least, 0.001, 100 * least};
}

}  // namespace

void IsoReader::move() {
  if (words_.dwell > 0) {
    dwell();
    return;
  }
  const bool is_arc = state_.motion == MotionMode::arc_cw || state_.motion == MotionMode::arc_ccw;
  const bool is_cycle = state_.motion == MotionMode::cycle;
  const bool is_spline = state_.motion == MotionMode::spline;
  const bool moves = words_.has_any("XYZ") || words_.has_polar() || (is_arc && words_.has_any("IJKR")) ||
                     (is_cycle && words_.has('R')) ||
                     (is_spline && (words_.has('P') || (state_.spline.code == 62 && words_.has('K'))));
  if (words_.own_words || !moves) {
    cut_corner(false);
    return;
  }
  if (state_.motion == MotionMode::none) {
    report(Severity::warning, "motion-mode", 0, words_.first_column("XYZ"), [] {
      return Text{"position words before any of G0, G1, G2, G3", "taken as G0; write the G word"};
    });
    state_.motion = MotionMode::rapid;
  }
  if (!nurbs_.points.empty() && !is_spline) {
    finish();
  }
  program_axes_of_block();
  path().set_column(words_.first_column("XYZIJKR"));
  cut_corner(is_arc || state_.motion == MotionMode::line);
  if (is_cycle) {
    run_cycle();
    return;
  }
  check_inverse_time();
  if (is_spline) {
    run_spline();
    return;
  }
  const Vec3 target = target_of_block();
  switch (state_.motion) {
    case MotionMode::rapid:
      path().rapid(target);
      break;
    case MotionMode::line:
      path().line(target);
      break;
    case MotionMode::arc_cw:
    case MotionMode::arc_ccw:
      arc(target);
      break;
    case MotionMode::none:
    case MotionMode::cycle:
    case MotionMode::spline:
    case MotionMode::unread:
      break;
  }
}

void IsoReader::program_axes_of_block() {
  for (int axis = 0; axis < 3; ++axis) {
    const char letter = axis_letters[static_cast<std::size_t>(axis)];
    if (words_.has(letter) || (words_.has_polar() && axis < 2)) {
      path().program_axis(axis, state_.incremental && words_.has(letter));
      check_point(letter);
    }
  }
}

/// Beyond any machine's travel, but not in the thousandths that many controls take numbers without a point
/// for.
void IsoReader::check_point(char letter) {
  constexpr double least_mm = 3000;
  constexpr double least_inch = 120;
  const Word& word = words_[letter];
  if (follows_linuxcnc(dialect_) || word.has_point || !words_.has(letter) ||
      std::abs(word.value) < (state_.inch ? least_inch : least_mm)) {
    return;
  }
  report(Severity::warning, "decimal-point", 0, word.column, [&] {
    return Text{fmt::format("{}{:.0f} without a decimal point is taken as {:.0f} {}", letter, word.value,
                            word.value, state_.inch ? "inch" : "mm"),
                state_.inch ? "many controls take it in units of 0.0001 inch; write a point"
                            : "many controls take it in units of 0.001 mm; write a point"};
  });
}

void IsoReader::check_inverse_time() {
  const bool at_feed = state_.motion != MotionMode::rapid && state_.motion != MotionMode::unread;
  if (path().feed_mode() == FeedMode::inverse_time && at_feed && !words_.has('F') && path().feed() > 0) {
    report(Severity::error, "feed-missing", 1, words_.first_column("XYZIJKR"), [] {
      return Text{"a feed move without F under G93", "the last F is taken; write F in every such block"};
    });
  }
}

/// ",R" and ",C": at the end of the motion that follows.
void IsoReader::cut_corner(bool at_line_or_arc) {
  if (words_.corner == nullptr) {
    return;
  }
  const Word& word = *words_.corner;
  if (!at_line_or_arc || !(word.value > 0)) {
    report(Severity::error, "corner", at_line_or_arc ? 2 : 3, word.column, [&] {
      return Text{at_line_or_arc ? fmt::format("a rounding or chamfer of {} is not above zero", word.value)
                                 : fmt::format(",{} in a block that is no line or arc", word.letter),
                  "the corner stays sharp; write it in the G1, G2 or G3 block that ends at the corner"};
    });
    return;
  }
  CornerCut cut;
  cut.kind = word.letter == 'R' ? CornerCut::Kind::rounding : CornerCut::Kind::chamfer;
  cut.size = state_.to_mm(word.value);
  cut.at_feed_only = true;
  cut.place = place(word.column);
  path().cut_next_corner(cut, state_.plane);
}

bool IsoReader::is_printer() {
  if (!is_printer_) {
    is_printer_ = dialect_ == Dialect::grbl && is_for_printer(*main_text());
  }
  return *is_printer_;
}

void IsoReader::dwell() {
  constexpr double shortest_plain_p = 50;
  for (const char letter : {'P', 'X', 'U', 'F', 'S'}) {
    if (!words_.has(letter) || (letter == 'S' && !is_printer())) {
      continue;
    }
    const Word& word = words_[letter];
    if (word.value < 0) {
      report(Severity::error, "dwell-time", 0, word.column, [&] {
        return Text{fmt::format("dwell time {}{} is negative", letter, word.value), "the dwell is left out"};
      });
      return;
    }
    const bool milliseconds =
        letter == 'P' && (is_printer() || (!word.has_point && !follows_linuxcnc(dialect_)));
    if (milliseconds && dialect_ == Dialect::iso && word.value > 0 && word.value < shortest_plain_p) {
      report(Severity::info, "dwell-unit", 0, word.column, [&] {
        return Text{fmt::format("P{0} without a decimal point is taken as {0} milliseconds", word.value),
                    fmt::format("write P{}.0 for seconds", word.value)};
      });
    }
    const bool long_seconds = letter == 'P' && !milliseconds && !word.has_point &&
                              dialect_ == Dialect::grbl && word.value >= shortest_plain_p;
    if (long_seconds) {
      report(Severity::info, "dwell-unit", 1, word.column, [&] {
        return Text{fmt::format("P{0} is taken as {0} seconds, as grbl does", word.value),
                    fmt::format("for a control that takes milliseconds, write P{}", word.value / 1000)};
      });
    }
    if (word.value > 0) {
      path().dwell(milliseconds ? word.value / 1000 : word.value);
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
    path().line(target);
    return;
  }
  if (words_.has('R') && words_.has_any("IJK")) {
    report(Severity::error, "arc-center", 1, words_.first_column("IJK"), [] {
      return Text{"the arc has both a centre (I, J, K) and a radius (R)", "R counts; remove one of them"};
    });
  }
  const Vec3 normal = normal_of(state_.plane);
  ArcRequest request;
  request.target = target;
  request.axis = state_.motion == MotionMode::arc_ccw ? normal : Vec3(-normal);
  request.column = words_.has('R') ? words_.first_column("R") : words_.first_column("IJK");
  request.extra_turns = extra_turns();
  if (words_.has('R')) {
    request.radius = state_.to_mm(words_['R'].value);
    path().arc_by_radius(request);
  } else {
    check_center_axis();
    if (dialect_ == Dialect::linuxcnc) {
      request.tolerance = linuxcnc_tolerance(state_.inch);
    }
    request.center = center_of_block(state_.absolute_centers);
    request.other_center = center_of_block(!state_.absolute_centers);
    request.other_reading = state_.absolute_centers ? "an offset (G91.1)" : "a position (G90.1)";
    path().arc_by_center(request);
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

Vec3 IsoReader::target_of_block() {
  const Vec3 position = path().position();
  if (!words_.has_any("XYZ") && !words_.has_polar()) {
    return position;
  }
  const Vec3 target =
      state_.incremental ? Vec3(position + programmed_axes(Vec3::Zero())) : programmed_axes(position);
  if (words_.has_polar()) {
    return distance_and_angle_target(target);
  }
  return state_.polar.on ? polar_target(target) : target;
}

Vec3 IsoReader::programmed_axes(const Vec3& otherwise) const {
  Vec3 values = otherwise;
  for (int axis = 0; axis < 3; ++axis) {
    const char letter = axis_letters[static_cast<std::size_t>(axis)];
    if (words_.has(letter)) {
      values[axis] = state_.to_mm(words_[letter].value);
    }
  }
  return values;
}

Vec3 IsoReader::center_of_block(bool absolute) const {
  Vec3 center = path().position();
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

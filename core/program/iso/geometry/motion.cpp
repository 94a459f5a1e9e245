#include "core/program/iso/geometry/motion.h"

#include <cmath>
#include <numbers>

#include "core/base/units.h"

namespace feedscope::iso {

namespace {

/// LinuxCNC's interpreter accepts 2 sqrt(2) of 0.01 mm or 0.001 inch, or 0.1 %, but at most a hundred times
/// the former.
ArcTolerance linuxcnc_tolerance(bool inch) {
  const double least = 2 * std::numbers::sqrt2 * (inch ? units::from_inch(0.001) : 0.01);
  return {least, 0.001, 100 * least};
}

}  // namespace

void Motions::run() {
  if (words_.exact_stop) {
    move_to_exact_stop();
  } else {
    move();
  }
}

void Motions::move_to_exact_stop() {
  const PathControl modal = path().path_control();
  PathControl control = modal;
  control.mode = PathMode::exact_stop;
  control.exact_path = false;
  path().set_path_control(control);
  move();
  path().set_path_control(modal);
}

bool Motions::has_motion_words() const {
  if (words_.has_any("XYZ") || words_.has_polar()) {
    return true;
  }
  switch (modal_.motion) {
    case MotionMode::arc_cw:
    case MotionMode::arc_ccw:
      return words_.has_any("IJKR");
    case MotionMode::cycle:
      return words_.has('R');
    case MotionMode::spline:
      return splines_.moves_without_axes();
    default:
      return false;
  }
}

void Motions::move() {
  if (words_.own_words || !has_motion_words()) {
    cut_corner(false);
    return;
  }
  if (modal_.motion == MotionMode::none) {
    report_no_motion_word();
    modal_.motion = MotionMode::rapid;
  }
  if (modal_.motion != MotionMode::spline) {
    splines_.finish();
  }
  targets_.program_axes();
  path().set_column(words_.first_column("XYZIJKR"));
  cut_corner(modal_.is_arc() || modal_.motion == MotionMode::line);
  if (modal_.motion == MotionMode::cycle) {
    cycles_.run();
    return;
  }
  check_inverse_time();
  switch (modal_.motion) {
    case MotionMode::rapid:
      path().rapid(targets_.target());
      break;
    case MotionMode::line:
      path().line(targets_.target());
      break;
    case MotionMode::arc_cw:
    case MotionMode::arc_ccw:
      arc();
      break;
    case MotionMode::spline:
      splines_.run();
      break;
    case MotionMode::unread:
      targets_.target();  // updates radius and angle of G16
      break;
    case MotionMode::none:
    case MotionMode::cycle:
      break;
  }
}

/// LinuxCNC starts in the state after G80, grbl in the state after G0.
void Motions::report_no_motion_word() const {
  const bool is_refused = dialect() == Dialect::linuxcnc || (dialect() == Dialect::grbl && modal_.after_g80);
  report(is_refused ? Severity::error : Severity::warning, "motion-mode", is_refused ? 1 : 0,
         words_.first_column("XYZ"), [&] {
           const Message assumed =
               modal_.after_g80 ? NC_("core", "position words after G80 without a new G0, G1, G2 or G3")
                                : NC_("core", "position words before the first G0, G1, G2 or G3");
           const std::string_view control = info_of(dialect()).title;
           const Message refused =
               modal_.after_g80
                   ? message(NC_("core",
                                 "position words after G80 without a new G0, G1, G2 or G3: {} stops here "
                                 "with an error"),
                             control)
                   : message(
                         NC_("core",
                             "position words before the first G0, G1, G2 or G3: {} stops here with an error"),
                         control);
           return Text{is_refused ? refused : assumed, NC_("core", "G0 is used; write the G word")};
         });
}

void Motions::check_inverse_time() const {
  const bool at_feed = modal_.motion != MotionMode::rapid && modal_.motion != MotionMode::unread;
  if (path().feed_mode() == FeedMode::inverse_time && at_feed && !words_.has('F') && path().feed() > 0) {
    report(Severity::error, "feed-missing", 1, words_.first_column("XYZIJKR"), [] {
      return Text{NC_("core", "a feed move without F under G93"),
                  NC_("core", "the last F is used; write F in every such block")};
    });
  }
}

void Motions::cut_corner(bool at_line_or_arc) const {
  if (words_.corner == nullptr) {
    return;
  }
  const Word& word = *words_.corner;
  if (!at_line_or_arc || !(word.value > 0)) {
    report(Severity::error, "corner", at_line_or_arc ? 2 : 3, word.column, [&] {
      return Text{
          at_line_or_arc ? message(NC_("core", "a rounding or chamfer of {} is not above zero"), word.value)
                         : message(NC_("core", ",{} in a block that is not a line or an arc"), word.letter),
          NC_("core", "the corner stays sharp; write it in the G1, G2 or G3 block that ends at the corner")};
    });
    return;
  }
  CornerCut cut;
  cut.kind = word.letter == 'R' ? CornerCut::Kind::rounding : CornerCut::Kind::chamfer;
  cut.size = modal_.to_mm(word.value);
  cut.at_feed_only = true;
  cut.place = lines().place(word.column);
  path().cut_next_corner(cut, modal_.plane);
}

void Motions::arc() {
  const Vec3 target = targets_.target();
  if (!words_.has_any("IJKR")) {
    report(Severity::error, "arc-center", 0, words_.first_column("XYZ"), [] {
      return Text{NC_("core", "the arc has neither a centre (I, J, K) nor a radius (R)"), straight_instead};
    });
    path().line(target);
    return;
  }
  if (words_.has('R') && words_.has_any("IJK")) {
    report(Severity::error, "arc-center", 1, words_.first_column("IJK"), [] {
      return Text{NC_("core", "the arc has both a centre (I, J, K) and a radius (R)"),
                  NC_("core", "R is used; remove one of them")};
    });
  }
  for (const char letter : {'I', 'J', 'K', 'R'}) {
    targets_.check_point(letter, Targets::implausible_length);
  }
  const Vec3 normal = normal_of(modal_.plane);
  ArcRequest request;
  request.target = target;
  request.axis = modal_.motion == MotionMode::arc_ccw ? normal : Vec3(-normal);
  request.column = words_.has('R') ? words_.first_column("R") : words_.first_column("IJK");
  request.extra_turns = extra_turns();
  if (words_.has('R')) {
    request.radius = length('R');
    path().arc_by_radius(request);
  } else {
    check_center_axis();
    if (dialect() == Dialect::linuxcnc) {
      request.tolerance = linuxcnc_tolerance(modal_.inch);
    }
    request.center = targets_.center(modal_.absolute_centers);
    request.other_center = targets_.center(!modal_.absolute_centers);
    request.other_reading =
        modal_.absolute_centers ? NC_("core", "an offset (G91.1)") : NC_("core", "a position (G90.1)");
    path().arc_by_center(request);
  }
}

double Motions::extra_turns() const {
  constexpr double max_turns = 10000;
  if (!words_.has('P')) {
    return 0;
  }
  const Word& word = words_['P'];
  if (word.value >= 1 && word.value <= max_turns && word.value == std::floor(word.value)) {
    return word.value - 1;
  }
  report(Severity::error, "arc-turns", 0, word.column, [&] {
    return Text{message(NC_("core", "P{} is not a number of turns from 1 to {}"), word.value, max_turns),
                NC_("core", "one turn is used")};
  });
  return 0;
}

void Motions::check_center_axis() const {
  const char letter = center_letters[static_cast<std::size_t>(modal_.plane)];
  if (words_.has(letter) && words_[letter].value != 0 && !modal_.absolute_centers) {
    report(Severity::warning, "unused-word", letter, words_[letter].column, [&] {
      return Text{
          message(NC_("core", "{}{} is perpendicular to the plane of the arc"), letter, words_[letter].value),
          NC_("core", "it is ignored; check whether G17, G18 or G19 is missing")};
    });
  }
}

}  // namespace feedscope::iso

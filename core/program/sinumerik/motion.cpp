// The part of SinumerikReader that moves: lines, dwells, splines, polynomials.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "core/program/path/curve_lines.h"
#include "core/program/sinumerik/names.h"
#include "core/program/sinumerik/sinumerik_reader.h"
#include "core/program/text/message.h"

namespace feedscope {

using namespace sinumerik;

namespace {

bool is_arc_action(Action action) {
  return action == Action::arc_cw || action == Action::arc_ccw || action == Action::arc_through ||
         action == Action::arc_tangent;
}

}  // namespace

bool SinumerikReader::has_motion_words() const {
  const bool arc = modal_.motion != nullptr && is_arc_action(modal_.motion->action);
  return words_.has_any("XYZ") || words_.has(Address::ap) || words_.has(Address::rp) ||
         words_.has(Address::ang) ||
         (arc && (words_.has_any("IJK") || words_.has(Address::ar) || words_.has(Address::cr)));
}

void SinumerikReader::move() {
  constexpr std::string_view other_axes = "ABCUVW";
  if (words_.has_any(other_axes)) {
    for (const char letter : other_axes) {
      if (words_.has(letter) && !machine_axes_) {
        report_axis(std::string_view(&letter, 1), words_[letter].column, words_[letter].value);
      }
    }
  }
  const bool leaves_spline = spline_.begun() && modal_.motion->action != Action::spline;
  if (leaves_spline) {
    finish_spline();
  }
  if (!has_motion_words()) {
    check_unused(false);
    cut_corner(false);
    return;
  }
  if (machine_axes_) {
    finish_spline();
    move_machine_axes();
    return;
  }
  if (modal_.motion == nullptr) {
    report(Severity::warning, "motion-mode", 0, words_.first_column("XYZ"), [] {
      return Text{"position words before any of G0, G1, G2, G3", "taken as G1; write the G word"};
    });
    modal_.motion = find_g(1);
  }
  const Action action = modal_.motion->action;
  if (action == Action::unread_motion) {
    return;
  }
  check_unused(is_arc_action(action));
  path().set_column(written(words_.first_column("XYZIJK")));
  use_path_control(action == Action::rapid);
  const double feed = path().feed();
  if (words_.has(Address::fb)) {
    path().set_feed(feed_of(words_[Address::fb].value));
  }
  cut_corner(action == Action::rapid || action == Action::line || is_arc_action(action));
  const Vec3 target = target_of_block();
  Vec3 start = path().position();
  program_axes();
  switch (action) {
    case Action::rapid:
    case Action::line:
      straight(target, action == Action::rapid);
      break;
    case Action::thread:
      thread(target);
      break;
    case Action::spline:
      collect_spline(target);
      break;
    case Action::polynomial:
      polynomial(target, start);
      break;
    case Action::arc_through:
      arc_through(target);
      break;
    case Action::arc_tangent:
      tangent_arc(target);
      break;
    default:
      arc(target);
  }
  if (words_.has(Address::fb)) {
    path().set_feed(feed);
  }
  start_ = start;
  moved_ = true;
}

/// Those of the block.
void SinumerikReader::program_axes() {
  const bool polar = words_.has(Address::ap) || words_.has(Address::rp);
  if (polar) {
    modal_.polar = polar_of_block();
  }
  for (int axis = 0; axis < 3; ++axis) {
    if (words_.has(axis_names[static_cast<std::size_t>(axis)]) ||
        (polar && axis != normal_axis(modal_.plane))) {
      program_axis(axis);
    }
  }
}

void SinumerikReader::check_unused(bool arc) {
  if (arc || !words_.has_any("IJK")) {
    return;
  }
  const Action action = modal_.motion == nullptr ? Action::line : modal_.motion->action;
  if (action == Action::thread || action == Action::unread_motion) {
    return;
  }
  for (const char letter : {'I', 'J', 'K'}) {
    if (words_.has(letter)) {
      report(Severity::warning, "unused-word", letter, words_[letter].column, [&] {
        return Text{fmt::format("{}{} has no meaning in this block", letter, words_[letter].value),
                    "it is left out; is a G2 or G3 missing?"};
      });
    }
  }
}

/// G53, G153, SUPA: coordinates of the machine; G74: the reference point; G75: the first fixed point, where
/// tools are changed, or another one.
void SinumerikReader::move_machine_axes() {
  const bool by_coordinate = own_block_ == nullptr;
  std::array<bool, 3> named{};
  AxisPlaces places;
  for (std::size_t axis = 0; axis < named.size(); ++axis) {
    const char letter = axis_names[axis];
    named[axis] = words_.has(letter) || !words_.has_any("XYZ");
    places[axis].kind = AxisPlace::Kind::unknown;
    if (by_coordinate && words_.has(letter) && !is_incremental(words_[letter])) {
      places[axis] = {AxisPlace::Kind::machine, to_mm(words_[letter].value)};
    } else if (!by_coordinate && own_block_->name == "G74") {
      places[axis].kind = AxisPlace::Kind::home;
    } else if (!by_coordinate && own_block_->name == "G75" && fixed_point_ == 1) {
      places[axis].kind = AxisPlace::Kind::tool_change;
    }
  }
  const bool at_feed = by_coordinate && modal_.motion != nullptr && modal_.motion->action != Action::rapid &&
                       path().feed_mode() != FeedMode::inverse_time;
  use_path_control(!at_feed);
  path().go_to_machine_place(named, places, at_feed ? path().feed_rate() : 0);
  report_machine_move(by_coordinate ? machine_word_ : own_block_->name, "machine-position",
                      by_coordinate ? words_.first_column("XYZ") : own_column_);
}

void SinumerikReader::dwell() {
  double seconds = 0;
  const char letter = words_.has('F') ? 'F' : 'S';
  if (!words_.has_any("FS")) {
    report(Severity::error, "dwell-time", 1, own_column_, [] {
      return Text{"G4 without a time", "the dwell is left out; write F with seconds or S with revolutions"};
    });
    return;
  }
  const BlockWords::Value& word = words_[letter];
  seconds = word.value;
  if (letter == 'S') {
    const double speed = path().spindle_speed();
    if (speed <= 0) {
      report(Severity::error, "dwell-time", 2, word.column, [&] {
        return Text{fmt::format("a dwell of {} revolutions without a spindle speed", word.value),
                    "the dwell is left out; write S in a block before it"};
      });
      return;
    }
    seconds /= speed;
  }
  if (seconds < 0) {
    report(Severity::error, "dwell-time", 0, word.column, [&] {
      return Text{fmt::format("dwell time {}{} is negative", letter, word.value), "the dwell is left out"};
    });
  } else if (seconds > 0) {
    use_path_control(false);
    path().dwell(seconds);
  }
}

void SinumerikReader::use_path_control(bool rapid) {
  const Applied wanted = exact_stop_ ? Applied::none : rapid ? Applied::rapid : Applied::feed;
  if (wanted == Applied::none || applied_ != wanted) {
    path().set_path_control(path_words_.control(rapid, exact_stop_));
    applied_ = wanted;
  }
}

void SinumerikReader::straight(const Vec3& target, bool rapid) {
  last_arc_.reset();
  if (rapid) {
    path().rapid(target);
  } else {
    path().line(target);
  }
}

/// A thread's feed is its lead times the spindle speed.
void SinumerikReader::thread(const Vec3& target) {
  double lead = 0;
  for (const char letter : {'I', 'J', 'K'}) {
    lead = words_.has(letter) ? std::max(lead, std::abs(to_mm(words_[letter].value))) : lead;
  }
  report(Severity::info, "thread", 0, words_.first_column("XYZ"), [&] {
    return Text{fmt::format("{} (thread) is read as a line", modal_.motion->name),
                "its feed is lead times spindle speed; how the spindle runs up is not shown"};
  });
  const FeedMode mode = path().feed_mode();
  const double feed = path().feed();
  path().set_feed_mode(FeedMode::per_revolution);
  path().set_feed(lead);
  straight(target, false);
  path().set_feed_mode(mode);
  path().set_feed(feed);
}

void SinumerikReader::collect_spline(const Vec3& target) {
  SplinePath::Point point{.at = target,
                          .weight = words_.has(Address::pw) ? words_[Address::pw].value : 1,
                          .interval = {},
                          .feed = path().feed(),
                          .line = shown_line(),
                          .place = place(words_.first_column("XYZ"))};
  if (words_.has(Address::pl) && words_[Address::pl].value >= 0) {
    point.interval = words_[Address::pl].value;
  }
  if (!(point.weight > 0)) {
    report(Severity::error, "spline-weight", 0, words_[Address::pw].column, [&] {
      return Text{fmt::format("PW={} is no weight above zero", point.weight), "1 is taken"};
    });
    point.weight = 1;
  }
  if (words_.has(Address::sd)) {
    spline_.set_degree(static_cast<int>(std::clamp(words_[Address::sd].value, 1.0, 3.0)));
  }
  const std::string_view kind = modal_.motion->name;
  if (spline_.begun() && spline_.kind() != kind) {
    finish_spline();
  }
  if (!spline_.begun()) {
    SplinePath::Point start = point;
    start.at = path().position();
    start.weight = 1;
    spline_.begin(kind, start, last_direction());
  }
  const bool new_place = (target - spline_.last().at).norm() > same_point;
  if (new_place || kind == "BSPLINE") {
    spline_.add(point);
  }
}

void SinumerikReader::finish_spline() {
  if (!spline_.begun()) {
    return;
  }
  const SplinePath curve = spline_;
  const double feed = path().feed();
  Vec3 direction = Vec3::Zero();
  if (modal_.motion->action == Action::line || modal_.motion->action == Action::rapid) {
    direction = target_of_block() - curve.last().at;
  }
  spline_.clear();
  curve.spans(direction.norm() > same_point ? Vec3(direction.normalized()) : Vec3(Vec3::Zero()),
              [&](const ParametricCurve& span, double from, double to, const SplinePath::Point& point) {
                path().begin_line(point.line, point.place);
                path().program_axes();
                path().set_feed(point.feed);
                const Vec3 leaves = path().curve(span, from, to, point.place.column);
                start_ = path().position() - leaves;
              });
  last_arc_.reset();
  path().begin_line(shown_line(), place(0));
  path().set_feed(feed);
}

/// `from` becomes where a line would start that ends as the curve does.
void SinumerikReader::polynomial(const Vec3& target, Vec3& from) {
  last_arc_.reset();
  const double interval = words_.has(Address::pl) ? words_[Address::pl].value : 1;
  if (!has_polynomials_ || !(interval > 0)) {
    path().line(target);
    return;
  }
  const Vec3 start = path().position();
  const auto curve = [&](double parameter) -> CurvePlace {
    CurvePlace place{start + (target - start) * parameter / interval, (target - start) / interval};
    for (std::size_t i = 0; i < 3; ++i) {
      if (polynomials_[i]) {
        const int axis = static_cast<int>(i);
        PolynomialWord word = *polynomials_[i];
        word.end = target[axis];
        place.point[axis] = word.at(parameter, start[axis], interval);
        place.slope[axis] = word.slope_at(parameter, start[axis], interval);
      }
    }
    return place;
  };
  from = -path().curve(curve, 0, interval, words_.first_column("XYZ"));
  from += path().position();
}

}  // namespace feedscope

// The part of HeidenhainCore that moves.
#include <fmt/format.h>

#include <cmath>

#include "core/base/units.h"
#include "core/program/heidenhain/heidenhain_core.h"
#include "core/program/path/plane_points.h"
#include "core/program/text/read_fault.h"

namespace feedscope {

namespace {

constexpr std::string_view straight_instead = "a straight line to the end is taken instead";
constexpr std::string_view other_axes = "ABCUVW";

/// Both axes of the plane, a bit each.
std::uint8_t bits_of(Plane plane) {
  return static_cast<std::uint8_t>(1 << first_axis(plane) | 1 << second_axis(plane));
}

}  // namespace

void HeidenhainCore::check_words(PathKind kind, const MotionWords& words) {
  const bool is_polar =
      kind == PathKind::polar_line || kind == PathKind::polar_arc || kind == PathKind::polar_tangent_arc;
  const bool turns =
      kind == PathKind::center_arc || kind == PathKind::radius_arc || kind == PathKind::polar_arc;
  const std::string_view name = words.length                                              ? "LEN"
                                : words.center_angle                                      ? "CCA"
                                : words.radius && kind != PathKind::radius_arc            ? "R"
                                : words.turn != 0 && !turns                               ? "DR"
                                : words.has_polar() && !is_polar                          ? "PR or PA"
                                : words.polar_radius.given && kind == PathKind::polar_arc ? "PR"
                                                                                          : "";
  if (!name.empty()) {
    report(Severity::error, "unread-word", 3, words.first_column, [&] {
      return Text{fmt::format("{} belongs to another kind of motion than this block", name),
                  "it is left out; check the block"};
    });
  }
}

void HeidenhainCore::run_path(PathKind kind, const MotionWords& words) {
  check_words(kind, words);
  move_other_axes(words);
  start_functions(words);
  apply_feed(words);
  apply_side(words);
  const bool moves =
      words.has_axes() || words.has_polar() || (kind == PathKind::center_arc || kind == PathKind::polar_arc);
  if (moves && !goes_to_machine_position(words)) {
    add_path(kind, words);
    note_programmed_axes(words);
    last_rapid_ = words.feed_word == FeedWord::rapid;
  }
  finish_functions(words, moves);
}

void HeidenhainCore::note_programmed_axes(const MotionWords& words) {
  programmed_axes_ |= words.absolute_bits();
  programmed_axes_ |= words.has_polar() ? bits_of(pole_plane_) : std::uint8_t{0};
}

void HeidenhainCore::run_functions(const MotionWords& words) {
  run_path(PathKind::line, words);
}

ContourFeed HeidenhainCore::feed_of(const MotionWords& words) const {
  ContourFeed feed = feed_;
  feed.rapid = words.feed_word == FeedWord::rapid;
  return feed;
}

ContourElement HeidenhainCore::element_of(const MotionWords& words, const Vec3& target) const {
  ContourElement element;
  element.target = target;
  element.plane = contour_.plane();
  element.feed = feed_of(words);
  element.side = side_;
  element.tool_radius = tool_radius_;
  element.place = contour_place(words.first_column, words.axis_bits());
  element.place.incremental = words.incremental_bits();
  return element;
}

Vec3 HeidenhainCore::target_of(const MotionWords& words) const {
  Vec3 target = contour_.position();
  for (int axis = 0; axis < 3; ++axis) {
    target[axis] = words.axes[static_cast<std::size_t>(axis)].from(target[axis]);
  }
  return target;
}

void HeidenhainCore::add_path(PathKind kind, const MotionWords& words) {
  switch (kind) {
    case PathKind::line:
      contour_.add(element_of(words, target_of(words)));
      break;
    case PathKind::center_arc:
      add_center_arc(element_of(words, target_of(words)), words);
      break;
    case PathKind::radius_arc:
      add_radius_arc(element_of(words, target_of(words)), words);
      break;
    case PathKind::tangent_arc:
      add_tangent_arc(element_of(words, target_of(words)));
      break;
    case PathKind::polar_line:
    case PathKind::polar_arc:
    case PathKind::polar_tangent_arc:
      add_polar(kind, words);
      break;
  }
}

bool HeidenhainCore::has_pole(std::uint32_t column) {
  if (!pole_) {
    report(Severity::error, "pole", 0, column, [] {
      return Text{"no pole stands before what is measured from it",
                  "a line to the end that can be read is taken; write the pole (CC, or I and J) before it"};
    });
  }
  return pole_.has_value();
}

int HeidenhainCore::turn_of(const MotionWords& words) {
  if (words.turn != 0) {
    last_turn_ = words.turn;
  } else if (last_turn_ == 0) {
    report(Severity::error, "arc-direction", 0, words.first_column, [] {
      return Text{"the arc has no direction", "counter-clockwise is taken; write DR+ or DR-"};
    });
    last_turn_ = 1;
  }
  return last_turn_;
}

void HeidenhainCore::add_center_arc(ContourElement element, const MotionWords& words) {
  if (has_pole(words.first_column)) {
    element.is_arc = true;
    element.center = *pole_;
    element.plane = pole_plane_;
    element.turn = turn_of(words);
  }
  contour_.add(element);
}

void HeidenhainCore::add_radius_arc(ContourElement element, const MotionWords& words) {
  if (!words.radius) {
    report(Severity::error, "arc-radius", 2, words.first_column, [] {
      return Text{"the arc has no radius", fmt::format("{}; write R", straight_instead)};
    });
    contour_.add(element);
    return;
  }
  element.is_arc = true;
  element.turn = turn_of(words);
  const ArcSolution solution = solve_radius_arc(contour_.position(), element.target, *words.radius,
                                                element.turn * normal_of(element.plane), 0);
  if (solution.fault == ArcFault::none) {
    element.center = solution.pieces[0].words.center;
  } else {
    element.radius = *words.radius;
  }
  contour_.add(element);
}

void HeidenhainCore::add_tangent_arc(ContourElement element) {
  const std::optional<Vec2> direction = contour_.direction();
  const Vec2 start = in_plane(contour_.position(), element.plane);
  const Vec2 chord = in_plane(element.target, element.plane) - start;
  if (!direction) {
    report(Severity::error, "tangent-arc", 0, element.place.place.column, [] {
      return Text{"no motion in the working plane stands before the arc that continues it",
                  std::string(straight_instead)};
    });
  } else if (chord.norm() > same_point) {
    const double across = cross(*direction, chord);
    if (std::abs(across) > same_point * chord.norm()) {
      element.is_arc = true;
      element.turn = across > 0 ? 1 : -1;
      const Vec2 center = start + chord.squaredNorm() / (2 * across) * left_of(*direction);
      element.center = from_plane(center, element.plane, element.target);
      last_turn_ = element.turn;
    } else if (direction->dot(chord) < 0) {
      report(Severity::error, "tangent-arc", 1, element.place.place.column, [] {
        return Text{"the arc would end straight behind its start", std::string(straight_instead)};
      });
    }
  }
  contour_.add(element);
}

Vec3 HeidenhainCore::polar_target(const MotionWords& words) {
  const Vec2 from_pole = in_plane(contour_.position() - *pole_, pole_plane_);
  // On the pole itself the angle is the last one.
  const double angle_before =
      from_pole.norm() > same_point ? std::atan2(from_pole.y(), from_pole.x()) : last_polar_angle_;
  const double radius = words.polar_radius.from(from_pole.norm());
  const double angle = words.polar_angle.from(angle_before);
  last_polar_angle_ = angle;
  const Vec2 end = in_plane(*pole_, pole_plane_) + radius * Vec2(std::cos(angle), std::sin(angle));
  const int normal = normal_axis(pole_plane_);
  Vec3 target = contour_.position();
  target[normal] = words.axes[static_cast<std::size_t>(normal)].from(target[normal]);
  return from_plane(end, pole_plane_, target);
}

void HeidenhainCore::add_polar(PathKind kind, const MotionWords& words) {
  if (!has_pole(words.first_column)) {
    return;
  }
  constexpr double same_angle = 1e-9;
  MotionWords polar = words;
  if (kind == PathKind::polar_arc) {
    polar.polar_radius.given = false;
  }
  ContourElement element = element_of(words, polar_target(polar));
  element.place.axes |= bits_of(pole_plane_);
  element.plane = pole_plane_;
  if (kind == PathKind::polar_tangent_arc) {
    add_tangent_arc(element);
    return;
  }
  if (kind == PathKind::polar_arc) {
    element.is_arc = true;
    element.center = *pole_;
    const double angle = words.polar_angle.value;
    const bool by_sweep = words.polar_angle.given && words.polar_angle.incremental;
    if (by_sweep && words.turn == 0 && angle != 0) {
      last_turn_ = angle > 0 ? 1 : -1;
    }
    element.turn = turn_of(words);
    if (by_sweep && angle * element.turn < 0) {
      report(Severity::error, "arc-direction", 1, words.first_column, [&] {
        return Text{fmt::format("the angle of {:.3f} degrees turns against the arc's direction",
                                units::to_deg(angle)),
                    "the sign of the angle counts; write both alike"};
      });
      element.turn = last_turn_ = -element.turn;
    }
    if (by_sweep) {
      const double turns = std::abs(angle) / (2 * units::pi);
      const double whole = std::floor(turns + same_angle);
      element.extra_turns = whole;
      if (whole > 0 && turns - whole < same_angle) {
        // Ends that coincide are one turn already.
        element.extra_turns = whole - 1;
        element.target = from_plane(in_plane(contour_.position(), pole_plane_), pole_plane_, element.target);
      }
    }
  }
  contour_.add(element);
}

void HeidenhainCore::set_pole(const MotionWords& words) {
  const Vec3 base = contour_.position();
  Vec3 pole = pole_.value_or(base);
  if (!words.has_axes()) {
    pole = base;
  }
  for (int axis = 0; axis < 3; ++axis) {
    const OptionalWord& word = words.axes[static_cast<std::size_t>(axis)];
    if (word.given) {
      pole[axis] = word.incremental ? base[axis] + word.value : word.value;
    }
  }
  pole_ = pole;
  if (!words.has_axes()) {
    pole_plane_ = contour_.plane();
  }
  for (const Plane plane : {Plane::xy, Plane::zx, Plane::yz}) {
    const auto given = [&](int axis) { return words.axes[static_cast<std::size_t>(axis)].given; };
    if (given(first_axis(plane)) && given(second_axis(plane))) {
      pole_plane_ = plane;
    }
  }
}

void HeidenhainCore::run_corner(bool rounding, double size, const MotionWords& words, std::uint32_t column) {
  if (!(size > 0)) {
    throw ReadFault{"corner", column,
                    fmt::format("a {} of {} mm is not above zero", rounding ? "rounding" : "chamfer", size),
                    "the corner stays sharp"};
  }
  ContourCorner corner;
  corner.rounding = rounding;
  corner.size = size;
  corner.place = contour_place(column, bits_of(plane()));
  corner.feed = feed_alone(words);
  contour_.add_corner(corner);
}

void HeidenhainCore::check_side(std::uint32_t column) {
  if (side_ == 0) {
    report(Severity::warning, "approach-side", 0, column, [] {
      return Text{"an approach or departure to the side without RL or RR",
                  "the left side is taken; write RL or RR"};
    });
  }
}

ApproachShape HeidenhainCore::approach_shape(ApproachKind kind, const MotionWords& words,
                                             std::uint32_t column) {
  ApproachShape shape;
  shape.kind = kind;
  shape.side = side_ == 0 ? 1 : side_;
  const auto need = [&](const std::optional<double>& value, std::string_view name) {
    if (!value || *value == 0) {
      throw ReadFault{"approach", column, fmt::format("{} is missing or zero", name),
                      "the approach or departure is left out"};
    }
    return *value;
  };
  switch (kind) {
    case ApproachKind::tangent_line:
    case ApproachKind::normal_line:
      shape.length = std::abs(need(words.length, "its length LEN"));
      if (kind == ApproachKind::normal_line && side_ != 0) {
        // From the tool's edge.
        shape.length += tool_radius_.value_or(0);
      }
      break;
    case ApproachKind::arc:
      shape.angle = std::abs(need(words.center_angle, "its angle CCA"));
      [[fallthrough]];
    case ApproachKind::line_and_arc:
      shape.radius = need(words.radius, "its radius R");
      shape.tool_radius = side_ == 0 ? 0 : tool_radius_.value_or(0);
      if (shape.radius < 0 && shape.radius + shape.tool_radius >= 0) {
        throw ReadFault{
            "approach", column,
            fmt::format(
                "its radius R of {:.3f} mm on the other side is not larger than the tool's, {:.3f} mm",
                shape.radius, shape.tool_radius),
            "the approach or departure is left out"};
      }
      break;
  }
  if (kind != ApproachKind::tangent_line) {
    check_side(column);
  }
  return shape;
}

void HeidenhainCore::run_approach(ApproachKind kind, bool polar, const MotionWords& words,
                                  std::uint32_t column) {
  start_functions(words);
  ContourApproach approach;
  approach.travel = feed_;
  approach.travel.rapid = last_rapid_;
  apply_feed(words);
  apply_side(words);
  approach.shape = approach_shape(kind, words, column);
  if (polar && !has_pole(column)) {
    return;
  }
  approach.target = polar ? polar_target(words) : target_of(words);
  approach.feed = feed_of(words);
  if (kind == ApproachKind::line_and_arc) {
    approach.travel = approach.feed;
  }
  approach.side = side_;
  approach.tool_radius = tool_radius_;
  approach.place = contour_place(column, words.axis_bits() | bits_of(plane()));
  contour_.approach(approach);
  note_programmed_axes(words);
  last_rapid_ = false;
  finish_functions(words, true);
}

std::optional<ContourFeed> HeidenhainCore::feed_alone(const MotionWords& words) {
  if (words.feed_word == FeedWord::none) {
    return std::nullopt;
  }
  const ContourFeed before = feed_;
  apply_feed(words);
  const ContourFeed alone = feed_of(words);
  feed_ = before;
  return alone;
}

void HeidenhainCore::run_soft_approach(double radius, const MotionWords& words, std::uint32_t column) {
  if (!(radius > 0) || !contour_.soften_approach(radius, feed_alone(words))) {
    throw ReadFault{"approach", column, "no line to the contour's first point stands in the block before",
                    "the contour is approached straight"};
  }
  check_side(column);
}

void HeidenhainCore::run_departure(ApproachKind kind, bool polar, const MotionWords& words,
                                   std::uint32_t column, const std::optional<ContourFeed>& curve_feed) {
  start_functions(words);
  apply_feed(words);
  if (polar && !has_pole(column)) {
    return;
  }
  ContourDeparture departure;
  departure.shape = approach_shape(kind, words, column);
  departure.target = polar ? polar_target(words) : target_of(words);
  departure.feed = feed_of(words);
  departure.curve_feed = curve_feed.value_or(departure.feed);
  departure.place = contour_place(column, words.axis_bits() | bits_of(plane()));
  contour_.depart(departure);
  side_ = 0;
  last_rapid_ = departure.feed.rapid;
  finish_functions(words, true);
}

void HeidenhainCore::end_contour(std::uint32_t column) {
  contour_.flush();
  path().begin_line(shown_line(), spot(column));
}

/// M91: coordinates of the machine; M92: from another datum that its builder has set.
bool HeidenhainCore::goes_to_machine_position(const MotionWords& words) {
  if (!words.has_m(91) && !words.has_m(92)) {
    return false;
  }
  end_contour(words.first_column);
  std::array<bool, 3> named{};
  AxisPlaces places;
  for (std::size_t axis = 0; axis < places.size(); ++axis) {
    const OptionalWord& word = words.axes[axis];
    named[axis] = word.given;
    places[axis].kind = AxisPlace::Kind::unknown;
    if (words.has_m(91) && !word.incremental) {
      places[axis] = {AxisPlace::Kind::machine, word.value};
    }
  }
  if (words.has_polar()) {
    named[static_cast<std::size_t>(first_axis(pole_plane_))] = true;
    named[static_cast<std::size_t>(second_axis(pole_plane_))] = true;
  }
  path().go_to_machine_place(named, places, words.feed_word == FeedWord::rapid ? 0 : path().feed_rate());
  report_machine_move(words.has_m(91) ? "M91" : "M92", "machine-position", words.first_column);
  return true;
}

void HeidenhainCore::set_other_axis(char letter, double value, bool incremental, std::uint32_t column,
                                    MotionWords& words) {
  const std::size_t i = other_axes.find(letter);
  words.other_axes[i] = {value, true, incremental};
  words.other_columns[i] = column;
  words.has_other_axes = true;
}

void HeidenhainCore::move_other_axes(const MotionWords& words) {
  if (!words.has_other_axes) {
    return;
  }
  const bool moves = words.has_axes() || words.has_polar();
  for (std::size_t i = 0; i < other_axes.size(); ++i) {
    const bool rotary = i < 3;
    const double target = words.other_axes[i].from(other_places_[i]);
    if (target != other_places_[i]) {
      const bool positions = rotary && (!moves || words.feed_word == FeedWord::rapid);
      note_other_axis(other_axes.substr(i, 1), target, positions ? AxisMotion::positions : AxisMotion::cuts,
                      words.other_columns[i]);
    }
    other_places_[i] = target;
  }
}

}  // namespace feedscope

#include "core/program/heidenhain/geometry/motion.h"

#include <cmath>
#include <string>
#include <utility>

#include "core/base/units.h"
#include "core/program/path/plane_points.h"
#include "core/program/text/read_fault.h"

namespace feedscope::heidenhain {

namespace {

constexpr std::string_view other_axis_letters = "ABCUVW";

}  // namespace

void set_other_axis(char letter, double value, bool incremental, std::uint32_t column, MotionWords& words) {
  const std::size_t i = other_axis_letters.find(letter);
  words.other_axes[i] = {value, true, incremental};
  words.other_columns[i] = column;
  words.has_other_axes = true;
}

void Motions::check_words(PathKind kind, const MotionWords& words) const {
  const bool is_polar =
      kind == PathKind::polar_line || kind == PathKind::polar_arc || kind == PathKind::polar_tangent_arc;
  const bool turns =
      kind == PathKind::center_arc || kind == PathKind::radius_arc || kind == PathKind::polar_arc;
  const auto word = [](const char* name) { return Message::as_written(name); };
  const Message name = words.length                                   ? word("LEN")
                       : words.center_angle                           ? word("CCA")
                       : words.radius && kind != PathKind::radius_arc ? word("R")
                       : words.turn != 0 && !turns                    ? word("DR")
                       : words.has_polar() && !is_polar               ? Message(NC_("core", "PR or PA"))
                       : words.polar_radius.given && kind == PathKind::polar_arc ? word("PR")
                                                                                 : Message();
  if (!name.empty()) {
    report(Severity::error, "unread-word", 3, words.first_column, [&] {
      return Text{message(NC_("core", "{} belongs to another kind of motion than this block"), name),
                  NC_("core", "it is ignored; correct the block")};
    });
  }
}

void Motions::run(PathKind kind, const MotionWords& words) {
  check_words(kind, words);
  m_functions_.start(words);
  feeds_.apply(words);
  move_other_axes(words);
  orient_tool(words);
  tools_.select_side(words);
  const bool moves =
      words.has_axes() || words.has_polar() || (kind == PathKind::center_arc || kind == PathKind::polar_arc);
  if (moves && !goes_to_machine_position(words)) {
    add(kind, words);
    targets_.note_programmed_axes(words);
    was_rapid_ = words.feed_word == FeedWord::rapid;
  }
  m_functions_.finish(words, moves);
}

void Motions::add(PathKind kind, const MotionWords& words) {
  switch (kind) {
    case PathKind::line:
      contour_.add(targets_.element(words, targets_.of(words)));
      break;
    case PathKind::center_arc:
      add_center_arc(targets_.element(words, targets_.of(words)), words);
      break;
    case PathKind::radius_arc:
      add_radius_arc(targets_.element(words, targets_.of(words)), words);
      break;
    case PathKind::tangent_arc:
      add_tangent_arc(targets_.element(words, targets_.of(words)));
      break;
    case PathKind::polar_line:
    case PathKind::polar_arc:
    case PathKind::polar_tangent_arc:
      add_polar(kind, words);
      break;
  }
}

int Motions::turn_of(const MotionWords& words) {
  if (words.turn != 0) {
    last_turn_ = words.turn;
  } else if (last_turn_ == 0) {
    report(Severity::error, "arc-direction", 0, words.first_column, [] {
      return Text{NC_("core", "the arc has no direction"),
                  NC_("core", "counter-clockwise is assumed; write DR+ or DR-")};
    });
    last_turn_ = 1;
  }
  return last_turn_;
}

void Motions::add_center_arc(ContourElement element, const MotionWords& words) {
  if (targets_.has_pole(words.first_column)) {
    element.is_arc = true;
    element.center = *modal_.pole;
    element.plane = modal_.pole_plane;
    element.turn = turn_of(words);
  }
  contour_.add(element);
}

void Motions::add_radius_arc(ContourElement element, const MotionWords& words) {
  if (!words.radius) {
    report(Severity::error, "arc-radius", 2, words.first_column, [] {
      return Text{NC_("core", "the arc has no radius"),
                  NC_("core", "a straight line to its end is used instead; write R")};
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

void Motions::add_tangent_arc(ContourElement element) {
  const std::optional<Vec2> direction = contour_.direction();
  const Vec2 start = in_plane(contour_.position(), element.plane);
  const Vec2 chord = in_plane(element.target, element.plane) - start;
  if (!direction) {
    report(Severity::error, "tangent-arc", 0, element.place.place.column, [] {
      return Text{NC_("core", "a tangent arc without a preceding motion in the working plane"),
                  straight_instead};
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
        return Text{NC_("core", "the arc would end straight behind its start"), straight_instead};
      });
    }
  }
  contour_.add(element);
}

void Motions::add_polar(PathKind kind, const MotionWords& words) {
  if (!targets_.has_pole(words.first_column)) {
    return;
  }
  constexpr double same_angle = 1e-9;
  MotionWords polar = words;
  if (kind == PathKind::polar_arc) {
    polar.polar_radius.given = false;
  }
  ContourElement element = targets_.element(words, targets_.polar(polar));
  element.place.axes |= bits_of(modal_.pole_plane);
  element.plane = modal_.pole_plane;
  if (kind == PathKind::polar_tangent_arc) {
    add_tangent_arc(element);
    return;
  }
  if (kind == PathKind::polar_arc) {
    element.is_arc = true;
    element.center = *modal_.pole;
    const double angle = words.polar_angle.value;
    const bool by_sweep = words.polar_angle.given && words.polar_angle.incremental;
    if (by_sweep && words.turn == 0 && angle != 0) {
      last_turn_ = angle > 0 ? 1 : -1;
    }
    element.turn = turn_of(words);
    if (by_sweep && angle * element.turn < 0) {
      report(Severity::error, "arc-direction", 1, words.first_column, [&] {
        return Text{message(NC_("core", "an angle of {:.3f} degrees is opposite to the direction of the arc"),
                            units::to_deg(angle)),
                    NC_("core", "the sign of the angle is used; write both with the same sign")};
      });
      element.turn = last_turn_ = -element.turn;
    }
    if (by_sweep) {
      const double turns = std::abs(angle) / (2 * units::pi);
      const double whole = std::floor(turns + same_angle);
      element.extra_turns = whole;
      if (whole > 0 && turns - whole < same_angle) {
        // Ends that coincide already make one turn.
        element.extra_turns = whole - 1;
        element.target =
            from_plane(in_plane(contour_.position(), modal_.pole_plane), modal_.pole_plane, element.target);
      }
    }
  }
  contour_.add(element);
}

void Motions::run_corner(bool rounding, double size, const MotionWords& words, std::uint32_t column) {
  if (!(size > 0)) {
    throw ReadFault{"corner", column,
                    rounding ? message(NC_("core", "rounding {} mm is zero or negative"), size)
                             : message(NC_("core", "chamfer {} mm is zero or negative"), size),
                    NC_("core", "the corner stays sharp")};
  }
  ContourCorner corner;
  corner.rounding = rounding;
  corner.size = size;
  corner.place = contour_place(column, bits_of(plane()));
  corner.feed = feeds_.alone(words);
  contour_.add_corner(corner);
}

/// M91: machine coordinates; M92: relative to another datum set by the machine's builder.
bool Motions::goes_to_machine_position(const MotionWords& words) {
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
    named[static_cast<std::size_t>(first_axis(modal_.pole_plane))] = true;
    named[static_cast<std::size_t>(second_axis(modal_.pole_plane))] = true;
  }
  path().go_to_machine_place(named, places, words.feed_word == FeedWord::rapid ? 0 : path().feed_rate());
  machining_.report_machine_move(words.has_m(91) ? "M91" : "M92", "machine-position", words.first_column);
  return true;
}

/// TX, TY and TZ of LN.
void Motions::orient_tool(const MotionWords& words) {
  if (!words.tool_vector || !machining_.other_axes.turns()) {
    return;
  }
  if (!modal_.tool_centre_point) {
    report(Severity::warning, "rotary-direction", 1, words.vector_column, [] {
      return Text{NC_("core", "a tool direction (TX TY TZ) without M128 or FUNCTION TCPM"),
                  NC_("core", "the rotary axes stay; switch tool centre point control on before it")};
    });
    return;
  }
  const std::optional<Vec3> tool = machining_.tool_direction(*words.tool_vector, NC_("core", "TX, TY and TZ"),
                                                             "TZ+1", words.vector_column);
  if (!tool) {
    return;
  }
  end_contour(words.vector_column);
  const bool moves = words.has_axes() || words.has_polar();
  const bool rapid = words.feed_word == FeedWord::rapid;
  AxisBlock block = turning(rapid);
  block.alone = !moves;
  block.at_tip = true;
  block.great_circle = modal_.great_circle;
  machining_.other_axes.orient_tool(*tool, rapid ? AxisMotion::positions : AxisMotion::at_tip,
                                    words.vector_column, block);
}

/// M128 keeps the tip in place while the axes go linearly, M129 ends it; M126 makes them take the shortest
/// way, M127 ends it.
void Motions::follow_axis_functions(const MotionWords& words) {
  modal_.tool_centre_point = (modal_.tool_centre_point || words.has_m(128)) && !words.has_m(129);
  modal_.great_circle = modal_.great_circle && !words.has_m(128) && !words.has_m(129);
  modal_.shortest_way = (modal_.shortest_way || words.has_m(126)) && !words.has_m(127);
}

void Motions::move_other_axes(const MotionWords& words) {
  if (!words.has_other_axes) {
    follow_axis_functions(words);
    return;
  }
  const bool moves = words.has_axes() || words.has_polar();
  const bool rapid = words.feed_word == FeedWord::rapid;
  if (machining_.other_axes.turns()) {
    end_contour(words.first_column);
    if (std::exchange(modal_.calculated_angles, false)) {
      machining_.other_axes.turn_tool(path().frame().turned(Vec3::UnitZ()), 0, turning(rapid).feed);
      return;
    }
  }
  follow_axis_functions(words);
  AxisBlock block = turning(rapid);
  block.alone = !moves;
  block.at_tip = modal_.tool_centre_point;
  block.way = modal_.shortest_way ? AxisBlock::Way::shortest : AxisBlock::Way::written;
  block.great_circle = modal_.great_circle;
  for (std::size_t i = 0; i < other_axis_letters.size(); ++i) {
    const bool rotary = i < 3;
    const double target = words.other_axes[i].from(other_places_[i]);
    if (target != other_places_[i]) {
      const bool positions = rotary && (!moves || words.feed_word == FeedWord::rapid);
      machining_.other_axes.move(other_axis_letters.substr(i, 1), target,
                                 positions ? AxisMotion::positions : AxisMotion::cuts, words.other_columns[i],
                                 block);
    }
    other_places_[i] = target;
  }
}

/// Rotary axes alone: F is in degrees a minute, as written.
AxisBlock Motions::turning(bool rapid) const {
  AxisBlock block;
  block.alone = true;
  if (!rapid && modal_.feed.mode == FeedMode::per_minute) {
    block.feed = units::from_deg(modal_.feed.value / modal_.to_feed(units::to_mm_min(1)));
  }
  return block;
}

}  // namespace feedscope::heidenhain

#include "core/program/heidenhain/language/plane_statements.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/units.h"
#include "core/program/text/read_fault.h"

namespace feedscope::heidenhain {

namespace {

/// Frame turned about X, then Y, then Z of the untilted system (TNC 620 user's manual, PLANE SPATIAL:
/// sequence A-B-C) [rad].
CoordinateFrame tilted_by(const std::array<double, 3>& angles) {
  CoordinateFrame frame;
  for (int axis = 0; axis < 3; ++axis) {
    frame = CoordinateFrame::rotation(Vec3::Unit(axis), angles[static_cast<std::size_t>(axis)]) * frame;
  }
  return frame;
}

/// Frame with Z' along `normal` and X' in the plane as near as possible to `base`; none where they do not
/// span a plane.
std::optional<CoordinateFrame> tilted_to(const Vec3& base, const Vec3& normal) {
  constexpr double parallel = 1e-9;
  const Vec3 y = normal.cross(base);
  if (!(y.norm() > parallel * normal.norm() * base.norm())) {
    return std::nullopt;
  }
  Eigen::Matrix3d turn;
  turn.col(2) = normal.normalized();
  turn.col(1) = y.normalized();
  turn.col(0) = turn.col(1).cross(turn.col(2));
  const Eigen::AngleAxisd rotation(turn);
  return CoordinateFrame::rotation(rotation.axis(), rotation.angle());
}

}  // namespace

bool PlaneStatements::run(Scanner& scanner, std::uint32_t column) {
  const std::string_view form = scanner.name();
  std::optional<CoordinateFrame> tilt;
  if (letters::same(form, "SPATIAL")) {
    tilt = tilted_by(named_angles(scanner, {"SPA", "SPB", "SPC"}));
  } else if (letters::same(form, "RELATIV") || letters::same(form, "RELATIVE")) {
    tilt = coordinates_.transformations().tilt() * tilted_by(named_angles(scanner, {"SPA", "SPB", "SPC"}));
  } else if (letters::same(form, "EULER")) {
    const auto angles = named_angles(scanner, {"EULPR", "EULNU", "EULROT"});
    tilt = CoordinateFrame::rotation(Vec3::UnitZ(), angles[0]) *
           CoordinateFrame::rotation(Vec3::UnitX(), angles[1]) *
           CoordinateFrame::rotation(Vec3::UnitZ(), angles[2]);
  } else if (letters::same(form, "VECTOR")) {
    tilt = by_vectors(scanner, column);
  } else if (letters::same(form, "AXIAL")) {
    tilt = by_axes(scanner, column);
  } else if (letters::same(form, "POINTS")) {
    tilt = by_points(scanner, column);
  } else if (!letters::same(form, "RESET")) {
    coordinates_.set_tilt(std::nullopt, column);
    return false;
  }
  const Positioning positioning = read_positioning(scanner);
  retract(positioning, column);
  coordinates_.set_tilt(tilt, column);
  turn_axes(positioning, !tilt, column);
  return true;
}

std::array<double, 3> PlaneStatements::named_angles(Scanner& scanner,
                                                    const std::array<std::string_view, 3>& names) const {
  std::array<double, 3> angles{};
  for (std::size_t i = 0; i < names.size();) {
    if (scanner.take(names[i])) {
      angles[i] = units::from_deg(read_value(scanner));
      i = 0;
    } else {
      ++i;
    }
  }
  return angles;
}

CoordinateFrame PlaneStatements::by_vectors(Scanner& scanner, std::uint32_t column) const {
  std::array<Vec3, 2> vectors{Vec3::Zero(), Vec3::Zero()};
  for (char letter = letters::to_upper(scanner.peek()); letter == 'B' || letter == 'N';
       letter = letters::to_upper(scanner.peek())) {
    const char axis = letters::to_upper(scanner.peek_at(1));
    if (axis < 'X' || axis > 'Z') {
      break;
    }
    scanner.move_to(scanner.at() + 2);
    vectors[letter == 'B' ? 0 : 1][axis - 'X'] = read_value(scanner);
  }
  const std::optional<CoordinateFrame> tilt = tilted_to(vectors[0], vectors[1]);
  if (!tilt) {
    throw ReadFault{"plane", column, NC_("core", "the vectors of PLANE VECTOR do not span a plane"),
                    NC_("core", "the plane does not change; check BX BY BZ and NX NY NZ")};
  }
  return *tilt;
}

/// X' runs from the first point to the second, Y' towards the third; the datum is unchanged.
CoordinateFrame PlaneStatements::by_points(Scanner& scanner, std::uint32_t column) const {
  std::array<Vec3, 3> points{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
  while (letters::to_upper(scanner.peek()) == 'P' && letters::is_digit(scanner.peek_at(1))) {
    const int point = scanner.peek_at(1) - '1';
    const int axis = letters::to_upper(scanner.peek_at(2)) - 'X';
    if (point < 0 || point > 2 || axis < 0 || axis > 2) {
      break;
    }
    scanner.move_to(scanner.at() + 3);
    points[static_cast<std::size_t>(point)][axis] = read_length(scanner);
  }
  const Vec3 base = points[1] - points[0];
  const std::optional<CoordinateFrame> tilt = tilted_to(base, base.cross(points[2] - points[0]));
  if (!tilt) {
    throw ReadFault{"plane", column, NC_("core", "the points of PLANE POINTS are on one line"),
                    NC_("core", "the plane does not change; check P1X to P3Z")};
  }
  return *tilt;
}

/// Reads how the axes turn there.
PlaneStatements::Positioning PlaneStatements::read_positioning(Scanner& scanner) const {
  Positioning positioning;
  constexpr std::array<std::string_view, 7> names{"TURN", "MAX", "FMAX", "FAUTO", "TABLE", "COORD", "ROT"};
  const auto take_a_name = [&] {
    return std::any_of(names.begin(), names.end(),
                       [&](std::string_view name) { return scanner.take_keyword(name); });
  };
  while (!scanner.at_end()) {
    if (scanner.take_keyword("STAY")) {
      positioning.turns = false;
      continue;
    }
    if (scanner.take_keyword("MOVE")) {
      positioning.shifts = true;
      continue;
    }
    if (take_a_name()) {
      continue;
    }
    if (scanner.take("SEQ") || scanner.take("SYM")) {
      positioning.side = scanner.take('+') ? 1 : scanner.take('-') ? -1 : 0;
    } else if (scanner.take("MB")) {
      positioning.retract =
          scanner.take_keyword("MAX") ? std::numeric_limits<double>::infinity() : read_length(scanner);
    } else if (scanner.take('F')) {
      if (!scanner.take_keyword("MAX") && !scanner.take_keyword("AUTO")) {
        positioning.feed = units::from_deg(read_value(scanner) / 60);
      }
    } else if (scanner.take("DIST") || scanner.take("ABST") || scanner.take("SETUP")) {
      read_value(scanner);
    } else {
      throw_unread_words(scanner, Message::as_written("PLANE"));
    }
  }
  return positioning;
}

/// Before the axes turn: along the tool, which is normal to the plane in force (TNC 620 user's manual,
/// 10/2017, PLANE: MB).
void PlaneStatements::retract(const Positioning& positioning, std::uint32_t column) {
  if (!positioning.turns) {
    return;
  }
  const bool to_limit = positioning.retract && !std::isfinite(*positioning.retract);
  const bool shifts = positioning.shifts && machining_.other_axes.turns();
  if (to_limit || shifts) {
    report(to_limit ? Severity::warning : Severity::info, "swivel-retract", to_limit ? 1 : 2, column, [&] {
      return to_limit
                 ? Text{NC_("core", "the tool retracts to the end of travel before the axes turn (MB MAX)"),
                        NC_("core", "this motion is neither drawn nor timed, nor is the way back")}
                 : Text{NC_("core", "X, Y and Z move while the rotary axes turn (MOVE)"),
                        NC_("core", "this motion is neither drawn nor timed")};
    });
  }
  if (!positioning.retract || to_limit || *positioning.retract == 0) {
    return;
  }
  ContourElement element;
  element.target = contour_.position();
  element.target[normal_axis(plane())] += *positioning.retract;
  element.plane = plane();
  element.feed.rapid = true;
  element.place = contour_place(column, 0);
  contour_.add(element);
  end_contour(column);
}

/// RESET turns the axes to zero. With STAY the program positions the axes itself, by Q120 to Q122.
void PlaneStatements::turn_axes(const Positioning& positioning, bool resets, std::uint32_t column) {
  OtherAxes& axes = machining_.other_axes;
  if (!positioning.turns) {
    if (axes.turns()) {
      report(Severity::info, "rotary-position", 1, column, [] {
        return Text{NC_("core", "the rotary axes stay where they are (STAY)"),
                    NC_("core", "they turn where the program positions them, as with L A+Q120 C+Q122")};
      });
    }
  } else if (resets) {
    axes.turn_to_zero(positioning.feed);
  } else {
    axes.turn_tool(path().frame().turned(Vec3::UnitZ()), positioning.side, positioning.feed);
  }
}

void PlaneStatements::run_cycle(Scanner& scanner, std::uint32_t column) {
  const std::optional<CoordinateFrame> tilt = by_axes(scanner, column);
  read_positioning(scanner);
  coordinates_.set_tilt(tilt, column);
  if (machining_.other_axes.turns()) {
    report(Severity::info, "rotary-position", 2, column, [] {
      return Text{
          NC_("core", "cycle 19 tilts the plane"),
          NC_("core", "the rotary axes turn where the program positions them, as with L A+Q120 C+Q122")};
    });
  }
}

std::optional<CoordinateFrame> PlaneStatements::by_axes(Scanner& scanner, std::uint32_t column) const {
  std::array<double, 3> angles{};
  bool any = false;
  while (true) {
    const char letter = letters::to_upper(scanner.peek());
    const bool is_distance = Scanner(scanner).take("ABST");
    if (letter < 'A' || letter > 'C' || is_distance) {
      break;
    }
    scanner.take(letter);
    angles[static_cast<std::size_t>(letter - 'A')] = units::from_deg(read_value(scanner));
    any = true;
  }
  if (std::count(angles.begin(), angles.end(), 0.0) < 2) {
    report(Severity::warning, "tilt-angles", 0, column, [] {
      return Text{
          NC_("core", "the plane is tilted by angles of more than one axis"),
          NC_("core",
              "the plane depends on the machine; they are used as spatial angles, as in PLANE SPATIAL")};
    });
  }
  return any ? std::optional(tilted_by(angles)) : std::nullopt;
}

}  // namespace feedscope::heidenhain

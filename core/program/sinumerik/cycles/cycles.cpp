#include "core/program/sinumerik/cycles/cycles.h"

#include <charconv>
#include <cmath>
#include <vector>

#include "core/base/units.h"
#include "core/program/cycles/hole_patterns.h"
#include "core/program/path/plane_points.h"
#include "core/program/sinumerik/language/names.h"
#include "core/program/text/message.h"

namespace feedscope::sinumerik {

namespace {

/// 81 of "CYCLE81"; -1 for other names.
int cycle_number(std::string_view name) {
  constexpr std::string_view beginning = "CYCLE";
  int number = -1;
  if (letters::same(name.substr(0, beginning.size()), beginning)) {
    const std::string_view digits = name.substr(beginning.size());
    const auto [stop, status] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    number = status == std::errc() && stop == digits.data() + digits.size() ? number : -1;
  }
  return number;
}

/// HOLES1(SPCA, SPCO, STA1, FDIS, DBH, NUM): a row, the first hole FDIS from its reference point; HOLES2(CPA,
/// CPO, RAD, STA1, INDA, NUM): a circle, without INDA over a whole turn.
std::vector<Vec2> places_of_holes(const Arguments& arguments, bool circle, int count) {
  const auto number = [&](std::size_t place) { return number_at(arguments, place); };
  const Vec2 reference(number(0), number(1));
  if (circle) {
    const double step = number(4) != 0 ? units::from_deg(number(4)) : 2 * units::pi / count;
    return places_of(CirclePattern{.center = reference,
                                   .diameter = 2 * number(2),
                                   .start = units::from_deg(number(3)),
                                   .step = step,
                                   .count = count});
  }
  const double angle = units::from_deg(number(2));
  return places_of(RowPattern{.start = reference + turned(Vec2(number(3), 0), angle),
                              .spacing = number(4),
                              .angle = angle,
                              .count = count});
}

}  // namespace

bool Cycles::run(const SubprogramCall& call, const SubprogramCall* modal) {
  const int number = cycle_number(call.name);
  if (number == 832) {
    high_speed_settings(call);
  } else if (number == 800) {
    swivel(call);
  } else if (letters::same(call.name, "HOLES1") || letters::same(call.name, "HOLES2")) {
    hole_pattern(call, modal);
  } else if (const auto plan = drill_plan(number, call.arguments, drilling_place())) {
    parts_.splines.finish();
    check_depth(number, call);
    drill(*plan);
  } else {
    return false;
  }
  return true;
}

/// _GMODE of centring and drilling: the depth may refer to the tool's diameter or shank, whose height above
/// the tip the program does not give.
void Cycles::check_depth(int number, const SubprogramCall& call) const {
  const bool by_tip = static_cast<int>(number_at(call.arguments, 6)) / 10 % 10 == 0;
  if (by_tip || (number != 81 && number != 82)) {
    return;
  }
  report(Severity::error, "hole-depth", number, call.column, [&] {
    return Text{
        message(NC_("core", "the depth of CYCLE{} at the tool's diameter or shank is not supported"), number),
        NC_("core", "it is used as the depth of the tip")};
  });
}

DrillingPlace Cycles::drilling_place() const {
  return {modal_.plane,
          path().position(),
          to_mm(1),
          path().feed(),
          path().feed_mode(),
          path().spindle_speed(),
          [this](double value) { return parts_.feeds.feed_of(value); }};
}

void Cycles::drill(const DrillPlan& plan) {
  parts_.last.set_line();
  feedscope::run(plan, path(), path().position(), [&](bool rapid) {
    parts_.last.set_start(path().position());
    parts_.path_modes.use(rapid);
  });
}

/// Runs the modal cycle at every hole.
void Cycles::hole_pattern(const SubprogramCall& call, const SubprogramCall* modal) {
  constexpr double max_holes = 1000;
  const double count = number_at(call.arguments, 5);
  if (!(count >= 1 && count <= max_holes)) {
    report(Severity::error, "hole-count", 0, call.column, [&] {
      return Text{message(NC_("core", "{} is not a number of holes from 1 to {}"), count, max_holes),
                  NC_("core", "the holes are skipped; correct the number")};
    });
    return;
  }
  parts_.splines.finish();
  for (const Vec2& place :
       places_of_holes(call.arguments, call.name.back() == '2', static_cast<int>(count))) {
    const Vec3 at = from_plane(to_mm(1) * place, modal_.plane, path().position());
    parts_.targets.program_axis(first_axis(modal_.plane));
    parts_.targets.program_axis(second_axis(modal_.plane));
    parts_.path_modes.use(true);
    path().rapid(at);
    if (modal != nullptr && cycle_number(modal->name) > 0) {
      run(*modal, modal);
    } else if (modal != nullptr) {
      report(Severity::error, "unread-cycle", 0, call.column, [&] {
        return Text{message(NC_("core", "subprogram {} at a pattern of holes is not supported"), modal->name),
                    NC_("core", "its motion is skipped; call it after single positions")};
      });
    }
  }
  parts_.last.set_line();
}

void Cycles::high_speed_settings(const SubprogramCall& call) {
  const double tolerance = number_at(call.arguments, 0);
  const double code = number_at(call.arguments, 1);
  constexpr double max_code = 1e8;
  if (!(tolerance >= 0 && code >= 0 && code < max_code)) {
    report(Severity::error, "path-value", 0, call.column, [&] {
      return Text{
          message(NC_("core", "CYCLE832 with tolerance {} and code {} is out of range"), tolerance, code),
          NC_("core", "it is ignored; write a tolerance of zero or more and a code from 0 to 99999999")};
    });
    return;
  }
  const int digits = static_cast<int>(code);
  if (tolerance > 0 && digits % 10 == 0) {
    report(Severity::warning, "path-value", 1, call.column, [&] {
      return Text{
          message(NC_("core", "CYCLE832 with tolerance {} and machining type 0 switches its settings off"),
                  tolerance),
          NC_("core", "write the type as the second value: 1 finishing, 2 semi-finishing, 3 roughing")};
    });
  }
  if (digits % 10 != 0) {
    report(Severity::info, "machining-mode", 0, call.column, [&] {
      return Text{
          message(NC_("core", "machining type {} of CYCLE832 changes nothing in the simulation"),
                  digits % 10),
          NC_("core",
              "its parameters exist only in the control; set acceleration and jerk of the machine instead")};
    });
  }
  std::optional<double> orientation;
  if (digits / 10 % 10 == 1) {
    orientation = units::from_deg(number_at(call.arguments, 2));
  }
  parts_.path_modes.set_cycle(to_mm(tolerance), digits, orientation, call.column);
}

/// CYCLE800(FR, TC, ST, MODE, X0, Y0, Z0, A, B, C, X1, Y1, Z1, ...): shifts the plane by X0, turns it about
/// one axis after the other and shifts it by X1.
void Cycles::swivel(const SubprogramCall& call) {
  parts_.splines.finish();
  const Arguments& values = call.arguments;
  const auto vector = [&](std::size_t place) -> Vec3 {
    return {number_at(values, place), number_at(values, place + 1), number_at(values, place + 2)};
  };
  constexpr double usual_mode = 57;  // about X, then Y, then Z
  const int mode = static_cast<int>(number_at(values, 3, usual_mode));
  const Vec3 angles = vector(7);
  CoordinateFrame frame = CoordinateFrame::shift(vector(4) * to_mm(1));
  bool turns = mode >= 0 && mode < 64;
  for (int i = 0; i < 3; ++i) {
    turns = turns && (angles[i] == 0 || (mode >> (2 * i) & 3) > 0);
  }
  if (!angles.isZero() && !turns) {
    report(Severity::error, "swivel", 0, call.column, [&] {
      return Text{
          message(NC_("core", "CYCLE800 with mode {} is not supported"), mode),
          NC_("core", "the plane is shown without rotation; program angles about one axis after the other")};
    });
    return;
  }
  for (int i = 0; i < 3; ++i) {
    const int axis = mode >> (2 * i) & 3;
    if (axis > 0) {
      frame = frame * CoordinateFrame::rotation(Vec3::Unit(axis - 1), units::from_deg(angles[i]));
    }
  }
  frame = frame * CoordinateFrame::shift(vector(10) * to_mm(1));
  const bool additive = static_cast<int>(number_at(values, 2)) % 10 == 1;
  retract(call);
  parts_.coordinates.swivel(frame, additive);
  turn_tool(call);
}

/// Before the axes turn: by _FR_I along the tool, which is normal to the plane in force, or to the place
/// given by machine data.
void Cycles::retract(const SubprogramCall& call) {
  constexpr int along_tool = 5;
  constexpr std::size_t way_place = 14;
  const int kind = static_cast<int>(number_at(call.arguments, 0));
  const double way = to_mm(number_at(call.arguments, way_place));
  if (kind == along_tool && way > 0) {
    Vec3 target = path().position();
    target[normal_axis(modal_.plane)] += way;
    parts_.last.set_line();
    parts_.path_modes.use(true);
    path().rapid(target);
  } else if (kind != 0) {
    report(Severity::warning, "swivel-retract", 0, call.column, [&] {
      return Text{message(NC_("core", "the tool retracts before the axes turn (_FR {} of CYCLE800)"), kind),
                  NC_("core", "where to, the machine's data says: this motion is neither drawn nor timed")};
    });
  }
}

/// Turn of the rotary axes by CYCLE800: _DIR is the side, 0: it only calculates the plane. Without arguments
/// it cancels the plane, and the axes stay.
void Cycles::turn_tool(const SubprogramCall& call) {
  constexpr std::size_t direction_place = 13;
  constexpr double missing = 2;
  if (call.arguments.empty()) {
    return;
  }
  const double side = number_at(call.arguments, direction_place, missing);
  if (side == 0) {
    return;
  }
  if (side == missing && machining_.other_axes.turns()) {
    report(Severity::info, "rotary-position", 0, call.column, [] {
      return Text{NC_("core", "CYCLE800 says no direction (_DIR) of the rotary axes"),
                  NC_("core", "they turn the shortest way to the plane")};
    });
  }
  machining_.other_axes.turn_tool(path().frame().turned(Vec3::UnitZ()), side == missing ? 0
                                                                        : side > 0      ? 1
                                                                                        : -1);
}

}  // namespace feedscope::sinumerik

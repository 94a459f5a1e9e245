// The part of SinumerikReader that runs the control's own cycles.
#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "core/base/units.h"
#include "core/program/cycles/hole_patterns.h"
#include "core/program/path/plane_points.h"
#include "core/program/sinumerik/names.h"
#include "core/program/sinumerik/sinumerik_reader.h"
#include "core/program/text/message.h"

namespace feedscope {

using namespace sinumerik;

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

bool SinumerikReader::run_cycle(const SubprogramCall& call) {
  const int number = cycle_number(call.name);
  if (number == 832) {
    high_speed_settings(call);
  } else if (number == 800) {
    swivel(call);
  } else if (letters::same(call.name, "HOLES1") || letters::same(call.name, "HOLES2")) {
    hole_pattern(call.arguments, call.name.back() == '2', call.column);
  } else if (const auto plan = drill_plan(number, call.arguments, drilling_place())) {
    finish_spline();
    check_depth(number, call);
    drill(*plan);
  } else {
    return false;
  }
  return true;
}

/// _GMODE of centring and drilling: the depth may be meant of the tool's diameter or shank, whose height over
/// the tip the program does not tell.
void SinumerikReader::check_depth(int number, const SubprogramCall& call) {
  const bool by_tip = static_cast<int>(number_at(call.arguments, 6)) / 10 % 10 == 0;
  if (by_tip || (number != 81 && number != 82)) {
    return;
  }
  report(Severity::error, "hole-depth", number, call.column, [&] {
    return Text{fmt::format("the depth of CYCLE{} by the tool's diameter or shank is not read", number),
                "it is taken as that of the tip"};
  });
}

DrillingPlace SinumerikReader::drilling_place() {
  return {modal_.plane,
          path().position(),
          to_mm(1),
          path().feed(),
          path().feed_mode(),
          path().spindle_speed(),
          [this](double value) { return feed_of(value); }};
}

void SinumerikReader::drill(const DrillPlan& plan) {
  last_arc_.reset();
  feedscope::run(plan, path(), path().position(), [&](bool rapid) {
    start_ = path().position();
    use_path_control(rapid);
  });
}

/// The modal cycle at every hole.
void SinumerikReader::hole_pattern(const Arguments& arguments, bool circle, std::uint32_t column) {
  constexpr double most_holes = 1000;
  const double count = number_at(arguments, 5);
  if (!(count >= 1 && count <= most_holes)) {
    report(Severity::error, "hole-count", 0, column, [&] {
      return Text{fmt::format("a pattern of {} holes is not within 1 to {}", count, most_holes),
                  "the holes are left out"};
    });
    return;
  }
  finish_spline();
  for (const Vec2& place : places_of_holes(arguments, circle, static_cast<int>(count))) {
    const Vec3 at = from_plane(to_mm(1) * place, modal_.plane, path().position());
    program_axis(first_axis(modal_.plane));
    program_axis(second_axis(modal_.plane));
    use_path_control(true);
    path().rapid(at);
    if (modal_call_ && cycle_number(modal_call_->call.name) > 0) {
      run_cycle(modal_call_->call);
    } else if (modal_call_) {
      report(Severity::error, "unread-cycle", 0, column, [&] {
        return Text{
            fmt::format("the subprogram {} at a pattern of holes is not read", modal_call_->call.name),
            "its motion is left out; call it behind single positions"};
      });
    }
  }
  last_arc_.reset();
}

void SinumerikReader::high_speed_settings(const SubprogramCall& call) {
  const double tolerance = number_at(call.arguments, 0);
  const double code = number_at(call.arguments, 1);
  constexpr double most = 1e8;
  if (!(tolerance >= 0 && code >= 0 && code < most)) {
    report(Severity::error, "path-value", 0, call.column, [&] {
      return Text{fmt::format("CYCLE832 with tolerance {} and code {}", tolerance, code),
                  "it is left out; neither may be negative"};
    });
    return;
  }
  const int digits = static_cast<int>(code);
  if (tolerance > 0 && digits % 10 == 0) {
    report(Severity::warning, "path-value", 1, call.column, [&] {
      return Text{
          fmt::format("CYCLE832 with tolerance {} and machining type 0 switches its settings off", tolerance),
          "write the type as second value: 1 finishing, 2 semi-finishing, 3 roughing"};
    });
  }
  std::optional<double> orientation;
  if (digits / 10 % 10 == 1) {
    orientation = units::from_deg(number_at(call.arguments, 2));
  }
  path_words_.set_cycle(to_mm(tolerance), digits, orientation);
  applied_ = Applied::none;
}

/// CYCLE800(FR, TC, ST, MODE, X0, Y0, Z0, A, B, C, X1, Y1, Z1, ...): the plane is shifted by X0, turned about
/// one axis after the other and shifted by X1.
void SinumerikReader::swivel(const SubprogramCall& call) {
  finish_spline();
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
      return Text{fmt::format("CYCLE800 with mode {} is not read", mode),
                  "the plane is shown unturned; angles about one axis after the other are read"};
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
  frames_.set_swivel(additive ? frames_.swivel() * frame : frame);
  set_frame();
}

}  // namespace feedscope

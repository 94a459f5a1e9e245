#include "core/program/path/path_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "core/program/path/curve_arcs.h"
#include "core/program/path/curve_lines.h"

namespace feedscope {

namespace {

struct ArcShape {
  Vec3 from;  ///< from the centre to the start, in the plane
  double sweep = 0;
  double length = 0;
};

ArcShape shape_of(const Vec3& start, const ArcSolution::Piece& piece) {
  const Vec3& axis = piece.words.axis;
  const auto in_plane = [&](const Vec3& v) -> Vec3 { return v - axis.dot(v) * axis; };
  ArcShape shape;
  shape.from = in_plane(start - piece.words.center);
  const Vec3 to = in_plane(piece.target - piece.words.center);
  if ((to - shape.from).norm() > same_point) {
    shape.sweep = std::atan2(axis.dot(shape.from.cross(to)), shape.from.dot(to));
    shape.sweep += shape.sweep < 0 ? 2 * std::numbers::pi : 0;
  }
  shape.sweep += 2 * std::numbers::pi * piece.words.turns;
  shape.length = std::hypot(shape.from.norm() * shape.sweep, axis.dot(piece.target - start));
  return shape;
}

}  // namespace

PathWriter::PathWriter(ReadProgram& program, DiagnosticLog& log)
    : program_(program), log_(log), extents_(program), feed_(log), corners_(log), compensation_(log) {
  program_.path_controls.emplace_back();
}

void PathWriter::begin_line(std::uint32_t shown, const DiagnosticLog::Place& place) {
  line_ = shown;
  place_ = place;
  axes_ = {};
}

void PathWriter::finish() {
  end_corners();
  compensation_.finish();
  write_ready();
}

void PathWriter::set_frame(const CoordinateFrame& frame) {
  frame_ = frame;
  programmed_ = frame_.is_identity() ? shown_ : frame_.to_programmed(shown_);
  if (compensation_.is_on()) {
    end_corners();
    compensation_.switch_on(compensation_in_frame(), shown_, place_);
    write_ready();
  }
}

void PathWriter::set_compensation(ToolSide side, double radius, const CompensationRule& rule, Plane plane,
                                  std::uint32_t column) {
  end_corners();
  compensation_words_ = {side, radius, rule, {normal_of(plane), Vec3::Unit(first_axis(plane))}};
  if (!places_.all_shown()) {
    compensation_waits_ = true;
    return;
  }
  compensation_.switch_on(compensation_in_frame(), shown_, {place_.line, column, place_.file});
  write_ready();
}

void PathWriter::end_compensation() {
  end_corners();
  compensation_waits_ = false;
  compensation_.switch_off();
  write_ready();
}

Compensation PathWriter::compensation_in_frame() const {
  Compensation turned = compensation_words_;
  turned.plane = plane_in_frame(turned.plane);
  return turned;
}

ContourPlane PathWriter::plane_in_frame(const ContourPlane& plane) const {
  if (frame_.is_shift()) {
    return plane;
  }
  return {(frame_.mirrors() ? -1 : 1) * frame_.turned(plane.normal).normalized(),
          frame_.turned(plane.first_axis).normalized()};
}

void PathWriter::cut_next_corner(CornerCut cut, Plane plane) {
  const double scale = frame_.is_shift() ? 1 : frame_.scale_across(normal_of(plane));
  if (scale == 0) {
    log_.add(Severity::error, "corner", 1, cut.place, [] {
      return DiagnosticLog::Text{
          NC_("core", "a rounding or chamfer of a non-uniformly scaled contour is not supported"),
          NC_("core", "the corner stays sharp")};
    });
    return;
  }
  cut.size *= scale;
  corners_.cut_next(cut, plane_in_frame({normal_of(plane), Vec3::Unit(first_axis(plane))}));
  pass_corners_on();
}

void PathWriter::end_motion() {
  if (!corners_.is_idle()) {
    corners_.end_motion();
  }
}

void PathWriter::end_corners() {
  if (!corners_.is_idle()) {
    corners_.finish();
    pass_corners_on();
  }
}

void PathWriter::pass_corners_on() {
  for (const PathMotion& motion : corners_.ready()) {
    compensate(motion);
  }
  corners_.ready().clear();
}

void PathWriter::rapid(const Vec3& target) {
  append(Motion::rapid, target, 0);
  end_motion();
}

void PathWriter::chord(const Vec3& target) {
  append(Motion::line, target, feed_.over((target - programmed_).norm(), place_));
}

void PathWriter::line(const Vec3& target) {
  chord(target);
  end_motion();
}

void PathWriter::arc_by_center(const ArcRequest& request) {
  const ArcSolution solution = solve_center_arc(programmed_, request.target, request.center, request.axis,
                                                request.extra_turns, request.tolerance);
  ++centers_.arcs;
  centers_.misfits += solution.fault == ArcFault::none ? 0 : 1;
  arc(request, solution);
}

void PathWriter::arc_by_radius(const ArcRequest& request) {
  arc(request,
      solve_radius_arc(programmed_, request.target, request.radius, request.axis, request.extra_turns));
}

void PathWriter::arc(const ArcRequest& request, const ArcSolution& solution) {
  if (solution.fault != ArcFault::none) {
    report_arc_fault(request, solution);
    line(request.target);
    return;
  }
  for (int i = 0; i < solution.count; ++i) {
    const ArcSolution::Piece& piece = solution.pieces[static_cast<std::size_t>(i)];
    const bool takes_a_time = feed_.mode() == FeedMode::inverse_time;
    const double feed = feed_.over(takes_a_time ? shape_of(programmed_, piece).length : 1, place_);
    ArcWords shown = piece.words;
    if (!frame_.is_identity()) {
      shown.center = frame_.to_shown(shown.center);
      shown.misfit = frame_.turned(shown.misfit);
    }
    if (!frame_.is_shift()) {
      if (frame_.scale_across(piece.words.axis) == 0) {
        straight_arc(request, piece);
        continue;
      }
      shown.axis = (frame_.mirrors() ? -1 : 1) * frame_.turned(piece.words.axis).normalized();
    }
    append(Motion::arc, piece.target, feed, shown);
  }
  end_motion();
}

void PathWriter::straight_arc(const ArcRequest& request, const ArcSolution::Piece& piece) {
  constexpr double chord_error = 1e-3;
  constexpr double max_chords = 1e5;
  log_.add(Severity::info, "scaled-arc", 0, {place_.line, request.column, place_.file}, [] {
    return DiagnosticLog::Text{NC_("core", "the arc is scaled non-uniformly and becomes an ellipse"),
                               NC_("core", "it is approximated by lines within 0.001 mm")};
  });
  const ArcShape shape = shape_of(programmed_, piece);
  const Vec3 start = programmed_;
  const Vec3 side = piece.words.axis.cross(shape.from);
  const double radius = std::max(frame_.turned(shape.from).norm(), frame_.turned(side).norm());
  const double step = 2 * std::acos(std::max(0.0, 1 - chord_error / std::max(radius, chord_error)));
  const double count = std::clamp(std::ceil(shape.sweep / step), 1.0, max_chords);
  const double rise = piece.words.axis.dot(piece.target - start);
  for (double i = 1; i <= count; ++i) {
    const double angle = shape.sweep * i / count;
    const Vec3 on_circle = start - shape.from + std::cos(angle) * shape.from + std::sin(angle) * side;
    chord(i < count ? Vec3(on_circle + rise * i / count * piece.words.axis) : piece.target);
  }
}

void PathWriter::dwell(double seconds) {
  wait(Pause::dwell, seconds);
}

void PathWriter::pause(Pause kind) {
  wait(kind, 0);
}

void PathWriter::wait(Pause kind, double seconds) {
  MotionBlock block = block_to(shown_, Motion::dwell);
  block.dwell = seconds;
  block.pause = kind;
  pass_on({block, {}, place_, {}}, shown_);
}

bool PathWriter::go_to_machine_place(const std::array<bool, 3>& moved, const AxisPlaces& to, double feed) {
  AxisPlaces places = to;
  Vec3 target = shown_;
  bool known = true;
  for (std::size_t axis = 0; axis < places.size(); ++axis) {
    AxisPlace& place = places[axis];
    place.zero_given = machine_axes_[axis];
    if (place.kind == AxisPlace::Kind::machine && place.zero_given) {
      place.kind = AxisPlace::Kind::part;
    }
    if (moved[axis] && place.is_shown()) {
      target[static_cast<Eigen::Index>(axis)] = place.value;
      axes_.named[axis] = true;
    }
    known = known && (!moved[axis] || place.is_shown());
  }
  suspend_compensation();
  if (known && places_.all_shown()) {
    append(feed > 0 ? Motion::line : Motion::rapid, frame_.to_programmed(target), feed);
  } else {
    places_.go_to(moved, places, shown_);
    shown_ = target;
    programmed_ = frame_.to_programmed(target);
    write_machine_move(shown_, feed);
  }
  resume_compensation();
  return known;
}

bool PathWriter::name_place(const std::array<bool, 3>& axes) {
  bool assumes = false;
  for (int axis = 0; axis < 3; ++axis) {
    assumes = assumes || (axes[static_cast<std::size_t>(axis)] && !places_.is_shown(axis));
  }
  if (assumes) {
    places_.assume(shown_, axes);
    write_machine_move(shown_, 0);
    resume_compensation();
  }
  return assumes;
}

/// Checks a motion that begins while some axes are unknown and that has brought the path to position().
/// Returns false if it is written, as a machine move.
bool PathWriter::starts_at_known_place(Motion motion, double feed, const Vec3& programmed,
                                       const Vec3& shown) {
  const AxisPlaces before = places_.places();
  places_.move(frame_, axes_, programmed, programmed_);
  const bool assumes = motion != Motion::rapid && !places_.all_shown();
  if (!assumes) {
    write_machine_move(shown_, feed);
    resume_compensation();
    return false;
  }
  log_.add(Severity::warning, "unknown-position", 0, place_, [&] {
    std::string axes;
    for (int axis = 0; axis < 3; ++axis) {
      axes += places_.is_shown(axis) ? ""
                                     : fmt::format("{}{}", axes.empty() ? "" : ", ",
                                                   coordinate_names[static_cast<std::size_t>(axis)]);
    }
    return DiagnosticLog::Text{
        message(NC_("core", "a feed move while the position of {} is not known"), axes),
        NC_("core",
            "the axis is assumed where it was before the move to the machine position; program it first")};
  });
  bool only_unknown_axes_stay = true;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const bool came_to_be_known = !before[axis].is_shown() && places_.places()[axis].is_shown();
    only_unknown_axes_stay = only_unknown_axes_stay && !came_to_be_known;
  }
  places_.assume(shown_);
  write_machine_move(only_unknown_axes_stay ? shown : shown_, feed);
  resume_compensation();
  return only_unknown_axes_stay;
}

void PathWriter::write_machine_move(const Vec3& target, double feed) {
  MotionBlock block = block_to(target, Motion::dwell);
  block.feed = feed;
  block.arc = static_cast<std::int32_t>(program_.machine_moves.size());
  block.pause = Pause::machine_move;
  program_.machine_moves.push_back({places_.places(), feed});
  program_.motions.push_back(block);
  std::array<bool, 3> said{};
  for (int axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    said[i] = axes_.named[i] && places_.is_shown(axis);
  }
  extents_.go_on_at(target, said);
}

void PathWriter::suspend_compensation() {
  end_corners();
  compensation_waits_ = compensation_waits_ || compensation_.is_on();
  compensation_.break_off();
  write_ready();
}

void PathWriter::resume_compensation() {
  if (compensation_waits_ && places_.all_shown()) {
    compensation_waits_ = false;
    compensation_.switch_on(compensation_in_frame(), shown_, place_);
    write_ready();
  }
}

Vec3 PathWriter::curve(const ParametricCurve& curve, double from, double to, std::uint32_t column) {
  const bool as_arcs = compensation_.is_off() && corners_.is_idle();
  const MessageCode code = as_arcs ? MessageCode("curve-as-arcs") : MessageCode("curve-as-lines");
  log_.add(Severity::info, code, 0, {place_.line, column, place_.file}, [&] {
    return as_arcs ? DiagnosticLog::Text{NC_("core",
                                             "a curve is approximated by tangent arcs within 0.001 mm of it"),
                                         {}}
                   : DiagnosticLog::Text{NC_("core",
                                             "a curve under cutter compensation or at a rounded corner is "
                                             "approximated by lines within 0.001 mm"),
                                         {}};
  });
  const Vec3 direction = as_arcs ? curve_as_arcs(curve, from, to) : curve_as_lines(curve, from, to);
  end_motion();
  return direction;
}

Vec3 PathWriter::curve_as_arcs(const ParametricCurve& curve, double from, double to) {
  const auto shown = [&](double parameter) -> CurvePlace {
    const CurvePlace place = curve(parameter);
    return {frame_.to_shown(place.point), frame_.turned(place.slope)};
  };
  const bool as_is = frame_.is_identity();
  const CurvePieces fitted = arcs_of_curve(as_is ? curve : ParametricCurve(shown), from, to);
  const double feed = feed_.over(fitted.length, place_);
  for (const CurvePiece& piece : fitted.pieces) {
    const bool is_last = &piece == &fitted.pieces.back();
    append(piece.is_arc ? Motion::arc : Motion::line,
           is_last ? curve(to).point
           : as_is ? piece.end
                   : frame_.to_programmed(piece.end),
           feed, {piece.center, piece.axis, 0}, true);
  }
  const Vec3 direction =
      as_is ? fitted.end_direction : Vec3(frame_.to_programmed(shown_ + fitted.end_direction) - programmed_);
  return direction.isZero() ? direction : Vec3(direction.normalized());
}

Vec3 PathWriter::curve_as_lines(const ParametricCurve& curve, double from, double to) {
  const std::vector<Vec3> ends = lines_of_curve(curve, from, to);
  double length = 0;
  Vec3 before = programmed_;
  Vec3 direction = Vec3::Zero();
  for (const Vec3& end : ends) {
    const Vec3 way = end - before;
    length += way.norm();
    direction = way.norm() > 0 ? Vec3(way.normalized()) : direction;
    before = end;
  }
  const double feed = feed_.over(length, place_);
  for (const Vec3& end : ends) {
    append(Motion::line, end, feed);
  }
  return direction;
}

void PathWriter::use_work_offset(std::string_view name, const std::optional<Vec3>& zero) {
  std::vector<OffsetUse>& all = program_.work_offsets;
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const OffsetUse& use) { return use.name == name; });
  offset_ = static_cast<std::size_t>(found - all.begin());
  if (found == all.end()) {
    all.push_back({std::string(name), line_});
  }
  OffsetUse& use = all[*offset_];
  use.given = use.given || zero;
  use.zero = zero.value_or(Vec3::Zero());
}

void PathWriter::set_zero_in_use(const Vec3& zero) {
  if (offset_) {
    OffsetUse& use = program_.work_offsets[*offset_];
    use.given = true;
    use.zero = zero;
  }
}

void PathWriter::append(Motion motion, const Vec3& target, double feed, const ArcWords& arc, bool on_curve) {
  const Vec3 from = shown_;
  const Vec3 programmed_from = programmed_;
  programmed_ = target;
  shown_ = frame_.is_identity() ? target : frame_.to_shown(target);
  has_moved_ = true;
  if (offset_) {
    ++program_.work_offsets[*offset_].blocks;
  }
  if (!places_.all_shown() && !starts_at_known_place(motion, feed, programmed_from, from)) {
    return;
  }
  MotionBlock block = block_to(shown_, motion);
  block.feed = feed;
  block.on_curve = on_curve;
  if (compensation_.is_off() && corners_.is_idle()) {
    write(block, arc, axes_.named);
  } else {
    pass_on({block, arc, place_, axes_.named}, from);
  }
}

MotionBlock PathWriter::block_to(const Vec3& target, Motion motion) {
  MotionBlock block;
  block.target = target;
  block.line = line_;
  block.motion = motion;
  block.path_control = path_control_index();
  block.spindle = spindle_.index(feed_.spindle_speed(), place_);
  return block;
}

void PathWriter::pass_on(const PathMotion& motion, const Vec3& from) {
  if (corners_.is_idle()) {
    compensate(motion);
  } else {
    corners_.take(motion, from);
    pass_corners_on();
  }
}

void PathWriter::compensate(const PathMotion& motion) {
  if (compensation_.is_off()) {
    write(motion.block, motion.arc, motion.axes);
  } else {
    compensation_.take(motion);
    write_ready();
  }
}

void PathWriter::write(MotionBlock block, const ArcWords& arc, const std::array<bool, 3>& axes) {
  extents_.add(block, arc, axes);
  if (block.motion == Motion::arc) {
    block.arc = static_cast<std::int32_t>(program_.arcs.size());
    program_.arcs.push_back(arc);
  }
  program_.motions.push_back(block);
}

void PathWriter::write_ready() {
  for (const PathMotion& motion : compensation_.ready()) {
    write(motion.block, motion.arc, motion.axes);
  }
  compensation_.ready().clear();
}

std::uint16_t PathWriter::path_control_index() {
  constexpr std::size_t most = std::numeric_limits<std::uint16_t>::max();
  std::vector<PathControl>& all = program_.path_controls;
  if (all[control_index_] != path_control_) {
    const auto found = std::find(all.begin(), all.end(), path_control_);
    if (found != all.end()) {
      control_index_ = static_cast<std::uint16_t>(found - all.begin());
    } else if (all.size() <= most) {
      control_index_ = static_cast<std::uint16_t>(all.size());
      all.push_back(path_control_);
    } else {
      log_.add(Severity::error, "path-controls", 0, place_, [] {
        return DiagnosticLog::Text{
            NC_("core", "the program has more than 65536 different path control settings"),
            NC_("core", "the last one stays in force; split the program")};
      });
    }
  }
  return control_index_;
}

void PathWriter::report_arc_fault(const ArcRequest& request, const ArcSolution& solution) {
  const DiagnosticLog::Place place{place_.line, request.column, place_.file};
  switch (solution.fault) {
    case ArcFault::none:
      break;
    case ArcFault::center_at_start:
      log_.add(Severity::error, "arc-center", 2, place, [] {
        return DiagnosticLog::Text{NC_("core", "the arc's centre is its start point"), straight_instead};
      });
      break;
    case ArcFault::radius_mismatch:
      log_.add(Severity::error, "arc-radius", 0, place, [&] {
        const bool other_fits = !request.other_reading.empty() &&
                                solve_center_arc(programmed_, request.target, request.other_center,
                                                 request.axis, 0, request.tolerance)
                                        .fault == ArcFault::none;
        const Message advice = other_fits
                                   ? message(NC_("core", "the centre would fit as {}"), request.other_reading)
                                   : NC_("core", "check the centre");
        return DiagnosticLog::Text{
            message(NC_("core", "the arc's radius is {:.4f} mm at its start but {:.4f} mm at its end"),
                    solution.start_radius, solution.end_radius),
            message(NC_("core", "{}; {}"), advice, straight_instead)};
      });
      break;
    case ArcFault::radius_too_small:
      log_.add(Severity::error, "arc-radius", 1, place, [&] {
        return DiagnosticLog::Text{
            message(NC_("core", "radius {:.4f} mm is too small for ends {:.4f} mm apart"),
                    solution.start_radius, 2 * solution.end_radius),
            message(NC_("core", "the radius must be at least half the distance; {}"), straight_instead)};
      });
      break;
    case ArcFault::same_ends:
      log_.add(Severity::error, "arc-ends", 0, place, [] {
        return DiagnosticLog::Text{NC_("core", "an arc given by its radius must not end where it starts"),
                                   NC_("core", "write a full circle with its centre")};
      });
      break;
  }
}

}  // namespace feedscope

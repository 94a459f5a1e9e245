#include "core/program/path/cutter_compensation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/program/path/arc_solver.h"

namespace feedscope {

namespace {

/// Gap within which paths join: the rounding of coordinates between tangent elements [mm].
constexpr double join_gap = 1e-3;
/// The same next to an arc as small as the tool, whose end directions have a larger rounding error [mm].
constexpr double join_gap_at_point = 1e-2;
/// Depth of a cut into the contour that the rounding of coordinates explains [mm].
constexpr double allowed_cut = 2e-3;
/// The same over more than two blocks, whose joints may each be off by join_gap_at_point.
constexpr double allowed_cut_further_on = 1e-2;
constexpr double reversal_sine = 1e-9;
/// The same next to an arc, whose end direction has a larger rounding error.
constexpr double reversal_sine_at_arc = 1e-2;

/// Curvature, positive to the left [1/mm].
double bend(const PlaneElement& element) {
  return element.is_arc() ? element.turn / element.radius : 0;
}

/// True if a tool `left` of the contour has less than half a turn to go around between the elements. Where
/// the contour turns back, in a tip or a notch without width, the curvatures decide between the two; two
/// lines make a tip.
bool is_inside_corner(const PlaneElement& last, const PlaneElement& next, double left) {
  const double sine = cross(last.tangent_at_end(), next.tangent_at_start());
  const double cosine = last.tangent_at_end().dot(next.tangent_at_start());
  const double bends = bend(last) + bend(next);
  const bool reverses = cosine < 0 && std::abs(sine) <= (bends != 0 ? reversal_sine_at_arc : reversal_sine);
  return reverses ? bends * left < 0 : sine * left >= 0;
}

/// Turn of the direction from `last` to `next`, in [0, pi] [rad].
double turn_of(const PlaneElement& last, const PlaneElement& next) {
  const Vec2 before = last.tangent_at_end();
  const Vec2 after = next.tangent_at_start();
  return std::atan2(std::abs(cross(before, after)), before.dot(after));
}

bool is_point(const PlaneElement& path) {
  return path.is_arc() && path.radius <= allowed_cut;
}

PathMotion as_line(PathMotion motion) {
  motion.block.motion = motion.block.motion == Motion::arc ? Motion::line : motion.block.motion;
  return motion;
}

bool same_normal(const Compensation& a, const Compensation& b) {
  constexpr double same = 1e-9;
  return (a.plane.normal - b.plane.normal).norm() <= same;
}

}  // namespace

/// True if the block programs an axis in the plane, even if only at its current coordinate.
bool CutterCompensation::names_plane(const PathMotion& motion) const {
  constexpr double across = 0.9;
  bool named = false;
  for (std::size_t i = 0; i < motion.axes.size(); ++i) {
    named = named || (motion.axes[i] && std::abs(compensation_.plane.normal[static_cast<int>(i)]) < across);
  }
  return named;
}

PlaneElement CutterCompensation::path_beside(const PlaneElement& contour) const {
  return beside(contour, left_);
}

void CutterCompensation::switch_on(const Compensation& compensation, const Vec3& tool,
                                   const DiagnosticLog::Place& place) {
  if (is_on()) {
    if (!same_normal(compensation, compensation_)) {
      report_plane(place);
    } else if (compensation.side == compensation_.side && compensation.radius == compensation_.radius) {
      compensation_.rule = compensation.rule;
      return;
    }
  }
  release_square();
  if (is_off()) {
    tool_ = tool;
    contour_ = tool;
  }
  compensation_ = compensation;
  left_ = compensation.side == ToolSide::left ? compensation.radius : -compensation.radius;
  stage_ = Stage::entry;
}

void CutterCompensation::switch_off() {
  release_square();
  if (stage_ != Stage::off) {
    stage_ = stage_ == Stage::entry && tool_ == contour_ ? Stage::off : Stage::exit;
  }
}

void CutterCompensation::finish() {
  release_square();
}

void CutterCompensation::break_off() {
  release_square();
  stage_ = Stage::off;
}

void CutterCompensation::take(const PathMotion& motion) {
  const bool is_arc = motion.block.motion == Motion::arc;
  const Vec2 way = in_plane(motion.block.target) - in_plane(contour_);
  const bool moves_in_plane =
      motion.block.motion != Motion::dwell &&
      (is_arc || way.norm() > same_point || (stage_ == Stage::exit && names_plane(motion)));
  if (moves_in_plane) {
    take_in_plane(motion);
  } else {
    take_across(motion);
  }
  contour_ = motion.block.target;
}

void CutterCompensation::take_across(const PathMotion& motion) {
  if (held_) {
    waiting_.push_back(motion);
  } else {
    write_beside(motion);
  }
}

void CutterCompensation::take_in_plane(const PathMotion& motion) {
  if (stage_ == Stage::exit) {
    leave(motion);
    return;
  }
  const PlaneElement contour = element_of(motion, in_plane(contour_));
  const bool stays = !contour.is_arc() && (contour.end - contour.start).norm() <= same_point;
  if (stays) {
    take_across(as_line(motion));
  } else if (stage_ == Stage::entry) {
    enter(motion, contour);
    stage_ = Stage::contour;
  } else {
    join(motion, contour);
  }
}

PlaneElement CutterCompensation::element_of(const PathMotion& motion, const Vec2& start) {
  const PlaneElement element = compensation_.plane.element_of(motion, start);
  if (!element.is_arc() || path_beside(element).radius >= -allowed_cut) {
    return element;
  }
  report_radius(motion, element.radius);
  return PlaneElement::line(start, element.end);
}

void CutterCompensation::enter(const PathMotion& motion, const PlaneElement& contour) {
  watch_.clear();
  watches_ = false;
  if (!contour.is_arc()) {
    hold(motion, contour, true);
    return;
  }
  log_.add(Severity::error, "compensation-entry", 0, motion.place, [] {
    return DiagnosticLog::Text{
        NC_("core", "cutter radius compensation begins on an arc"),
        NC_("core", "a straight line leads to the start of the offset arc; begin it on a line")};
  });
  write(as_line(motion), in_space(path_beside(contour).start, contour_));
  hold(motion, contour, false);
}

void CutterCompensation::leave(const PathMotion& motion) {
  watches_ = false;
  if (motion.block.motion == Motion::arc) {
    log_.add(Severity::error, "compensation-exit", 0, motion.place, [] {
      return DiagnosticLog::Text{NC_("core", "cutter radius compensation ends on an arc"),
                                 NC_("core", "a straight line leads to its end instead; end it on a line")};
    });
  }
  write(as_line(motion), motion.block.target);
  stage_ = Stage::off;
}

void CutterCompensation::hold(const PathMotion& motion, const PlaneElement& contour, bool is_entry) {
  held_ = Held{motion, contour, is_entry};
  if (gouges_) {
    watch_.clear();
    gouges_ = false;
  }
  if (!is_entry) {
    watch_contour(motion, contour);
  }
}

void CutterCompensation::watch_contour(const PathMotion& motion, const PlaneElement& contour) {
  if (motion.block.motion == Motion::rapid) {
    watch_.clear();
    return;
  }
  const double from = compensation_.plane.normal.dot(contour_);
  const double to = compensation_.plane.normal.dot(motion.block.target);
  for (const ContourWatch::Cut& cut : watch_.add_contour(contour, {std::min(from, to), std::max(from, to)},
                                                         std::abs(left_), allowed_cut_further_on)) {
    const Severity severity = compensation_.rule.looks_ahead ? Severity::error : Severity::warning;
    log_.add(severity, "compensation-gouge", 2, cut.beside, [&] {
      return DiagnosticLog::Text{
          message(NC_("core",
                      "at this block a tool of radius {:.4f} mm cuts {:.4f} mm into the contour of line {}"),
                  std::abs(left_), cut.depth, motion.place.line),
          NC_("core", "use a smaller tool, or do not begin the contour in an inside corner")};
    });
  }
}

void CutterCompensation::watch_path(const PathMotion& motion, const Vec3& to) {
  const Vec2 start = in_plane(tool_);
  PathMotion moved = motion;
  moved.block.target = to;
  const PlaneElement path = compensation_.plane.element_of(moved, start);
  if (motion.block.motion == Motion::rapid || (!path.is_arc() && (path.end - path.start).norm() == 0)) {
    return;
  }
  const double from_level = compensation_.plane.normal.dot(tool_);
  const double to_level = compensation_.plane.normal.dot(to);
  watch_.add_path(path, {std::min(from_level, to_level), std::max(from_level, to_level)}, motion.place);
}

void CutterCompensation::join(const PathMotion& motion, const PlaneElement& next) {
  const PlaneElement& last = held_->contour;
  const Vec2 from = path_beside(last).end;
  const Vec2 to = path_beside(next).start;
  const bool at_point = is_point(path_beside(last)) || is_point(path_beside(next));
  if (held_->is_entry && !compensation_.rule.enters_beside_itself) {
    release(to);
  } else if (is_no_corner(next)) {
    release(from);
  } else if ((to - from).norm() <= (at_point ? join_gap_at_point : join_gap)) {
    release(next.is_arc() && !last.is_arc() ? to : from);
  } else if (is_inside_corner(last, next, left_)) {
    release(inside_corner(last, next));
  } else {
    go_around(next, motion);
  }
  hold(motion, next, false);
}

bool CutterCompensation::is_no_corner(const PlaneElement& next) const {
  return turn_of(held_->contour, next) < compensation_.rule.smallest_corner;
}

Vec2 CutterCompensation::inside_corner(const PlaneElement& last, const PlaneElement& next) {
  const PlaneElement path = path_beside(last);
  const PlaneElement next_path = path_beside(next);
  const Meetings found = meetings(path, next_path);
  const auto cut_off = [&](const Vec2& p) { return (p - path.end).norm() + (p - next_path.start).norm(); };
  if (found.count == 0) {
    report_swallowed();
    return path.end;
  }
  if (found.count == 1) {
    return found.points[0];
  }
  // In a notch without width both are equally far: then the point before the ends.
  constexpr double similar = 0.02;
  const std::array<double, 2> far{cut_off(found.points[0]), cut_off(found.points[1])};
  const bool tie = std::abs(far[1] - far[0]) <= similar * (far[0] + far[1]);
  const Vec2 back = next_path.tangent_at_start() - path.tangent_at_end();
  const bool second = tie ? (found.points[1] - found.points[0]).dot(back) > 0 : far[1] < far[0];
  return found.points[second ? 1 : 0];
}

void CutterCompensation::go_around(const PlaneElement& next, const PathMotion& motion) {
  const bool rapid = motion.block.motion == Motion::rapid;
  if (rapid && compensation_.rule.corner == OutsideCorner::arc_at_feed) {
    release(path_beside(held_->contour).end);
    write(as_line(motion), in_space(path_beside(next).start, tool_));
    return;
  }
  PathMotion linking = as_line(rapid ? held_->motion : motion);
  linking.block.line = motion.block.line;
  if (compensation_.rule.corner == OutsideCorner::lines || linking.block.motion == Motion::rapid) {
    go_around_on_lines(next, linking);
    return;
  }
  if (const std::optional<Vec2> meeting = outside_meeting(next)) {
    release(*meeting);
    return;
  }
  held_->runs_unchecked = next.is_arc() && !compensation_.rule.looks_ahead;
  release(path_beside(held_->contour).end);
  linking.block.motion = Motion::arc;
  linking.arc = {in_space(next.start, tool_), (left_ > 0 ? -1 : 1) * compensation_.plane.normal, 0};
  write(linking, in_space(path_beside(next).start, tool_));
}

/// End point for OutsideCorner::meeting: the nearest meeting point of both paths. None: an arc leads around.
std::optional<Vec2> CutterCompensation::outside_meeting(const PlaneElement& next) const {
  constexpr double rounding = 1e-9;  // [rad]
  if (compensation_.rule.corner != OutsideCorner::meeting ||
      turn_of(held_->contour, next) > largest_meeting_turn + rounding) {
    return std::nullopt;
  }
  const PlaneElement path = path_beside(held_->contour);
  const PlaneElement next_path = path_beside(next);
  const Meetings found = meetings(path, next_path);
  const auto away = [&](const Vec2& p) { return (p - path.end).norm() + (p - next_path.start).norm(); };
  if (found.count == 0) {
    return std::nullopt;
  }
  return found.points[found.count == 2 && away(found.points[1]) < away(found.points[0]) ? 1 : 0];
}

//        up to a quarter turn              above
//
//     from - - - - tip                 from - - - tip
//    contour ----.  |                 contour ---.   .
//                |  |                           /   .
//                |  to                         /   .  then a quarter turn at most to `next`'s path
void CutterCompensation::go_around_on_lines(const PlaneElement& next, const PathMotion& linking) {
  const PlaneElement last = held_->contour;
  const Vec2 from = path_beside(last).end;
  const Vec2 to = path_beside(next).start;
  const Vec2 before = last.tangent_at_end();
  const Vec2 after = next.tangent_at_start();
  const double cosine = before.dot(after);
  const bool sharp = cosine < 0;
  const double further = std::abs(left_) * (sharp ? 1 : std::sqrt(std::max(0.0, 1 - cosine) / (1 + cosine)));
  const Vec2 tip = from + further * before;
  release(last.is_arc() ? from : tip);
  if (last.is_arc()) {
    write(linking, in_space(tip, tool_));
  }
  if (sharp) {
    write(linking, in_space(to - further * after, tool_));
  }
  if (next.is_arc()) {
    write(linking, in_space(to, tool_));
  }
}

void CutterCompensation::release(const Vec2& end) {
  const PathMotion& motion = held_->motion;
  const PlaneElement path = path_beside(held_->contour);
  const bool is_replaced = motion.block.motion == Motion::arc && !held_->contour.is_arc();
  watches_ = !held_->is_entry && !is_replaced;
  if (motion.block.motion == Motion::arc && held_->contour.is_arc()) {
    write_arc(path, end);
  } else {
    const bool reported = motion.block.motion == Motion::arc;
    const bool backward = !held_->is_entry && !reported &&
                          (end - in_plane(tool_)).dot(held_->contour.tangent_at_start()) < -allowed_cut;
    if (backward) {
      report_swallowed();
    }
    write(as_line(motion), in_space(end, motion.block.target));
  }
  held_.reset();
  for (const PathMotion& other : waiting_) {
    write_beside(other);
  }
  waiting_.clear();
}

void CutterCompensation::release_square() {
  if (held_) {
    release(path_beside(held_->contour).end);
  }
}

void CutterCompensation::write_arc(const PlaneElement& path, const Vec2& end) {
  PathMotion motion = held_->motion;
  const Vec3 target = in_space(end, motion.block.target);
  double sweep = is_point(path) ? 0 : sweep_between(path, in_plane(tool_), end);
  const bool turns_on = held_->runs_unchecked && sweep * path.radius < -same_point;
  if (turns_on || sweep * path.radius < -allowed_cut) {
    report_swallowed();
  }
  sweep += turns_on ? 2 * std::numbers::pi : 0;
  if (sweep * path.radius <= same_point) {
    write(as_line(motion), target);
    return;
  }
  const double turns = std::ceil((sweep - same_point / path.radius) / (2 * std::numbers::pi)) - 1;
  ArcTolerance tolerance;  // the tool may be off the arc by the size of a corner that does not count as one
  tolerance.least = std::max(tolerance.least, compensation_.rule.smallest_corner * std::abs(left_));
  const ArcSolution solution = solve_center_arc(tool_, target, in_space(path.center, target), motion.arc.axis,
                                                std::max(0.0, turns), tolerance);
  if (solution.fault != ArcFault::none) {
    write(as_line(motion), target);
  }
  for (int i = 0; i < solution.count; ++i) {
    const ArcSolution::Piece& piece = solution.pieces[static_cast<std::size_t>(i)];
    motion.arc = piece.words;
    write(motion, piece.target);
  }
}

void CutterCompensation::write(const PathMotion& motion, const Vec3& to) {
  if (watches_) {
    watch_path(motion, to);
  }
  ready_.push_back(motion);
  ready_.back().block.target = to;
  tool_ = to;
}

void CutterCompensation::write_beside(const PathMotion& motion) {
  write(motion, in_space(in_plane(tool_), motion.block.target));
}

void CutterCompensation::report_plane(const DiagnosticLog::Place& place) {
  log_.add(Severity::error, "compensation-plane", 0, place, [] {
    return DiagnosticLog::Text{NC_("core", "the plane changes while cutter radius compensation is on"),
                               NC_("core", "it begins again in the other plane; end it before")};
  });
}

void CutterCompensation::report_radius(const PathMotion& motion, double radius) {
  gouges_ = true;
  log_.add(Severity::error, "compensation-gouge", 0, motion.place, [&] {
    return DiagnosticLog::Text{
        message(NC_("core", "the arc's radius, {:.4f} mm, is smaller than the tool's, {:.4f} mm"), radius,
                std::abs(left_)),
        NC_("core",
            "a straight line to its end is used instead, which cuts into the contour; use a smaller tool")};
  });
}

void CutterCompensation::report_swallowed() {
  gouges_ = true;
  const bool runs = held_->runs_unchecked;
  log_.add(runs ? Severity::warning : Severity::error, "compensation-gouge", 1, held_->motion.place, [&] {
    return DiagnosticLog::Text{
        message(NC_("core", "a tool of radius {:.4f} mm does not fit between this block and its neighbours"),
                std::abs(left_)),
        runs ? NC_("core",
                   "the control does not check this before an arc: it runs a line backwards, an arc nearly a "
                   "whole turn, and cuts into the contour; use a smaller tool")
             : NC_("core", "the path shown cuts into the contour here; use a smaller tool")};
  });
}

}  // namespace feedscope

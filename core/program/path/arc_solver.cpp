#include "core/program/path/arc_solver.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace feedscope {

namespace {

constexpr double half_turn = std::numbers::pi;

Vec3 in_plane(const Vec3& v, const Vec3& axis) {
  return v - axis.dot(v) * axis;
}

/// Angle from `from` to `to` about `axis`, in (0, 2 pi]; the same direction is a full turn.
double sweep_between(const Vec3& from, const Vec3& to, const Vec3& axis) {
  const double across = axis.dot(from.cross(to));
  const double angle = std::atan2(across, from.dot(to));
  const bool same_direction = from.dot(to) > 0 && std::abs(across) <= same_point * from.norm();
  return angle < 0 || same_direction ? 2 * half_turn + std::min(angle, 0.0) : angle;
}

ArcSolution one_arc(const Vec3& end, const Vec3& center, const Vec3& axis, double turns) {
  ArcSolution solution;
  solution.count = 1;
  solution.pieces[0] = {end, {center, axis, turns}};
  return solution;
}

/// Splits an arc of sweep `sweep` half way. The second half is the circle that touches the first half at its
/// end and passes through the programmed end.
ArcSolution two_arcs(const Vec3& start, const Vec3& end, const Vec3& center, const Vec3& axis, double sweep,
                     double extra_turns) {
  const Vec3 from = in_plane(start - center, axis);
  const Vec3 middle = std::cos(sweep / 2) * from + std::sin(sweep / 2) * axis.cross(from);
  const Vec3 inward = -middle.normalized();
  const Vec3 to_end = in_plane(end - center, axis) - middle;
  const double radius = to_end.squaredNorm() / (2 * inward.dot(to_end));
  const double rise = axis.dot(end - start);
  const double first_share =
      (sweep / 2 + 2 * half_turn * extra_turns) / (sweep + 2 * half_turn * extra_turns);
  const Vec3 split = center + middle + first_share * rise * axis;
  ArcSolution solution;
  solution.count = 2;
  solution.pieces[0] = {split, {center, axis, extra_turns}};
  solution.pieces[1] = {end, {split + radius * inward, axis, 0}};
  return solution;
}

}  // namespace

ArcSolution solve_center_arc(const Vec3& start, const Vec3& end, const Vec3& center, const Vec3& axis,
                             double extra_turns, const ArcTolerance& tolerance) {
  const Vec3 from = in_plane(start - center, axis);
  const Vec3 to = in_plane(end - center, axis);
  const Vec3 chord = to - from;
  const Vec3 level_center = start - from;
  const double start_radius = from.norm();
  const double end_radius = to.norm();
  ArcSolution solution;
  if (start_radius <= same_point) {
    solution.fault = ArcFault::center_at_start;
  } else if (std::abs(start_radius - end_radius) > tolerance.of(std::max(start_radius, end_radius))) {
    solution.fault = ArcFault::radius_mismatch;
  } else if (chord.norm() <= same_point) {
    solution = one_arc(end, level_center, axis, 1 + extra_turns);
  } else {
    const Vec3 along = chord.normalized();
    const Vec3 shift = along.dot(from + to) / 2 * along;
    const double sweep = sweep_between(from, to, axis);
    solution = sweep > half_turn && shift.norm() > tolerance.of(start_radius)
                   ? two_arcs(start, end, level_center, axis, sweep, extra_turns)
                   : one_arc(end, level_center + shift, axis, extra_turns);
    if (solution.count == 1) {
      solution.pieces[0].words.misfit = -shift;
    }
  }
  solution.start_radius = start_radius;
  solution.end_radius = end_radius;
  return solution;
}

ArcSolution solve_radius_arc(const Vec3& start, const Vec3& end, double radius, const Vec3& axis,
                             double extra_turns) {
  const Vec3 chord = in_plane(end - start, axis);
  const double half_chord = chord.norm() / 2;
  const double size = std::abs(radius);
  ArcSolution solution;
  if (2 * half_chord <= same_point) {
    solution.fault = ArcFault::same_ends;
  } else if (half_chord - size > ArcTolerance().of(size)) {
    solution.fault = ArcFault::radius_too_small;
  } else {
    const double height = std::sqrt(std::max(0.0, (size - half_chord) * (size + half_chord)));
    const Vec3 left = axis.cross(chord) / (2 * half_chord);
    const Vec3 center = start + chord / 2 + std::copysign(height, radius) * left;
    solution = one_arc(end, center, axis, extra_turns);
  }
  solution.start_radius = size;
  solution.end_radius = half_chord;
  return solution;
}

}  // namespace feedscope

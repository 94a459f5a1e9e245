#include "core/program/path/corner_rounding.h"

#include <limits>
#include <numbers>

#include "core/program/path/plane_points.h"

namespace feedscope {

namespace {

/// Turn of the tangent below which a corner is smooth [rad].
constexpr double smooth_turn = 1e-9;

Vec2 touch_point(const PlaneElement& element, const Vec2& center) {
  if (element.is_arc()) {
    return element.center + element.radius * (center - element.center).normalized();
  }
  const Vec2 along = element.tangent_at_start();
  return element.start + along.dot(center - element.start) * along;
}

bool lies_on(const PlaneElement& element, const Vec2& point) {
  if (!element.is_arc()) {
    const double at = element.tangent_at_start().dot(point - element.start);
    return at >= -same_point && at <= (element.end - element.start).norm() + same_point;
  }
  constexpr double turn = 2 * std::numbers::pi;
  const double slack = same_point / element.radius;
  const double at = PlaneElement::arc(element.start, point, element.center, element.turn, 0).sweep;
  return at <= element.sweep + slack || at >= turn - slack;
}

CornerFault fault_of_turn(const Vec2& before, const Vec2& after) {
  if (before == Vec2::Zero() || after == Vec2::Zero()) {
    return CornerFault::reversal;
  }
  if (std::abs(cross(before, after)) > smooth_turn) {
    return CornerFault::none;
  }
  return before.dot(after) > 0 ? CornerFault::smooth : CornerFault::reversal;
}

}  // namespace

PlaneCorner round_corner(const PlaneElement& first, const PlaneElement& second, double radius) {
  const Vec2 before = first.tangent_at_end();
  const Vec2 after = second.tangent_at_start();
  PlaneCorner piece;
  piece.fault = fault_of_turn(before, after);
  if (piece.fault != CornerFault::none) {
    return piece;
  }
  piece.turn = cross(before, after) > 0 ? 1 : -1;
  piece.fault = CornerFault::too_large;
  const PlaneElement beside_first = beside(first, piece.turn * radius);
  const PlaneElement beside_second = beside(second, piece.turn * radius);
  if (beside_first.radius < 0 || beside_second.radius < 0) {
    return piece;
  }
  const Meetings found = meetings(beside_first, beside_second);
  double nearest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < found.count; ++i) {
    const Vec2& center = found.points[static_cast<std::size_t>(i)];
    const Vec2 from = touch_point(first, center);
    const Vec2 to = touch_point(second, center);
    const double distance = (center - first.end).norm();
    if (distance < nearest && lies_on(first, from) && lies_on(second, to)) {
      nearest = distance;
      const bool vanishes = (to - from).norm() <= same_point;  // otherwise it would be read as a full circle
      piece = {vanishes ? CornerFault::smooth : CornerFault::none, from, to, center, piece.turn};
    }
  }
  return piece;
}

PlaneCorner chamfer_corner(const PlaneElement& first, const PlaneElement& second, double side) {
  const Vec2 before = first.tangent_at_end();
  const Vec2 after = second.tangent_at_start();
  PlaneCorner piece;
  piece.fault = fault_of_turn(before, after);
  if (first.is_arc() || second.is_arc()) {
    piece.fault = CornerFault::not_lines;
  }
  if (piece.fault != CornerFault::none) {
    return piece;
  }
  piece.from = first.end - side * before;
  piece.to = first.end + side * after;
  if (!lies_on(first, piece.from) || !lies_on(second, piece.to)) {
    piece.fault = CornerFault::too_large;
  }
  return piece;
}

}  // namespace feedscope

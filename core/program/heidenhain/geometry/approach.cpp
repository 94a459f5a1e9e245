#include "core/program/heidenhain/geometry/approach.h"

#include "core/program/path/plane_points.h"

namespace feedscope::heidenhain {

namespace {

/// Point where a line from `outside` touches the circle and continues in the sense of `turn`.
std::optional<Vec2> touching_point(const Vec2& outside, const Vec2& center, double radius, int turn) {
  const Vec2 from_center = outside - center;
  const double distance = from_center.norm();
  if (distance < radius) {
    return std::nullopt;
  }
  return center + radius / distance * turned(from_center, turn * std::acos(radius / distance));
}

}  // namespace

std::optional<ApproachPath> approach_path(const ApproachShape& shape, const Vec2& from, const Vec2& contour,
                                          const Vec2& direction) {
  ApproachPath path;
  const Vec2 to_tool = shape.side * left_of(direction);
  switch (shape.kind) {
    case ApproachKind::tangent_line:
      path.point = contour - shape.length * direction;
      return path;
    case ApproachKind::normal_line:
      path.point = contour + shape.length * to_tool;
      return path;
    case ApproachKind::arc:
    case ApproachKind::line_and_arc:
      break;
  }
  path.turn = shape.radius < 0 ? -shape.side : shape.side;
  const double radius = shape.radius + shape.tool_radius;
  path.center = contour + radius * to_tool;
  if (shape.kind == ApproachKind::arc) {
    path.point = path.center + turned(contour - path.center, -path.turn * shape.angle);
    return path;
  }
  const std::optional<Vec2> touching = touching_point(from, path.center, std::abs(shape.radius), path.turn);
  if (!touching) {
    return std::nullopt;
  }
  path.point = path.center + std::abs(radius / shape.radius) * (*touching - path.center);
  return path;
}

std::optional<ApproachPath> departure_path(const ApproachShape& shape, const Vec2& contour,
                                           const Vec2& direction, const Vec2& to) {
  // A departure is the approach run backwards, seen from the other side.
  ApproachShape backwards = shape;
  backwards.side = -shape.side;
  std::optional<ApproachPath> path = approach_path(backwards, to, contour, -direction);
  if (path) {
    path->turn = -path->turn;
  }
  return path;
}

}  // namespace feedscope::heidenhain

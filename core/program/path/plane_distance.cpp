#include "core/program/path/plane_distance.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/geometry.h"

namespace feedscope {

namespace {

/// True if a point of the arc's circle lies on the arc, its ends included.
bool on_arc(const PlaneElement& arc, const Vec2& point) {
  constexpr double rounding = 1e-9;
  const Vec2 from = arc.start - arc.center;
  const Vec2 to = point - arc.center;
  double angle = arc.turn * std::atan2(cross(from, to), from.dot(to));
  angle += angle < -rounding ? 2 * std::numbers::pi : 0;
  return angle <= arc.sweep + rounding;
}

bool holds(const PlaneElement& element, const Vec2& point) {
  if (element.is_arc()) {
    return on_arc(element, point);
  }
  const Vec2 along = element.end - element.start;
  const double share = (point - element.start).dot(along);
  return share >= 0 && share <= along.squaredNorm();
}

bool meet(const PlaneElement& a, const PlaneElement& b) {
  const Meetings found = meetings(a, b);
  return std::any_of(found.points.begin(), found.points.begin() + found.count,
                     [&](const Vec2& point) { return holds(a, point) && holds(b, point); });
}

/// Least distance from the points of the arc `a` on the line from its centre to the nearest or farthest point
/// of the endless line or circle of `b`.
double distance_square_to(const PlaneElement& a, const PlaneElement& b) {
  double nearest = std::numeric_limits<double>::infinity();
  Vec2 target = b.center;
  if (!b.is_arc()) {
    const Vec2 along = b.tangent_at_start();
    target = b.start + (a.center - b.start).dot(along) * along;
  }
  const Vec2 way = target - a.center;
  if (!a.is_arc() || way.norm() <= same_point) {
    return nearest;
  }
  for (const double side : {a.radius, -a.radius}) {
    const Vec2 point = a.center + side * way.normalized();
    if (on_arc(a, point)) {
      nearest = std::min(nearest, distance(point, b));
    }
  }
  return nearest;
}

}  // namespace

void PlaneBox::add(const Vec2& point) {
  min = min.cwiseMin(point);
  max = max.cwiseMax(point);
}

void PlaneBox::add(const PlaneBox& box) {
  min = min.cwiseMin(box.min);
  max = max.cwiseMax(box.max);
}

PlaneBox box_of(const PlaneElement& element) {
  PlaneBox box;
  box.add(element.start);
  box.add(element.end);
  if (element.is_arc()) {
    for (const Vec2& axis : {Vec2(1, 0), Vec2(0, 1), Vec2(-1, 0), Vec2(0, -1)}) {
      const Vec2 point = element.center + element.radius * axis;
      if (on_arc(element, point)) {
        box.add(point);
      }
    }
  }
  return box;
}

double distance(const Vec2& point, const PlaneElement& element) {
  if (element.is_arc()) {
    const double to_ends = std::min((point - element.start).norm(), (point - element.end).norm());
    return on_arc(element, point) ? std::abs((point - element.center).norm() - element.radius) : to_ends;
  }
  const Vec2 along = element.end - element.start;
  const double length = along.squaredNorm();
  const double share = length > 0 ? std::clamp((point - element.start).dot(along) / length, 0.0, 1.0) : 0;
  return (point - element.start - share * along).norm();
}

double distance(const PlaneElement& a, const PlaneElement& b) {
  if (meet(a, b)) {
    return 0;
  }
  return std::min({distance(a.start, b), distance(a.end, b), distance(b.start, a), distance(b.end, a),
                   distance_square_to(a, b), distance_square_to(b, a)});
}

}  // namespace feedscope

#include "core/program/path/plane_element.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/geometry.h"

namespace feedscope {

namespace {

/// Angle from `a` to `b`, counter-clockwise, in (-pi, pi].
double angle_between(const Vec2& a, const Vec2& b) {
  return std::atan2(cross(a, b), a.dot(b));
}

void add(Meetings& meetings, const Vec2& point) {
  meetings.points[static_cast<std::size_t>(meetings.count++)] = point;
}

/// Points of a circle on the line through `foot` along unit `along` that lie `far` from `foot`, which is at
/// `height` from the centre of the circle of `radius`; a circle missed by no more than rounding is touched.
Meetings on_circle(const Vec2& foot, const Vec2& along, double height, double radius) {
  constexpr double rounding = 1e-9;
  Meetings found;
  if (height > radius + rounding) {
    return found;
  }
  const double far = std::sqrt(std::max(0.0, (radius - height) * (radius + height)));
  add(found, foot + far * along);
  if (far > 0) {
    add(found, foot - far * along);
  }
  return found;
}

Meetings line_and_line(const PlaneElement& a, const PlaneElement& b) {
  constexpr double parallel = 1e-12;
  const Vec2 along = a.tangent_at_start();
  const Vec2 other = b.tangent_at_start();
  const double sine = cross(along, other);
  Meetings found;
  if (std::abs(sine) > parallel) {
    add(found, a.start + cross(b.start - a.start, other) / sine * along);
  }
  return found;
}

Meetings line_and_circle(const PlaneElement& line, const PlaneElement& circle) {
  const Vec2 along = line.tangent_at_start();
  const Vec2 foot = line.start + along.dot(circle.center - line.start) * along;
  return on_circle(foot, along, (foot - circle.center).norm(), std::abs(circle.radius));
}

Meetings circle_and_circle(const PlaneElement& a, const PlaneElement& b) {
  const Vec2 between = b.center - a.center;
  const double distance = between.norm();
  if (distance <= same_point) {
    return {};
  }
  const Vec2 along = between / distance;
  const double height =
      (distance * distance + (a.radius - b.radius) * (a.radius + b.radius)) / (2 * distance);
  return on_circle(a.center + height * along, left_of(along), std::abs(height), std::abs(a.radius));
}

}  // namespace

PlaneElement PlaneElement::line(const Vec2& start, const Vec2& end) {
  PlaneElement element;
  element.start = start;
  element.end = end;
  return element;
}

PlaneElement PlaneElement::arc(const Vec2& start, const Vec2& end, const Vec2& center, int turn,
                               double turns) {
  PlaneElement element = line(start, end);
  element.turn = turn;
  element.center = center;
  element.radius = (start - center).norm();
  if ((end - start).norm() > same_point) {
    const double part = turn * angle_between(start - center, end - center);
    element.sweep = part < 0 ? part + 2 * std::numbers::pi : part;
  }
  element.sweep += 2 * std::numbers::pi * turns;
  return element;
}

Vec2 PlaneElement::tangent_at_start() const {
  return is_arc() ? Vec2(turn * left_of(start - center).normalized()) : Vec2((end - start).normalized());
}

Vec2 PlaneElement::tangent_at_end() const {
  return is_arc() ? Vec2(turn * left_of(end - center).normalized()) : Vec2((end - start).normalized());
}

PlaneElement beside(const PlaneElement& element, double left) {
  PlaneElement shifted = element;
  shifted.start += left * left_of(element.tangent_at_start());
  shifted.end += left * left_of(element.tangent_at_end());
  shifted.radius -= left * element.turn;
  return shifted;
}

Meetings meetings(const PlaneElement& a, const PlaneElement& b) {
  if (a.is_arc() && b.is_arc()) {
    return circle_and_circle(a, b);
  }
  if (a.is_arc()) {
    return line_and_circle(b, a);
  }
  return b.is_arc() ? line_and_circle(a, b) : line_and_line(a, b);
}

double sweep_between(const PlaneElement& arc, const Vec2& from, const Vec2& to) {
  const double later = arc.turn * angle_between(arc.start - arc.center, from - arc.center);
  const double beyond = arc.turn * angle_between(arc.end - arc.center, to - arc.center);
  return arc.sweep - later + beyond;
}

}  // namespace feedscope

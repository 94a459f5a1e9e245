#include "tests/support/brute_force.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace feedscope::testing {
namespace {

double distance_from_line(const Vec3& from, const Vec3& to, const Vec3& place) {
  const double length = (to - from).norm();
  if (length == 0) {
    return (place - from).norm();
  }
  const Vec3 along = (to - from) / length;
  const double s = along.dot(place - from);
  return s <= 0        ? (place - from).norm()
         : s >= length ? (place - to).norm()
                       : along.cross(place - from).norm();
}

double distance_from_flat_arc(const Arc& arc, const Vec3& place) {
  const Vec3 out = place - arc.center;
  const Vec3 axis = arc.x.cross(arc.y);
  const double height = out.dot(axis);
  const double radius = (out - height * axis).norm();
  double angle = std::atan2(out.dot(arc.y), out.dot(arc.x));
  angle += angle < 0 ? 2 * std::numbers::pi : 0;
  if (angle <= arc.sweep || radius == 0) {
    return std::hypot(radius - arc.radius, height);
  }
  return std::min((place - arc.at(0).position).norm(), (place - arc.at(arc.length()).position).norm());
}

double distance_from_helix(const Arc& arc, const Vec3& place) {
  const auto distance = [&](double s) { return (place - arc.at(s).position).norm(); };
  const int steps = static_cast<int>(std::ceil(arc.sweep / 0.05)) + 8;
  const double step = arc.length() / steps;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double least = infinity;
  double before = infinity;
  double here = distance(0);
  for (int i = 0; i <= steps; ++i) {
    const double behind = i < steps ? distance((i + 1) * step) : infinity;
    const bool ends = i == 0 || i == steps;
    if (ends || (before >= here && behind >= here)) {  // a valley
      double low = std::max(0, i - 1) * step;
      double high = std::min(steps, i + 1) * step;
      for (int k = 0; k < 60; ++k) {
        const double first = low + (high - low) / 3;
        const double second = high - (high - low) / 3;
        if (distance(first) < distance(second)) {
          high = second;
        } else {
          low = first;
        }
      }
      least = std::min({least, here, distance((low + high) / 2)});
    }
    before = here;
    here = behind;
  }
  return least;
}

}  // namespace

double brute_force_distance(const Toolpath& path, std::size_t segment, const Vec3& place) {
  const Segment& block = path.segments[segment];
  if (block.kind != SegmentKind::arc) {
    return distance_from_line(path.start_of(segment), block.end, place);
  }
  const Arc& arc = path.arc_of(block);
  return arc.rise.norm() > 0 ? distance_from_helix(arc, place) : distance_from_flat_arc(arc, place);
}

double brute_force_distance(const Toolpath& path, const Vec3& place) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < path.segments.size(); ++i) {
    least = std::min(least, brute_force_distance(path, i, place));
  }
  return least;
}

}  // namespace feedscope::testing

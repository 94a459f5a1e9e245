#pragma once

#include <cmath>

#include "core/base/geometry.h"
#include "core/program/path/plane.h"
#include "core/program/path/plane_element.h"

namespace feedscope {

/// Turned by `angle` [rad], counter-clockwise.
inline Vec2 turned(const Vec2& v, double angle) {
  return std::cos(angle) * v + std::sin(angle) * left_of(v);
}

inline Vec2 in_plane(const Vec3& v, Plane plane) {
  return {v[first_axis(plane)], v[second_axis(plane)]};
}
/// `base` with its coordinates in the plane replaced.
inline Vec3 from_plane(const Vec2& v, Plane plane, Vec3 base) {
  base[first_axis(plane)] = v.x();
  base[second_axis(plane)] = v.y();
  return base;
}

}  // namespace feedscope

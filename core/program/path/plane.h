#pragma once

#include <cstdint>

#include "core/base/geometry.h"

namespace feedscope {

/// Plane of arcs, cycles and cutter compensation, by its normal.
enum class Plane : std::uint8_t { xy = 2, zx = 1, yz = 0 };

inline int normal_axis(Plane plane) {
  return static_cast<int>(plane);
}
inline Vec3 normal_of(Plane plane) {
  return Vec3::Unit(normal_axis(plane));
}
/// First and second axis of the plane, right-handed with the normal: XY, ZX, YZ.
inline int first_axis(Plane plane) {
  return (normal_axis(plane) + 1) % 3;
}
inline int second_axis(Plane plane) {
  return (normal_axis(plane) + 2) % 3;
}

}  // namespace feedscope

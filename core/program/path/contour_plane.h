#pragma once

#include "core/base/geometry.h"
#include "core/program/path/path_motion.h"
#include "core/program/path/plane_element.h"

namespace feedscope {

/// A plane of contours with its own coordinates, anywhere in the shown coordinates.
struct ContourPlane {
  Vec3 normal = Vec3::UnitZ();      ///< unit
  Vec3 first_axis = Vec3::UnitX();  ///< unit, in the plane

  Vec2 in_plane(const Vec3& point) const;
  /// The point at the height of `height_of` along the normal.
  Vec3 in_space(const Vec2& point, const Vec3& height_of) const;
  /// The motion from `start`; an arc must turn about the normal.
  PlaneElement element_of(const PathMotion& motion, const Vec2& start) const;
};

}  // namespace feedscope

#include "core/program/path/contour_plane.h"

namespace feedscope {

Vec2 ContourPlane::in_plane(const Vec3& point) const {
  return {first_axis.dot(point), normal.cross(first_axis).dot(point)};
}

Vec3 ContourPlane::in_space(const Vec2& point, const Vec3& height_of) const {
  return point.x() * first_axis + point.y() * normal.cross(first_axis) + normal.dot(height_of) * normal;
}

PlaneElement ContourPlane::element_of(const PathMotion& motion, const Vec2& start) const {
  const Vec2 end = in_plane(motion.block.target);
  if (motion.block.motion != Motion::arc) {
    return PlaneElement::line(start, end);
  }
  const int turn = normal.dot(motion.arc.axis) > 0 ? 1 : -1;
  return PlaneElement::arc(start, end, in_plane(motion.arc.center), turn, motion.arc.turns);
}

}  // namespace feedscope

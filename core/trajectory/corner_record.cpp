#include "core/trajectory/corner_record.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace feedscope {
namespace {

/// Distance of `point` from an arc or a line [mm].
double distance_from(const ElementCurve& curve, const Vec3& point) {
  if (curve.is_arc()) {
    return std::abs((point - curve.arc.center).norm() - curve.arc.radius);
  }
  const double along = std::clamp((point - curve.start).dot(curve.direction), 0.0, curve.length);
  return (point - curve.at(along).position).norm();
}

}  // namespace

BlendRecord laid_corner(const BlendedPath& path, std::size_t i) {
  const std::uint32_t element = path.corner_element(i);
  const Corner corner = path.corner(i);
  BlendRecord record;
  record.line = path.source_segment(element).line;
  record.element = element;
  record.corner = path.corner_point(i);
  record.turn = corner.turn;
  record.transition = corner.transition;
  record.epsilon = corner.epsilon;
  record.length = path.length(element);
  record.min_radius = path.min_radius(i);
  return record;
}

BlendRecord rounded_corner(const BlendedPath& path, const RoundedCorner& corner) {
  BlendRecord record;
  record.line = path.programmed()->segments[corner.block].line;
  record.element = corner.first;
  record.corner = corner.point;
  record.turn = corner.turn;
  record.transition = std::max((path.curve(corner.first).start - corner.point).norm(),
                               (path.curve(corner.last).end - corner.point).norm());
  record.length = path.s(corner.last + std::size_t{1}) - path.s(corner.first);
  record.epsilon = std::numeric_limits<double>::infinity();
  record.min_radius = std::numeric_limits<double>::infinity();
  for (std::uint32_t i = corner.first; i <= corner.last; ++i) {
    const ElementCurve curve = path.curve(i);
    record.epsilon = std::min(record.epsilon, distance_from(curve, corner.point));
    record.min_radius = curve.is_arc() ? std::min(record.min_radius, curve.arc.radius)
                                       : std::numeric_limits<double>::quiet_NaN();
  }
  return record;
}

}  // namespace feedscope

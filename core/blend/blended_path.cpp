#include "core/blend/blended_path.h"

namespace feedscope {
namespace {

/// From derivatives by the curve's own parameter to derivatives by path length.
CurvePoint by_path_length(const CurvePoint& p) {
  const double sigma = p.d1.norm();
  const double dsigma = p.d1.dot(p.d2) / sigma;
  const double ddsigma = (p.d2.squaredNorm() + p.d1.dot(p.d3) - dsigma * dsigma) / sigma;
  const double u1 = 1 / sigma;
  const double u2 = -dsigma * u1 * u1 * u1;
  const double u3 = (-ddsigma + 3 * dsigma * dsigma * u1) * u1 * u1 * u1 * u1;
  return {p.position, p.d1 * u1, p.d2 * (u1 * u1) + p.d1 * u2,
          p.d3 * (u1 * u1 * u1) + p.d2 * (3 * u1 * u2) + p.d1 * u3};
}

}  // namespace

CurvePoint BlendedPath::at(const PathElement& element, double s) const {
  switch (element.kind) {
    case ElementKind::line: {
      const Vec3 direction = (element.end - element.start) / element.length;
      return {element.start + direction * s, direction, Vec3::Zero(), Vec3::Zero()};
    }
    case ElementKind::arc:
      return arcs[element.geometry].at(element.arc_offset + s);
    case ElementKind::blend: {
      const CubicBlend& blend = blends[element.geometry];
      return by_path_length(blend.at(blend.parameter_at(s)));
    }
    case ElementKind::filtered: {
      const Vec3 chord = (element.end - element.start) / element.length;
      return {element.start + chord * s, chord, Vec3::Zero(), Vec3::Zero()};
    }
    case ElementKind::dwell:
      break;
  }
  return {element.start, Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
}

}  // namespace feedscope

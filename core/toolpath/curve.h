#pragma once

#include "core/base/geometry.h"

namespace feedscope {

/// Position on a curve and its derivatives by the curve's own parameter.
struct CurvePoint {
  Vec3 position;  ///< [mm]
  Vec3 d1;
  Vec3 d2;
  Vec3 d3;
};

/// The same point with derivatives by path length.
CurvePoint by_path_length(const CurvePoint& p);

/// Circular arc or helix, parameterised by path length.
///   position(s) = center + radius (cos(a) x + sin(a) y) + a rise,  a = s / (length / sweep)
struct Arc {
  Vec3 center;        ///< [mm]
  Vec3 x;             ///< unit vector from the centre to the start
  Vec3 y;             ///< unit vector, start direction of the motion in the plane
  Vec3 rise;          ///< advance along the axis per radian [mm/rad]; zero for a flat arc
  double radius = 0;  ///< [mm]
  double sweep = 0;   ///< > 0 [rad]

  double length() const { return sweep * length_per_radian(); }
  double length_per_radian() const;
  CurvePoint at(double s) const;  ///< 0 <= s <= length()
  /// Curvature of the helix, radius / (radius^2 + |rise|^2) [1/mm].
  double curvature() const;
};

/// Cubic Hermite blend of Essid 2019, eq 4-12, from `start` to `end` around `corner`: end derivatives alpha
/// (corner - start) and alpha (end - corner), parameter u in [0, 1].
struct CubicBlend {
  Vec3 start;   ///< Q- [mm]
  Vec3 corner;  ///< P [mm]
  Vec3 end;     ///< Q+ [mm]
  double alpha = 2.5;

  CurvePoint at(double u) const;  ///< 0 <= u <= 1
  double length() const;          ///< by Gauss-Legendre quadrature, relative error < 1e-10
  double length_to(double u) const;
  double parameter_at(double s) const;  ///< inverse of length_to
};

}  // namespace feedscope

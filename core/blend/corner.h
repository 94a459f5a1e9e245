#pragma once

#include "core/base/geometry.h"
#include "core/blend/junction.h"
#include "core/toolpath/curve.h"

namespace feedscope {

/// Parameters of a cubic Hermite blend in a corner of two lines (Essid 2019, eq 4-13;
/// models/essid/README.md).
struct CornerRule {
  double tolerance = 0.1;  ///< rho, programmed contour tolerance [mm]
  double alpha = 2.5;      ///< weight of the end derivatives, in (0, 4)
  double beta = 0;  ///< share of the tolerance used; 0: 0.6 if an axis reverses in the corner, else 0.8
};

/// A blend in a corner.
struct Corner {
  double turn = 0;        ///< phi [rad]
  double transition = 0;  ///< T [mm]
  double epsilon = 0;     ///< distance of the corner from the blend [mm]
};

/// eps before any reduction for short blocks: beta rho [mm]. An axis that moves by at most straight_angle of
/// the path before or after the corner does not count as reversing: that is rounding of the coordinates.
double used_tolerance(const Vec3& in, const Vec3& out, const CornerRule& rule);

/// T = min(4 eps / ((4 - alpha) sin(phi/2)), longest), eps = beta rho, recomputed if `longest` limits T.
/// `in`, `out`: unit directions, turning by more than straight_angle and less than a reversal. Eq 13 of the
/// paper is equivalent, with the sign of W in eq 10 reversed, but 0/0 where U_x = V_x.
Corner lay_corner(const Vec3& in, const Vec3& out, double longest, const CornerRule& rule);

/// Radius above which an arc in a corner no longer limits any machine, and its points lose digits [mm].
inline constexpr double largest_arc_radius = 1e6;

/// Circular arc with the same eps, tangent to both lines: T = min(eps / tan(phi/4), longest), with a radius
/// of at most largest_arc_radius.
Corner lay_arc_corner(const Vec3& in, const Vec3& out, double longest, const CornerRule& rule);
/// Arc of radius T / tan(phi/2).
Arc corner_arc(const Vec3& corner, const Vec3& in, const Vec3& out, double transition);

/// Distance of the corner from a cubic blend of transition T: T (4 - alpha) sin(phi/2) / 4 [mm].
double blend_epsilon(const Vec3& in, const Vec3& out, double transition, double alpha);

CubicBlend corner_blend(const Vec3& corner, const Vec3& in, const Vec3& out, double transition, double alpha);

/// A blend by its own parameter u in [0, 1]: metric, curvature, tangent and normal (Essid 2019, eq 20-23,
/// with the prime and the square missing in the printed eq 23). Primes are derivatives by u.
class BlendShape {
 public:
  struct Point {
    double sigma = 0;    ///< |S'| [mm]
    double dsigma = 0;   ///< sigma' [mm]
    double ddsigma = 0;  ///< sigma'' [mm]
    double k = 0;        ///< curvature [1/mm]
    double dk_ds = 0;    ///< its derivative by path length [1/mm2]
    Vec3 tangent;
    Vec3 normal;
  };

  /// Metric and curvature only, which determine the speed regardless of the axes.
  struct Bend {
    double sigma = 0;  ///< |S'| [mm]
    double k = 0;      ///< curvature [1/mm]
  };

  /// `in`, `out`: unit directions that differ.
  BlendShape(const Vec3& in, const Vec3& out, double transition, double alpha);
  Point at(double u) const;
  Bend bend_at(double u) const;
  /// Largest component of the unit tangent on the blend, per axis.
  Vec3 largest_tangent() const;
  /// Curvature at u = 1/2: alpha (4 - alpha) tan^2(phi/2) / (8 eps (3/2 - alpha/4)^2).
  double middle_curvature() const { return at(0.5).k; }

 private:
  Vec3 first_;   ///< unit, along the incoming direction
  Vec3 second_;  ///< unit, across it towards the outgoing direction
  double cos_;
  double sin_;
  double transition_;
  double alpha_;
};

/// Smallest radius of the blend, from 33 places [mm].
double min_radius(const BlendShape& shape);

}  // namespace feedscope

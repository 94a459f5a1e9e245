#pragma once

#include <array>
#include <span>

#include "core/toolpath/curve.h"

namespace feedscope {

/// A point of a course, interpolated by polynomials.
struct CourseKnot {
  double s = 0;    ///< path length from the start of the course [mm]
  Vec3 position;   ///< [mm]
  Vec3 tangent;    ///< unit
  Vec3 curvature;  ///< vector, perpendicular to the tangent [1/mm]
};

/// Quintic Hermite polynomial between two knots, by path length. Position, tangent and curvature match the
/// knots, so a course through many has no jumps up to the second derivative.
class CourseSpan {
 public:
  /// `to.s` - `from.s` must be course_length().
  CourseSpan(const CourseKnot& from, const CourseKnot& to);

  double length() const { return length_; }  ///< [mm]
  /// Point at path length `s` from the beginning, clamped to the span [mm].
  CurvePoint at(double s) const;
  /// First to fourth derivatives by the parameter, at path length `s` as in at().
  std::array<Vec3, 4> derivatives(double s) const;
  /// Point with derivatives by path length, at share `x` in [0, 1] of the parameter, which is nearly that of
  /// the length: cheaper than at().
  CurvePoint by_share(double x) const { return by_path_length(by_parameter(x)); }
  /// Derivative of path length by the parameter relative to its mean, at share `x`.
  double stretch(double x) const { return by_parameter(x).d1.norm() / whole_; }
  /// Distance of `point` from the span near path length `s` [mm]; sets `s` to the nearest place.
  double distance(const Vec3& point, double& s) const;

 private:
  friend double course_length(const CourseKnot& from, const CourseKnot& to);
  CourseSpan(const CourseKnot& from, const CourseKnot& to, double length);
  CurvePoint by_parameter(double x) const;
  double share_at(double s) const;
  /// Length from the beginning to share `x` of the parameter [mm].
  double covered(double x) const;

  double length_;
  Vec3 start_;
  std::array<Vec3, 5> coefficients_;  ///< of x ... x^5, x in [0, 1]
  double whole_;                      ///< covered(1)
};

/// Length of the polynomial between two knots whose derivatives by the parameter equal those by path length:
/// its length equals the range of its parameter [mm]. `s` of the knots is not used.
double course_length(const CourseKnot& from, const CourseKnot& to);

/// Point of a course with at least two knots, at path length `s` from its start, clamped to it [mm].
CurvePoint course_at(std::span<const CourseKnot> course, double s);

}  // namespace feedscope

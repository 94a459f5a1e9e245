#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "core/base/geometry.h"
#include "core/program/path/parametric_curve.h"

namespace feedscope {

inline constexpr std::size_t max_spline_degree = 7;

/// Control point of a rational B-spline: its weight times the place, and the weight (> 0).
inline Eigen::Vector4d weighted(const Vec3& place, double weight) {
  return {weight * place.x(), weight * place.y(), weight * place.z(), weight};
}

/// Knots one apart with `degree` + 1 equal ones at both ends, so that the curve begins and ends at its first
/// and last of `count` control points; `degree` < `count`.
std::vector<double> clamped_knots(std::size_t count, std::size_t degree);

/// Point and slope of the curve at `parameter`, which lies in the knot interval that begins with knot number
/// `interval`, by de Boor's algorithm. There are `degree` + 1 more knots than control points; `degree` at
/// most `max_spline_degree`.
CurvePlace b_spline_place(std::span<const Eigen::Vector4d> points, std::span<const double> knots,
                          std::size_t degree, std::size_t interval, double parameter);

}  // namespace feedscope

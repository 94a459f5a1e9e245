#pragma once

#include <functional>

#include "core/base/geometry.h"

namespace feedscope {

/// A place on a curve.
struct CurvePlace {
  Vec3 point;  ///< [mm]
  Vec3 slope;  ///< derivative by the curve's parameter, of any length
};

/// Continuous, with a continuous slope; the slope may vanish.
using ParametricCurve = std::function<CurvePlace(double)>;

/// Largest distance between a curve and its lines or arcs [mm].
inline constexpr double curve_tolerance = 1e-3;
/// Largest number of halvings of a stretch of a curve for that.
inline constexpr int max_curve_halvings = 16;

}  // namespace feedscope

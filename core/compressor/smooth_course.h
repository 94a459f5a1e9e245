#pragma once

#include <cstddef>
#include <vector>

#include "core/base/progress.h"
#include "core/blend/fitted_course.h"
#include "core/compressor/cubic_spline_fit.h"

namespace feedscope {

/// Accuracy and smoothness of a curve along a polyline.
struct SmoothingRule {
  double tolerance = 0;  ///< largest distance between them [mm]
  double smoothing = 0;  ///< as for CubicSplineFit, in intervals
};

/// A smooth curve along a polyline, or the reason why there is none.
struct SmoothCourse {
  std::vector<CourseKnot> knots;     ///< s from 0
  std::vector<std::size_t> lines;    ///< line of the polyline at each knot except the last
  std::vector<std::size_t> corners;  ///< points that no smooth curve passes closely enough; then no knots
  double deviation = 0;              ///< largest distance found [mm]
};

/// Finds the cubic spline with the fewest intervals within the tolerance of the polyline, as quintic Hermite
/// polynomials by path length between its borders (with position, direction and curvature of the spline).
///
/// The first intervals are as long as a cubic can bend along the turns of the polyline; those outside of the
/// tolerance are halved until none is, with neighbours of very different lengths. An interval of two
/// tolerances that is still outside reports its points as corners. Cost linear in points: a bounded number of
/// fits.
class CourseSmoother {
 public:
  SmoothCourse smooth(const Polyline& polyline, const SmoothingRule& rule,
                      const Progress* progress = nullptr);

 private:
  void set_first_borders(const Polyline& polyline, const SmoothingRule& rule);
  void level_lengths();
  /// Halves the marked intervals.
  void split();

  std::vector<double> borders_;
  std::vector<char> marked_;
  std::vector<double> next_;
};

}  // namespace feedscope

#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "core/base/geometry.h"
#include "core/toolpath/curve.h"

namespace feedscope {

/// Points connected by lines, by the length along them.
struct Polyline {
  std::vector<Vec3> points;    ///< [mm]
  std::vector<double> places;  ///< of each point, from the first [mm]
  Vec3 start_direction;        ///< of the curve along it, unit; unused if free
  Vec3 end_direction;
  bool free_start = false;  ///< direction and curvature at the start result from the fit
  bool free_end = false;

  void clear();
  void add(const Vec3& point);  ///< must differ from the last one
  double length() const { return places.back(); }
  Vec3 direction(std::size_t line) const {
    return (points[line + 1] - points[line]) / (places[line + 1] - places[line]);
  }
};

/// Least-squares cubic spline c(t) with two continuous derivatives along a polyline P(t), t the length along
/// it: minimises
///
///   integral |c - P|^2 dt + sum over intervals (smoothing h)^6 integral |c'''|^2 dt,   h their lengths,
///
/// with position, direction and zero curvature given at both ends, or only the position of a free end (a
/// P-spline with derivatives as penalty, Eilers and Marx 1996; basis on uneven intervals by Qin 2000). The
/// integrals are exact, so points added on the lines change nothing. Cost linear in points and intervals.
class CubicSplineFit {
 public:
  /// `polyline` outlives the fit. `smoothing`: in intervals; waves shorter than about 2 pi times it are
  /// damped.
  CubicSplineFit(const Polyline& polyline, double smoothing) : polyline_(polyline), smoothing_(smoothing) {}

  static constexpr std::size_t min_intervals = 5;

  /// Borders of the intervals from 0 to the length of the polyline, at least min_intervals of them.
  void fit(std::span<const double> borders);

  std::size_t interval_count() const { return intervals_.size(); }
  double begin(std::size_t k) const { return intervals_[k].begin; }
  double end(std::size_t k) const { return intervals_[k].end; }
  /// Line of the polyline at the start of interval `k`.
  std::size_t first_line(std::size_t k) const { return intervals_[k].line; }
  /// Point with derivatives by t, at share `x` of interval `k`.
  CurvePoint at(std::size_t k, double x) const;
  /// Difference of the unit tangents at both ends of interval `k`.
  double turn(std::size_t k) const { return (at(k, 1).d1.normalized() - at(k, 0).d1.normalized()).norm(); }
  /// Largest distance, across the curve, of the polyline from interval `k` [mm], sampled at its points, at
  /// least half way between them and at every eighth of the interval.
  double deviation(std::size_t k) const;

 private:
  using Rows = std::array<std::array<double, 4>, 4>;  ///< [power of x][basis function]

  struct Interval {
    double begin = 0;
    double end = 0;
    std::size_t line = 0;
    std::array<Vec3, 4> moments;       ///< integral of x^a P dx
    Rows rows;                         ///< of the basis
    std::array<Vec3, 4> coefficients;  ///< of c, by powers of x
    double length() const { return end - begin; }
  };

  void set_intervals(std::span<const double> borders);
  void set_basis();
  void solve();
  void set_equations();
  void hold(const Interval& interval, bool at_end, const Vec3& point);
  static std::array<Vec3, 3> control_points(const Interval& interval, bool at_end, const Vec3& point,
                                            const Vec3& direction);
  void take_out_first(const std::array<Vec3, 3>& known);
  void take_out_last(const std::array<Vec3, 3>& known);
  void set_coefficients();
  template <typename Visit>
  void for_pieces(const Interval& interval, const Visit& visit) const;

  const Polyline& polyline_;
  double smoothing_;
  std::vector<Interval> intervals_;
  std::vector<Interval> before_;  ///< of the previous fit; moments are reused for unchanged intervals
  std::vector<std::array<double, 4>> band_;
  std::vector<Vec3> right_;  ///< right side of the equations, then the control points
};

}  // namespace feedscope

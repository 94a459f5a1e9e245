#pragma once

#include <array>

#include "core/limits/segment_limits.h"
#include "core/models/optimal/path_cells.h"

namespace feedscope {

/// What the axes' acceleration limits leave at one place of the path: with T the tangent, c the curvature
/// vector, x = v^2 and u = s'' every axis asks |T_j u + c_j x| <= A_j, that is
///
///   -b_j + m_j x  <=  u  <=  b_j + m_j x,     b_j = A_j / |T_j|,   m_j = -c_j / T_j
///
/// and x <= A_j / |c_j| where T_j vanishes.
class AccelerationRange {
 public:
  AccelerationRange() = default;
  AccelerationRange(const PathPoint& at, const Vec3& acceleration);

  struct Line {
    double b;  ///< [mm/s2]
    double m;  ///< [1/mm]
    int axis;
  };

  double lowest(double x) const;   ///< u [mm/s2]
  double highest(double x) const;  ///< u [mm/s2]
  int axis_of_lowest(double x) const;
  int axis_of_highest(double x) const;
  /// Largest x at which some u is left, and its axis [mm2/s2].
  const AxisBound& largest_x() const { return largest_; }

  /// Leaves what `other` leaves too; of three places at most.
  void intersect(const AccelerationRange& other);
  /// Multiplies every limit by `factor`.
  void tighten(double factor);

  /// Largest of x - length lowest(x) for x in [0, most]: backwards through a cell that ends here.
  double reach_back(double most, double length) const;
  /// Largest x with x + length lowest(x) <= `target`: backwards through a cell that begins here.
  double begin_back(double target, double length) const;
  /// Largest x with x - length highest(x) <= `target`: forwards through a cell that ends here.
  double reach_on(double target, double length) const;

 private:
  void lower(double x, int axis);
  void lower_by_pairs();

  std::array<Line, 9> lines_{};
  int count_ = 0;
  AxisBound largest_{std::numeric_limits<double>::infinity(), -1};
};

}  // namespace feedscope

#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "core/models/optimal/path_cells.h"

namespace feedscope {

/// Motion through a cell of given length from (v0, a0) to (v1, a1): two stretches of constant jerk and equal
/// duration. It meets speeds, accelerations and length exactly:
///
///   (a1 - a0) tau^2 - 6 (v0 + v1) tau + 12 L = 0,   j1 = 4 (v1 - v0) / tau^2 - (3 a0 + a1) / tau,
///                                                   j2 = (a0 + 3 a1) / tau - 4 (v1 - v0) / tau^2
struct CellMotion {
  double time = 0;  ///< tau [s]; 0 where there is no such motion
  double v0 = 0;    ///< [mm/s]
  double a0 = 0;    ///< [mm/s2]
  double j1 = 0;    ///< [mm/s3]
  double v_middle = 0;
  double a_middle = 0;
  double j2 = 0;
  double v1 = 0;
  double a1 = 0;
  double root = 0;  ///< sqrt of the discriminant: the slope of tau by speeds and accelerations

  static CellMotion through(double length, double v0, double a0, double v1, double a1);
};

/// A value and its slopes by (v0, a0, v1, a1).
struct ValueWithSlope {
  double value;
  Eigen::Vector4d slope;
};

/// Demand on the axes by speed, acceleration and jerk at one place, each over its limit: at most 1.
struct PlaceLimits {
  int count = 0;                                       ///< axes that can limit; 1 on a line
  double ceiling = 0;                                  ///< [mm/s]
  std::array<double, 3> tangential_over_acceleration;  ///< T_j / A_j
  std::array<double, 3> curvature_over_acceleration;   ///< c_j / A_j
  std::array<double, 3> tangential_over_jerk;          ///< T_j / J_j
  std::array<double, 3> curvature_over_jerk;           ///< 3 c_j / J_j
  std::array<double, 3> curvature_rate_over_jerk;      ///< d_j / J_j
  std::array<std::int8_t, 3> axis;

  PlaceLimits(const PathPoint& point, bool straight, double speed, const Vec3& acceleration,
              const Vec3& jerk);
  double acceleration(int k, double v, double a) const;
  double jerk(int k, double v, double a, double j) const;
  /// Largest jerk along the path where nothing turns [mm/s3].
  double jerk_along() const;
};

/// A place of a cell: `share` of its length [0, 1].
struct CellPlace {
  double share;
  PlaceLimits limits;
};

/// Cost and slopes of the cell's time plus mu times its barriers -log(1 - p^2), p the demand over the limit.
/// Slopes by (v0^2, a0, v1^2, a1): in these, speed and acceleration along the path are coupled linearly.
/// `curvature` omits the second slopes of p, hence positive.
struct CellCost {
  double value = 0;  ///< infinite if a limit is exceeded
  Eigen::Vector4d slope = Eigen::Vector4d::Zero();
  Eigen::Matrix4d curvature = Eigen::Matrix4d::Zero();
};

CellCost cell_cost(const CellMotion& motion, double length, const CellPlace* first, const CellPlace* last,
                   double mu);
/// Factor by which times must grow to keep every limit; below 1 where they may shrink.
double cell_excess(const CellMotion& motion, const CellPlace* first, const CellPlace* last);
/// The value alone.
double cell_value(const CellMotion& motion, const CellPlace* first, const CellPlace* last, double mu);

}  // namespace feedscope

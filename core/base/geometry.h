#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <limits>

namespace feedscope {

using Vec3 = Eigen::Vector3d;

/// Distance below which points are equal: far below any control's resolution, far above rounding [mm].
inline constexpr double same_point = 1e-6;

inline constexpr std::array<char, 3> coordinate_names{'X', 'Y', 'Z'};

/// Axis-parallel box [mm]; empty until a point or coordinate is added.
struct Bounds {
  Vec3 min = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 max = Vec3::Constant(-std::numeric_limits<double>::infinity());

  bool empty() const { return !(min.array() <= max.array()).all(); }
  void add(const Vec3& p) {
    min = min.cwiseMin(p);
    max = max.cwiseMax(p);
  }
  void add(int axis, double value) {
    min[axis] = std::min(min[axis], value);
    max[axis] = std::max(max[axis], value);
  }
};

}  // namespace feedscope

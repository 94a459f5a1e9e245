#include "core/limits/axis_share.h"

#include <cmath>

namespace feedscope {

AxisBound axis_share(const Vec3& limit, const Vec3& direction) {
  AxisBound bound{std::numeric_limits<double>::infinity(), -1};
  for (int j = 0; j < 3; ++j) {
    const double part = std::abs(direction[j]);
    if (part * bound.value > limit[j]) {
      bound = {limit[j] / part, static_cast<std::int8_t>(j)};
    }
  }
  return bound;
}

Vec3 axis_limit_vector(const Machine& machine, double AxisLimits::*limit) {
  Vec3 limits = Vec3::Zero();
  for (std::size_t i = 0; i < coordinate_names.size(); ++i) {
    const AxisLimits* axis = machine.axes.find(coordinate_names[i]);
    limits[static_cast<Eigen::Index>(i)] = axis == nullptr ? 0 : axis->*limit;
  }
  return limits;
}

}  // namespace feedscope

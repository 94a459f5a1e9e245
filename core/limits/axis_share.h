#pragma once

#include <cstdint>

#include "core/base/geometry.h"
#include "core/machine/machine.h"

namespace feedscope {

/// A limit along the path and the axis that sets it.
struct AxisBound {
  double value = 0;
  std::int8_t axis = -1;  ///< place in known_axes
  bool by_jerk = false;   ///< of an acceleration: the axis' jerk allows no more, as where its course bends
};

/// Least of limit_j / |d_j| over the axes: what a motion along `direction` may reach (core/models/README.md).
/// Axes that `direction` does not move set no bound; if none moves, the value is infinite.
AxisBound axis_share(const Vec3& limit, const Vec3& direction);

/// One limit of the axes that move X, Y and Z; 0 of one that the machine does not have:
/// axis_limit_vector(machine, &AxisLimits::jerk) [inside units].
Vec3 axis_limit_vector(const Machine& machine, double AxisLimits::*limit);

}  // namespace feedscope

#pragma once

#include <cstdint>

#include "core/base/geometry.h"
#include "core/machine/machine.h"

namespace feedscope {

/// A limit along the path and the axis that determines it.
struct AxisBound {
  double value = 0;
  std::int8_t axis = -1;  ///< index in known_axes
  bool by_jerk = false;   ///< of an acceleration: limited by the axis' jerk, as where its course is curved
};

/// Smallest limit_j / |d_j| over the axes: limit of a motion along `direction` (core/models/README.md). Axes
/// that do not move along `direction` set no bound; if none moves, the value is infinite.
AxisBound axis_share(const Vec3& limit, const Vec3& direction);

/// One limit of the axes that move X, Y and Z, 0 for an axis that the machine lacks:
/// axis_limit_vector(machine, &AxisLimits::jerk) [internal units].
Vec3 axis_limit_vector(const Machine& machine, double AxisLimits::*limit);

}  // namespace feedscope

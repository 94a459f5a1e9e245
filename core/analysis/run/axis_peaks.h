#pragma once

#include <algorithm>
#include <cmath>

namespace feedscope {

/// Largest magnitudes of an axis in a run.
struct AxisPeaks {
  double velocity = 0;      ///< [mm/s], of a rotary axis [rad/s]
  double acceleration = 0;  ///< [mm/s2], [rad/s2]
  double jerk = 0;          ///< [mm/s3], [rad/s3]; NaN where the acceleration jumps: Guarantees::limits_jerk

  void add(double at_velocity, double at_acceleration, double at_jerk) {
    velocity = std::max(velocity, std::abs(at_velocity));
    acceleration = std::max(acceleration, std::abs(at_acceleration));
    jerk = std::max(jerk, std::abs(at_jerk));
  }
};

}  // namespace feedscope

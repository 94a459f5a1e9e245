#pragma once

#include "core/trajectory/trajectory.h"

namespace feedscope {

/// Point of the smoothed motion nearest to a programmed point.
struct Approach {
  double distance = 0;  ///< [mm]
  double time = 0;      ///< of the motion [s]
  Kinematics motion;    ///< there, without the jerk
};
/// Closest approach by Newton steps from `time`.
Approach closest_approach(FilterWalk& walk, const PulseTrain& train, const Vec3& point, double time);

/// Direction change at the start of `block`, 0 at the start of the motion [rad].
double corner_turn(const PulseTrain& train, std::size_t block);

/// The programmed corner at the start of `block`, as the pulses round it; its turn is that of the pulses. The
/// caller sets `element`.
BlendRecord filtered_corner(FilterWalk& walk, const PulseTrain& train, std::size_t block);

}  // namespace feedscope

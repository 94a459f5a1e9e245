#pragma once

#include "core/base/geometry.h"

namespace feedscope {

/// Motion at one time, without the path length, which costs a quadrature on curved paths.
struct Kinematics {
  Vec3 position;      ///< [mm]
  Vec3 velocity;      ///< [mm/s]
  Vec3 acceleration;  ///< [mm/s2]
  Vec3 jerk;          ///< [mm/s3]
};

struct VelocityPoint {
  Vec3 velocity;      ///< [mm/s]
  Vec3 acceleration;  ///< [mm/s2]
};

}  // namespace feedscope

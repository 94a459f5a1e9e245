#pragma once

#include "core/base/geometry.h"

namespace feedscope {

/// What an INI file of LinuxCNC says of the planner, in inside units.
struct LinuxCncSettings {
  Vec3 velocity = Vec3::Zero();      ///< MAX_VELOCITY of the axes [mm/s]
  Vec3 acceleration = Vec3::Zero();  ///< MAX_ACCELERATION of the axes [mm/s2]
  double period = 1e-3;              ///< servo period T [s]
  double max_velocity = 0;           ///< MAX_LINEAR_VELOCITY [mm/s]
  double max_override = 1;           ///< MAX_FEED_OVERRIDE
  bool master = false;               ///< planner of master, else of 2.9
  bool blends = true;                ///< G64 where the program says nothing, else G61
  double blend_tolerance = 0;        ///< P of that G64; 0: as fast as possible [mm]
  double naive_tolerance = 0;        ///< Q of it; 0: blocks are not joined [mm]
};

}  // namespace feedscope

#pragma once

#include "core/base/units.h"
#include "core/machine/machine.h"

namespace feedscope {

/// A table that turns by C on one that turns by A, the tool along Z, both with the same limits: 300 deg/s,
/// 1440 deg/s2, 14400 deg/s3. Its axes meet 300 mm below the gauge point.
inline Machine table_machine() {
  Machine machine;
  machine.id = "table";
  for (AxisLimits& axis : machine.axes) {
    axis = {500, 5000, 50000, 50000};
  }
  for (const char name : {'A', 'C'}) {
    RotaryAxis axis;
    axis.name = name;
    axis.velocity = units::from_deg(300);
    axis.acceleration = units::from_deg(1440);
    axis.jerk = units::from_deg(14400);
    axis.direction = name == 'A' ? Vec3::UnitX() : Vec3::UnitZ();
    axis.point = Vec3(0, 0, -300);
    machine.kinematics.rotary.push_back(axis);
  }
  machine.kinematics.chain = "C A X Y frame Z";
  return machine;
}

}  // namespace feedscope

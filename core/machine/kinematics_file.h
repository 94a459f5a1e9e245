#pragma once

#include <string>

#include "core/machine/config_file.h"
#include "core/machine/machine.h"

namespace feedscope {

/// Names of the tables of [axes] in `root` that are rotary axes.
std::vector<std::string> rotary_tables(const ConfigNode& root);

/// Reads [kinematics] and the rotary axes of [axes] into `machine`, with the sources of the numbers:
///   [axes.A]            velocity_rev_min, acceleration_rev_s2, jerk_rev_s3, minimum_deg, maximum_deg
///   [kinematics]        chain = { value = "C A Y frame X Z", source = "..." }
///                       tool_length_mm = { value = 150, source = "..." }, optional
///   [kinematics.A]      direction = { x = 1, y = 0, z = 0, source = "..." }
///                       point = { x_mm = 0, y_mm = 0, z_mm = -50, source = "..." }
/// Reads nothing if both are missing. Throws InputError with place and problem, also for chains that cannot
/// keep a direction (KinematicChain).
void read_kinematics(const ConfigNode& root, Machine& machine);

/// Text that read_kinematics() reads back, bit for bit; empty for a machine without rotary axes.
std::string write_rotary_axes(const Machine& machine);
std::string write_kinematics(const Machine& machine);

}  // namespace feedscope

#pragma once

#include "core/blend/blended_path.h"
#include "core/limits/formula.h"

namespace feedscope {

/// Speed of LinuxCNC on an arc, of the program or in a corner, where 0.866 of the acceleration, or half of
/// that where blocks may overlap, is for turning, whichever is nearer to `reached` [mm/s]; none for a line.
/// `acceleration`: of the axes [mm/s2].
Formula speed_across_arc(const ElementCurve& curve, const Vec3& acceleration, double reached);

/// Acceleration of LinuxCNC along a line, all of it or half, whichever is nearer to `reached` [mm/s2]; none
/// for an arc.
Formula acceleration_of_joints(const ElementCurve& curve, const Vec3& acceleration, double reached);

}  // namespace feedscope

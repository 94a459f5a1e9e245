#pragma once

#include <cstdint>
#include <optional>

#include "core/blend/blended_path.h"
#include "core/limits/formula.h"

namespace feedscope {

/// Speed of LinuxCNC on an arc, of the program or in a corner, at which sqrt(3)/2 of the acceleration is used
/// across the path, or half of that where blocks may overlap, whichever is closer to `reached` [mm/s]; none
/// for a line. `acceleration`: of the axes [mm/s2].
Formula speed_across_arc(const ElementCurve& curve, const Vec3& acceleration, double reached);

/// Acceleration of LinuxCNC along a line, all of it or half, whichever is closer to `reached` [mm/s2]; none
/// for an arc.
Formula acceleration_of_joints(const ElementCurve& curve, const Vec3& acceleration, double reached);

/// Half the angle between the blocks that meet in a corner.
struct HalfTurn {
  double sine = 1;  ///< 1: straight on
  double cosine = 0;
};
/// In the corner before `element`; none at a dwell or where the path reverses.
std::optional<HalfTurn> half_turn(const BlendedPath& path, std::uint32_t element);

}  // namespace feedscope

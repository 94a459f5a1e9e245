#pragma once

#include <cstdint>
#include <optional>

#include "core/blend/blended_path.h"
#include "core/limits/formula.h"

namespace feedscope {

/// Speed of LinuxCNC on an arc, of the program or in a corner, where sqrt(3)/2 of the acceleration, or half
/// of that where blocks may overlap, is for turning, whichever is nearer to `reached` [mm/s]; none for a
/// line. `acceleration`: of the axes [mm/s2].
Formula speed_across_arc(const ElementCurve& curve, const Vec3& acceleration, double reached);

/// Acceleration of LinuxCNC along a line, all of it or half, whichever is nearer to `reached` [mm/s2]; none
/// for an arc.
Formula acceleration_of_joints(const ElementCurve& curve, const Vec3& acceleration, double reached);

/// Of a corner: half the angle between the blocks that meet.
struct HalfTurn {
  double sine = 1;  ///< 1: straight on
  double cosine = 0;
};
/// In the corner before `element`; none at a dwell and where the path turns back.
std::optional<HalfTurn> half_turn(const BlendedPath& path, std::uint32_t element);

}  // namespace feedscope

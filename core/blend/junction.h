#pragma once

#include <cstdint>

#include "core/toolpath/toolpath.h"

namespace feedscope {

/// Up to this change of direction [rad] two blocks count as one straight line; above pi minus this, as a
/// reversal.
inline constexpr double straight_angle = 1e-6;

/// Change of direction [rad] up to which a junction with an arc counts as tangent: the effect of three
/// decimals of a millimetre on the centre of an arc of radius 0.1 mm.
inline constexpr double tangent_angle = 0.01;

/// Angle between two unit vectors, exact also near 0 and pi [rad].
double turn_angle(const Vec3& in, const Vec3& out);

enum class JunctionKind : std::uint8_t {
  pass,        ///< straight on, or tangent
  corner,      ///< between two lines
  arc_corner,  ///< with an arc
  stop,        ///< a reversal, a dwell, a rapid on one of the two sides, or a requested exact stop
};

/// Kind of the junction between segments i - 1 and i; 0 < i < segments.size().
JunctionKind junction_kind(const Toolpath& toolpath, std::size_t i);

}  // namespace feedscope

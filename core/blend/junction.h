#pragma once

#include <cstdint>

#include "core/toolpath/toolpath.h"

namespace feedscope {

/// Below this direction change [rad] two blocks count as one straight line, above pi less this as a reversal.
inline constexpr double straight_angle = 1e-6;

/// Up to this direction change [rad] a junction that touches an arc counts as tangent: what three decimals of
/// a millimetre do to the centre of an arc of radius 0.1 mm.
inline constexpr double tangent_angle = 0.01;

/// Angle between two unit vectors, exact also near 0 and pi [rad].
double turn_angle(const Vec3& in, const Vec3& out);

enum class JunctionKind : std::uint8_t {
  pass,        ///< straight on, or tangent
  corner,      ///< of two lines
  arc_corner,  ///< that touches an arc
  stop,        ///< a reversal, a dwell, a rapid on one of the two sides, or an exact stop asked for
};

/// How the path goes on from segment i - 1 to segment i; 0 < i < segments.size().
JunctionKind junction_kind(const Toolpath& toolpath, std::size_t i);

}  // namespace feedscope

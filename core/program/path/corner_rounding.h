#pragma once

#include <cstdint>

#include "core/program/path/plane_element.h"

namespace feedscope {

enum class CornerFault : std::uint8_t {
  none,
  smooth,     ///< the curves are tangent at the corner: nothing to round
  reversal,   ///< the path turns back at the corner, or a curve has no length
  too_large,  ///< the rounding or chamfer does not fit between the ends of the curves
  not_lines,  ///< a chamfer next to an arc
};

/// Rounding or chamfer in place of the corner where two curves meet.
struct PlaneCorner {
  CornerFault fault = CornerFault::none;
  Vec2 from = Vec2::Zero();    ///< on the first curve
  Vec2 to = Vec2::Zero();      ///< on the second
  Vec2 center = Vec2::Zero();  ///< roundings
  int turn = 0;                ///< 0: chamfer; 1 counter-clockwise, -1 clockwise
};

/// An arc of `radius` > 0 that touches both curves; `second` starts where `first` ends.
PlaneCorner round_corner(const PlaneElement& first, const PlaneElement& second, double radius);

/// A line that cuts `side` > 0 off both.
PlaneCorner chamfer_corner(const PlaneElement& first, const PlaneElement& second, double side);

}  // namespace feedscope

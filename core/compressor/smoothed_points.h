#pragma once

#include "core/compressor/compressor.h"

namespace feedscope {

/// Moves programmed points onto a smooth curve, for a control that smooths points and goes on block by block:
/// `commanded`, a copy of the programmed path, gets the junctions inside the run of `curve` at the places of
/// the curve nearest to them, in their order, and the lengths of the lines between them. False, and nothing
/// is moved, where a point has no place of its own within the tolerance of the curve.
bool move_points(const SmoothCurve& curve, Toolpath& commanded);

}  // namespace feedscope

#pragma once

#include "core/compressor/compressor.h"

namespace feedscope {

/// Moves programmed points onto a smooth curve, for a control that smooths points and continues block by
/// block: moves the junctions of `commanded`, a copy of the programmed path, inside the run of `curve` to the
/// nearest places of the curve, in order, and updates the lengths of the lines between them. Returns false
/// and moves nothing if a point has no distinct place within the tolerance of the curve.
bool move_points(const SmoothCurve& curve, Toolpath& commanded);

}  // namespace feedscope

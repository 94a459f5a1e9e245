#pragma once

#include <vector>

#include "core/base/geometry.h"
#include "core/program/path/parametric_curve.h"

namespace feedscope {

/// Ends of the chords that stay within `curve_tolerance` of `curve` from parameter `from` to `to`, in order,
/// including the curve's end. A curve gives at most some 65 000 chords.
std::vector<Vec3> lines_of_curve(const ParametricCurve& curve, double from, double to);

}  // namespace feedscope

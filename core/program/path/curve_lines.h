#pragma once

#include <functional>

#include "core/base/geometry.h"

namespace feedscope {

/// Largest distance of the lines from a curve that is read as lines [mm].
inline constexpr double curve_chord_error = 1e-3;

/// Ends of the chords that stay within `curve_chord_error` of `curve` from parameter `from` to `to`, in
/// order, the curve's end last. A curve is taken apart into at most some 65 000 chords.
void lines_of_curve(const std::function<Vec3(double)>& curve, double from, double to,
                    const std::function<void(const Vec3&)>& line_to);

}  // namespace feedscope

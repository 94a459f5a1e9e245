#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/base/diagnostic.h"
#include "core/toolpath/toolpath.h"

namespace feedscope {

/// Distance between a curve and the chords into which a CAM system cut it, estimated from the chords alone.
///
/// A chord of length h on a curve of curvature k is 1/k - sqrt(1/k^2 - h^2/4) away from it, about k h^2/8.
/// The curvature at the point between two chords is the difference of their directions over half of their
/// lengths, a vector; that of a chord is the mean of both ends. On a circle in equal chords both are exact;
/// elsewhere the error is of the order of the change of curvature along a chord. Where points scatter
/// independently across the curve with a standard deviation of s, the means reduce that to s/8.
///
/// The value of a program is that within which 95 % of its chords stay. CAM systems shorten steps to keep the
/// chord error but often have other limits as well, so the largest values are those of the tolerance. Points
/// are assumed to be on the curve; where a CAM system puts chords on both sides of it, its own tolerance is
/// half of the value.
struct ChordError {
  double value = 0;        ///< [mm]
  std::size_t chords = 0;  ///< used for the estimate
};

/// Heidenhain's advice for the contour tolerance of a program, as shares of its chord error.
inline constexpr double least_advised_tolerance = 1.1;
inline constexpr double largest_advised_tolerance = 2.0;
/// Whether a share follows the advice, within half a percent.
bool is_advised_tolerance(double share);

/// Estimates from cutting lines of up to 20 mm between corners of up to 36 degrees, the longest blocks and
/// sharpest corners that a Sinumerik compresses by default. A chord does not count if a neighbour is less
/// than half as long, or if the curvatures of its ends differ by a factor of more than three or in side:
/// those are corners, ends of straight parts and noise. None for fewer than 20 chords or below 0.1 um, beyond
/// the resolution of three decimals.
std::optional<ChordError> chord_error_of(const Toolpath& toolpath);

/// Message about a program: the estimate, and Heidenhain's advice unless all tolerances in the program follow
/// it.
Diagnostic chord_error_message(const ChordError& error, const std::vector<PathControl>& feed_controls);

}  // namespace feedscope

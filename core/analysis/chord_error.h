#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/base/diagnostic.h"
#include "core/toolpath/toolpath.h"

namespace feedscope {

/// How far the chords, in which a CAM system cut a curve, lie from it, estimated from the chords alone.
///
/// A chord of length h on a curve of curvature k lies 1/k - sqrt(1/k^2 - h^2/4) from it, about k h^2/8. The
/// curvature at the point between two chords is the difference of their directions over half of their
/// lengths, a vector; that of a chord is the mean of both its ends. On a circle in equal chords both are
/// exact; elsewhere the error is of the order of the change of curvature along a chord. Where points stray
/// across the curve by a standard deviation of s, each by itself, the means leave s/8 of it.
///
/// Of a program it is the value that 95 % of its chords keep: the step that CAM systems shorten until the
/// chord error is kept is often limited elsewhere, too, so that the largest ones are those of its tolerance.
/// Points are taken to lie on the curve; where a CAM system lays its chords to both sides of it, its own
/// tolerance is half of the value.
struct ChordError {
  double value = 0;        ///< [mm]
  std::size_t chords = 0;  ///< that it was estimated from
};

/// Heidenhain's advice for the contour tolerance of a program, as shares of its chord error.
inline constexpr double least_advised_tolerance = 1.1;
inline constexpr double largest_advised_tolerance = 2.0;
/// Whether a share keeps it, up to half a percent.
bool is_advised_tolerance(double share);

/// Of the cutting lines of up to 20 mm between corners of up to 36 degrees, the longest blocks and sharpest
/// corners that a Sinumerik compresses as it comes. A chord does not count where a neighbour is less than
/// half as long, nor where the curvatures of its ends differ by more than three times or in their side: those
/// are corners, ends of straight parts and noise. None with fewer than 20 chords, nor below 0.1 um, where
/// coordinates of three decimals say nothing.
std::optional<ChordError> chord_error_of(const Toolpath& toolpath);

/// The message of a program: the estimate, and Heidenhain's advice unless all tolerances that the program
/// asks for follow it.
Diagnostic chord_error_message(const ChordError& error, const std::vector<PathControl>& feed_controls);

}  // namespace feedscope

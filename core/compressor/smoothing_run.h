#pragma once

#include <cstddef>
#include <vector>

#include "core/blend/path_rules.h"
#include "core/toolpath/toolpath.h"

namespace feedscope {

/// Rule for lines that a compressor combines.
struct CompressorRule {
  double longest_block = 20;  ///< longer lines stay lines [mm]
  double largest_turn = 0;    ///< of a corner that is smoothed [rad]
  bool everywhere = true;     ///< else only where the program requests it
  bool lines = true;          ///< whether lines are combined at all
};

/// A part of the programmed path that becomes one smooth curve: from a place on segment `first` to one on
/// segment `last` > `first`, with all junctions in between smoothed.
struct SmoothingRun {
  std::size_t first = 0;
  std::size_t last = 0;
  double begin = 0;        ///< start of the curve, from the start of segment `first` [mm]
  double end = 0;          ///< end of the curve, from the start of segment `last` [mm]
  bool from_rest = false;  ///< begins at a standstill
  bool to_rest = false;    ///< ends at one
  bool on_curve = false;   ///< of segments that approximate a curve of the program
};

/// Finds the runs of segments [first, last), which have no stop in between, in order.
///
/// Tangent lines and arcs that approximate curves of the program are combined, each as a whole, whatever the
/// rule.
///
/// Two lines are combined if the corner between them is within the angle of the rule and too close to its
/// neighbours for its own blend: if the blend of the whole tolerance, which begins 4 tolerance / (1.5
/// sin(turn/2)) before the corner, needs more than half of the shorter line. A run begins and ends in the
/// middle of its first and last line, or half of the longest block into it if that is less, so that corners
/// at its ends have room for their blends and lines beyond it remain; at a standstill, at the end of the
/// line. Lines at its ends shorter than two tolerances stay outside: they would determine the direction of
/// the curve. `corners`: junctions, by the next segment and in order, that no run may smooth.
std::vector<SmoothingRun> find_smoothing_runs(const Toolpath& toolpath, std::size_t first, std::size_t last,
                                              const PathRules& rules, const CompressorRule& rule,
                                              const std::vector<std::size_t>& corners);

}  // namespace feedscope

#pragma once

#include <cstddef>
#include <vector>

#include "core/blend/path_rules.h"
#include "core/toolpath/toolpath.h"

namespace feedscope {

/// Which lines a compressor takes together.
struct CompressorRule {
  double longest_block = 20;  ///< longer lines stay lines [mm]
  double largest_turn = 0;    ///< of a corner that is smoothed [rad]
  bool everywhere = true;     ///< else only where the program asks for it
  bool lines = true;          ///< whether lines are taken together at all
};

/// A part of the programmed path that becomes one smooth curve: from a place on segment `first` to one on
/// segment `last` > `first`, every junction between them smoothed.
struct SmoothingRun {
  std::size_t first = 0;
  std::size_t last = 0;
  double begin = 0;        ///< where the curve begins, from the start of segment `first` [mm]
  double end = 0;          ///< where it ends, from the start of segment `last` [mm]
  bool from_rest = false;  ///< begins at a standstill
  bool to_rest = false;    ///< ends at one
  bool on_curve = false;   ///< segments that stand for a curve of the program
};

/// The runs of segments [first, last), which have no stop between them, in order.
///
/// Lines and arcs that stand for curves of the program and go on tangentially are taken together, each as a
/// whole, whatever the rule says.
///
/// Two lines are taken together where the corner between them turns by no more than the rule says and is too
/// close to its neighbours for a blend of its own: where the blend of the whole tolerance, which begins
/// 4 tolerance / (1.5 sin(turn/2)) before the corner, needs more than half of the shorter line. A run begins
/// and ends in the middle of its first and last line, or half of the longest block into it where that is
/// less, so that corners at its ends have room for their blends and lines beyond it stay; at a standstill,
/// where the line does. Lines at its ends that are shorter than two tolerances stay outside: their direction
/// would be that of the curve. `corners`: junctions, by the segment behind them and in order, that no run may
/// smooth.
std::vector<SmoothingRun> find_smoothing_runs(const Toolpath& toolpath, std::size_t first, std::size_t last,
                                              const PathRules& rules, const CompressorRule& rule,
                                              const std::vector<std::size_t>& corners);

}  // namespace feedscope

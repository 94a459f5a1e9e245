#pragma once

#include <cstdint>
#include <vector>

#include "core/blend/path_rules.h"

namespace feedscope {

/// A programmed path in which runs of lines are replaced by their chords.
struct CompactedPath {
  Toolpath path;                     ///< a chord has the line number and feed of its first block
  std::vector<std::uint32_t> first;  ///< per segment of `path` and one beyond: the programmed segment
  double deviation = 0;              ///< largest distance of a replaced point from its chord [mm]
};

/// Replaces consecutive cutting lines of one feed and path control, each shorter than `longest` [mm] and all
/// together at most that long, by one line from the first point to the last, where every point between them
/// stays within the contour tolerance of it and every block turns from it by at most 60 degrees (Msaddek
/// 2011, section 3.3.4; how the control of the paper decides is not printed). Takes as many blocks together
/// as it can find by doubling and halving: cost n log n at worst.
CompactedPath compact(const Toolpath& toolpath, double longest, const PathRules& rules);

/// Replaces consecutive cutting lines of one feed, path control, spindle and direction by one line each,
/// where every point between them stays within `tolerance` [mm] of it. Nothing is replaced across an exact
/// stop, a rapid, a dwell or an arc, nor where rotary axes turn. Blocks are taken together as by compact().
CompactedPath merge_collinear(const Toolpath& toolpath, double tolerance);

}  // namespace feedscope

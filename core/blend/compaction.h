#pragma once

#include <cstdint>
#include <vector>

#include "core/blend/path_rules.h"

namespace feedscope {

/// A programmed path with runs of lines replaced by their chords.
struct CompactedPath {
  Toolpath path;                     ///< a chord has line number and feed of its first block
  std::vector<std::uint32_t> first;  ///< per segment of `path` and one beyond: its first programmed segment
  double deviation = 0;              ///< largest distance of a replaced point from its chord [mm]
};

/// Replaces consecutive cutting lines with the same feed and path control, each shorter than `longest` [mm]
/// and together at most that long, by one line from the first point to the last, if every point in between is
/// within the contour tolerance of it and every block turns from it by at most 60 degrees (Msaddek 2011,
/// section 3.3.4; the paper does not print the decision rule of its control). Merges as many blocks as it
/// finds by doubling and halving: cost n log n at worst.
CompactedPath compact(const Toolpath& toolpath, double longest, const PathRules& rules);

/// Replaces consecutive cutting lines with the same feed, path control, spindle and direction by one line
/// each, if every point in between is within `tolerance` [mm] of it. Nothing is replaced across an exact
/// stop, a rapid, a dwell or an arc, or where rotary axes turn. Blocks are merged as in compact().
CompactedPath merge_collinear(const Toolpath& toolpath, double tolerance);

}  // namespace feedscope

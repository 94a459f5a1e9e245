#pragma once

#include <cstdint>
#include <vector>

#include "core/toolpath/toolpath.h"

namespace feedscope {

/// Segments of two paths that replace each other: [old_begin, old_end) and [now_begin, now_end).
struct MatchedStretch {
  std::uint32_t old_begin = 0, old_end = 0;
  std::uint32_t now_begin = 0, now_end = 0;
  bool same = false;  ///< the same motions one to one; otherwise different ones, or none on one side
};

/// Aligns two programmed paths, in order and without gaps, by their motions: start, end, kind, centre and
/// length to 0.1 um, dwells by their time; feeds and lines do not count. Of motions in different order, the
/// longest sequence that keeps the order is the same.
///
/// Motions that occur once in each path are anchors; those that ascend in both paths (longest increasing
/// subsequence) divide the paths into parts, which are matched likewise after their common ends. A part
/// without anchors is not the same. O(n log n) for each of at most 24 levels of parts.
std::vector<MatchedStretch> match_toolpaths(const Toolpath& old, const Toolpath& now);

}  // namespace feedscope

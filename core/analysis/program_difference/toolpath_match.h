#pragma once

#include <cstdint>
#include <vector>

#include "core/toolpath/toolpath.h"

namespace feedscope {

/// Segments of two paths that take each other's place: [old_begin, old_end) and [now_begin, now_end).
struct MatchedStretch {
  std::uint32_t old_begin = 0, old_end = 0;
  std::uint32_t now_begin = 0, now_end = 0;
  bool same = false;  ///< one to one the same motions; else other ones, or none on one side
};

/// Two programmed paths beside each other, in order and without a gap, by their motions: start, end, kind,
/// centre and length to 0.1 um, dwells by their time; feeds and lines do not count. What stands in both in
/// another order is the same on the longest run of it that keeps the order.
///
/// Motions that are in each path once are anchors; those that rise in both paths (longest increasing
/// subsequence) cut the paths into parts, which are matched in the same way after what their ends have in
/// common. A part without anchors is not the same. O(n log n) for each level of parts, of which there are at
/// most 24.
std::vector<MatchedStretch> match_toolpaths(const Toolpath& old, const Toolpath& now);

}  // namespace feedscope

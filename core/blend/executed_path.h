#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/toolpath/toolpath.h"

namespace feedscope {

/// A corner that a control rounds in its own way.
struct RoundedCorner {
  std::uint32_t first = 0;    ///< first element of the rounding
  std::uint32_t last = 0;     ///< last one
  std::uint32_t block = 0;    ///< of the programmed path: ends at the corner
  Vec3 point = Vec3::Zero();  ///< junction of the blocks [mm]
  double turn = 0;            ///< change of direction [rad]
};

/// Path that a control runs in place of the programmed one: chords of arcs, points rounded to steps, joined
/// lines, its own arcs in corners.
struct ExecutedPath {
  Toolpath path;                     ///< with line, feed and rapid of every segment's original block
  std::vector<std::uint32_t> block;  ///< per segment of `path`: index in the programmed path, ascending

  std::vector<RoundedCorner> corners;  ///< in order of their elements

  /// Whether element `i` of a path on this one is part of a rounded corner.
  bool rounds_corner(std::uint32_t i) const {
    const auto after = std::ranges::upper_bound(corners, i, {}, &RoundedCorner::first);
    return after != corners.begin() && i <= std::prev(after)->last;
  }
  void add(const Segment& segment, std::uint32_t of_block) {
    path.segments.push_back(segment);
    block.push_back(of_block);
  }
};

}  // namespace feedscope

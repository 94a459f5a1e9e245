#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/toolpath/toolpath.h"

namespace feedscope {

/// A corner that a control rounds in a way of its own.
struct RoundedCorner {
  std::uint32_t first = 0;    ///< the first element of the rounding
  std::uint32_t last = 0;     ///< and the last one
  std::uint32_t block = 0;    ///< of the programmed path: the one that ends at the corner
  Vec3 point = Vec3::Zero();  ///< where the blocks would meet [mm]
  double turn = 0;            ///< change of direction there [rad]
};

/// What a control runs in place of the programmed path: chords of arcs, points rounded to steps, lines that
/// it joins, arcs of its own in corners.
struct ExecutedPath {
  Toolpath path;  ///< line, feed and rapid of every segment are those of the block that it comes from
  std::vector<std::uint32_t> block;  ///< per segment of `path`: of the programmed path, in rising order

  std::vector<RoundedCorner> corners;  ///< in order of their elements

  /// Whether element `i` of a path that runs this is part of a rounded corner.
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

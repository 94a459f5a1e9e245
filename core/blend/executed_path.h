#pragma once

#include <cstdint>
#include <vector>

#include "core/toolpath/toolpath.h"

namespace feedscope {

/// What a control runs in place of the programmed path: chords of arcs, points rounded to steps, lines that
/// it joins, arcs of its own in corners.
struct ExecutedPath {
  Toolpath path;  ///< line, feed and rapid of every segment are those of the block that it comes from
  std::vector<std::uint32_t> block;  ///< per segment of `path`: of the programmed path, in rising order

  void add(const Segment& segment, std::uint32_t of_block) {
    path.segments.push_back(segment);
    block.push_back(of_block);
  }
};

}  // namespace feedscope

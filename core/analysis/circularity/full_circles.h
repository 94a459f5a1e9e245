#pragma once

#include <cstdint>
#include <vector>

#include "core/analysis/circularity/circle_plane.h"
#include "core/toolpath/toolpath.h"

namespace feedscope {

/// A cut of at least a whole turn at one radius about one centre: an arc, or several in direct sequence. On
/// the path of a toolpath: that of the tool centre if the program's cutter radius compensation is known, in
/// coordinates after frames and offsets.
struct FullCircle {
  std::size_t first = 0;  ///< segments of the toolpath
  std::size_t last = 0;
  std::uint32_t first_line = 0;  ///< blocks
  std::uint32_t last_line = 0;
  CirclePlane plane = CirclePlane::xy;
  bool counter_clockwise = true;  ///< from the first axis of the plane to the second
  Vec3 center = Vec3::Zero();     ///< mean of the arcs [mm]
  double radius = 0;              ///< mean of the arcs [mm]
  double start = 0;               ///< angle from the first axis of the plane [rad]
  double sweep = 0;               ///< of all arcs together [rad]
  double feed = 0;                ///< largest programmed feed [mm/s]
};

/// Full turns of a program.
struct FullCircles {
  std::vector<FullCircle> circles;  ///< in order of the program
  std::size_t helices = 0;          ///< with full turns: not in one plane, so they are not evaluated
  std::size_t tilted = 0;           ///< flat, but in none of the planes XY, ZX and YZ
};

/// Distance up to which centres and radii of arcs belong to one circle: the effect of two roundings to 0.0001
/// inch [mm].
inline constexpr double one_circle = 0.005;
/// Distance up to which a turn counts as closed, together with a hundredth of a radian [mm].
inline constexpr double closed_circle = 0.02;

/// One pass over the segments. Circles that a program approximates by short lines are not found: lines have
/// no centre. Rapids, pauses and lines end a circle.
FullCircles find_full_circles(const Toolpath& path);

/// Whether both are the same circle at the same programmed feed, in either direction.
bool is_same_circle(const FullCircle& a, const FullCircle& b);

}  // namespace feedscope

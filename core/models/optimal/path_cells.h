#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/blend/blended_path.h"
#include "core/limits/segment_limits.h"

namespace feedscope {

/// A speed, share or time without a bound.
inline constexpr double infinite = std::numeric_limits<double>::infinity();

/// Derivatives of the path by path length at one place: unit tangent T, curvature vector c = p'' [1/mm] and
/// d = p''' [1/mm2].
struct PathPoint {
  Vec3 t = Vec3::Zero();
  Vec3 c = Vec3::Zero();
  Vec3 d = Vec3::Zero();
};

/// Part of one element, so short that the path hardly turns on it; a straight part is one cell.
struct PathCell {
  double length = 0;  ///< > 0 [mm]
  double offset = 0;  ///< of its start from the start of the element [mm]
  std::uint32_t element = 0;
  bool straight = false;
  PathPoint from;
  PathPoint middle;
  PathPoint to;
};

/// Fineness of the cells of curves.
struct CellRule {
  int fineness = 1;   ///< 2: cells of half the length
  Vec3 acceleration;  ///< fewer cells where turning at `speed` uses almost none of these [mm/s2]
  Vec3 jerk = Vec3::Constant(std::numeric_limits<double>::infinity());  ///< the same [mm/s3]
  double speed = 0;                                                     ///< [mm/s]
  int least = 4;                                                        ///< cells of a curve that needs more
};

/// Length of element `index` [mm], rounded so that it does not depend on the element's distance from the
/// beginning of the path: path lengths are rounded there, and the law would differ.
double law_length(const BlendedPath& path, std::uint32_t index);

/// Appends the cells of element `index`. Nothing for a dwell.
void append_cells(const BlendedPath& path, std::uint32_t index, const CellRule& rule,
                  std::vector<PathCell>& cells);

/// True if none of them turns.
bool all_straight(std::span<const PathCell> cells);

/// True if the tool must stop between elements `index` - 1 and `index` whatever the time law: a kink, a
/// reversal, a dwell on one of the two sides. Curves inserted by a control are tangent to their neighbours.
bool is_stop(const BlendedPath& path, std::uint32_t index);

}  // namespace feedscope

#pragma once

#include <vector>

#include "core/program/path/plane_element.h"

namespace feedscope {

/// Cycle 220: places on a circle. Angles in rad; a `step` of 0 divides the angle from start to stop, a whole
/// turn by one place more.
struct CirclePattern {
  Vec2 center = Vec2::Zero();
  double diameter = 0;
  double start = 0;
  double stop = 0;
  double step = 0;
  int count = 0;
};
std::vector<Vec2> places_of(const CirclePattern& pattern);

/// Cycle 221, ROW, PAT and FRAME: places in rows, there and back, or on the edge only, once round; turned
/// about the first one.
struct GridPattern {
  Vec2 start = Vec2::Zero();
  double column_spacing = 0;
  double row_spacing = 0;
  int columns = 0;
  int rows = 0;
  double angle = 0;         ///< of the whole [rad]
  double first_angle = 0;   ///< of the rows, on top [rad]
  double second_angle = 0;  ///< of the columns, on top [rad]
  bool frame_only = false;
};
std::vector<Vec2> places_of(const GridPattern& pattern);

}  // namespace feedscope

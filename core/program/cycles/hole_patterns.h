#pragma once

#include <vector>

#include "core/program/path/plane_element.h"

namespace feedscope {

/// Places of holes in the plane, in drilling order. Lengths are in the caller's unit, angles in rad.

/// On a circle, `step` apart. Sinumerik HOLES2, Haas G70 and G71.
struct CirclePattern {
  Vec2 center = Vec2::Zero();
  double diameter = 0;
  double start = 0;
  double step = 0;
  int count = 0;
};
/// Angle between `count` places from start to stop, both included; on a whole turn the last place differs
/// from the first. Heidenhain cycle 220.
double step_between(double start, double stop, int count);
std::vector<Vec2> places_of(const CirclePattern& pattern);

/// On a line from the start. Sinumerik HOLES1, Haas G72, Heidenhain ROW.
struct RowPattern {
  Vec2 start = Vec2::Zero();
  double spacing = 0;
  double angle = 0;
  int count = 0;
};
std::vector<Vec2> places_of(const RowPattern& pattern);

/// In rows, there and back, or on the edge only, once round; turned about the first place. Heidenhain cycle
/// 221, PAT and FRAME.
struct GridPattern {
  Vec2 start = Vec2::Zero();
  double column_spacing = 0;
  double row_spacing = 0;
  int columns = 0;
  int rows = 0;
  double angle = 0;         ///< of the whole [rad]
  double first_angle = 0;   ///< of the rows, added [rad]
  double second_angle = 0;  ///< of the columns, added [rad]
  bool frame_only = false;
};
std::vector<Vec2> places_of(const GridPattern& pattern);

}  // namespace feedscope

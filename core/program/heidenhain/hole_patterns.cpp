#include "core/program/heidenhain/hole_patterns.h"

#include "core/base/units.h"
#include "core/program/path/plane_points.h"

namespace feedscope {

std::vector<Vec2> places_of(const CirclePattern& pattern) {
  constexpr double same_angle = 1e-9;
  double step = pattern.step;
  if (step == 0 && pattern.count > 1) {
    const double whole = pattern.stop - pattern.start;
    const bool full_turn = std::abs(std::abs(whole) - 2 * units::pi) < same_angle;
    step = whole / (full_turn ? pattern.count : pattern.count - 1);
  }
  std::vector<Vec2> places;
  for (int i = 0; i < pattern.count; ++i) {
    places.push_back(pattern.center + turned(Vec2(pattern.diameter / 2, 0), pattern.start + i * step));
  }
  return places;
}

std::vector<Vec2> places_of(const GridPattern& pattern) {
  std::vector<Vec2> places;
  for (int row = 0; row < pattern.rows; ++row) {
    for (int i = 0; i < pattern.columns; ++i) {
      const int column = row % 2 == 0 ? i : pattern.columns - 1 - i;
      const Vec2 place(column * pattern.column_spacing, row * pattern.row_spacing);
      places.push_back(pattern.start + turned(place, pattern.angle));
    }
  }
  return places;
}

}  // namespace feedscope

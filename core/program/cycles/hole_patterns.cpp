#include "core/program/cycles/hole_patterns.h"

#include <cmath>

#include "core/base/units.h"
#include "core/program/path/plane_points.h"

namespace feedscope {

double step_between(double start, double stop, int count) {
  constexpr double same_angle = 1e-9;
  if (count < 2) {
    return 0;
  }
  const bool full_turn = std::abs(std::abs(stop - start) - 2 * units::pi) < same_angle;
  return (stop - start) / (full_turn ? count : count - 1);
}

std::vector<Vec2> places_of(const CirclePattern& pattern) {
  std::vector<Vec2> places;
  for (int i = 0; i < pattern.count; ++i) {
    const double angle = pattern.start + i * pattern.step;
    places.push_back(pattern.center + turned(Vec2(pattern.diameter / 2, 0), angle));
  }
  return places;
}

std::vector<Vec2> places_of(const RowPattern& pattern) {
  const Vec2 apart = turned(Vec2(pattern.spacing, 0), pattern.angle);
  std::vector<Vec2> places;
  for (int i = 0; i < pattern.count; ++i) {
    places.push_back(pattern.start + i * apart);
  }
  return places;
}

std::vector<Vec2> places_of(const GridPattern& pattern) {
  const Vec2 across = turned(Vec2(pattern.column_spacing, 0), pattern.angle + pattern.first_angle);
  const Vec2 along = turned(Vec2(0, pattern.row_spacing), pattern.angle + pattern.second_angle);
  std::vector<Vec2> places;
  const auto add = [&](int column, int row) {
    places.push_back(pattern.start + column * across + row * along);
  };
  const int last_column = pattern.columns - 1;
  const int last_row = pattern.rows - 1;
  if (!pattern.frame_only) {
    for (int row = 0; row <= last_row; ++row) {
      for (int i = 0; i <= last_column; ++i) {
        add(row % 2 == 0 ? i : last_column - i, row);
      }
    }
    return places;
  }
  for (int i = 0; i <= last_column; ++i) {
    add(i, 0);
  }
  for (int row = 1; row <= last_row; ++row) {
    add(last_column, row);
  }
  for (int i = last_column - 1; i >= 0 && last_row > 0; --i) {
    add(i, last_row);
  }
  for (int row = last_row - 1; row > 0 && last_column > 0; --row) {
    add(0, row);
  }
  return places;
}

}  // namespace feedscope

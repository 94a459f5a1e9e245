#pragma once

#include <limits>

#include "core/program/path/plane_element.h"

namespace feedscope {

/// Axis-parallel box in a plane [mm]; empty until something is added.
struct PlaneBox {
  Vec2 min = Vec2::Constant(std::numeric_limits<double>::infinity());
  Vec2 max = Vec2::Constant(-std::numeric_limits<double>::infinity());

  void add(const Vec2& point);
  void add(const PlaneBox& box);
  /// True if no gap between the boxes is larger than `distance`.
  bool is_near(const PlaneBox& box, double distance) const {
    return (box.min.array() <= max.array() + distance).all() &&
           (min.array() <= box.max.array() + distance).all();
  }
};

PlaneBox box_of(const PlaneElement& element);

/// Shortest distance [mm].
double distance(const Vec2& point, const PlaneElement& element);
/// Shortest distance [mm]; 0 where they meet. Otherwise the shortest connection begins at one of the four
/// ends or is at right angles to both: on a line it begins next to the other one's centre, on an arc on the
/// line through both centres.
double distance(const PlaneElement& a, const PlaneElement& b);

}  // namespace feedscope

#pragma once

#include <Eigen/Core>
#include <array>

namespace feedscope {

using Vec2 = Eigen::Vector2d;

/// Direction a quarter turn to the left of `v`.
inline Vec2 left_of(const Vec2& v) {
  return {-v.y(), v.x()};
}

inline double cross(const Vec2& a, const Vec2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// A line or arc in a plane: an element of a contour or of an offset path.
struct PlaneElement {
  Vec2 start;                  ///< [mm]
  Vec2 end;                    ///< [mm]
  int turn = 0;                ///< 1: counter-clockwise arc, -1: clockwise arc, 0: line
  Vec2 center = Vec2::Zero();  ///< arcs [mm]
  double radius = 0;           ///< arcs [mm]
  double sweep = 0;            ///< arcs, whole turns included, >= 0 [rad]

  static PlaneElement line(const Vec2& start, const Vec2& end);
  /// Ends that coincide make `turns` whole circles; other ends add `turns` to the part between them.
  static PlaneElement arc(const Vec2& start, const Vec2& end, const Vec2& center, int turn, double turns);

  bool is_arc() const { return turn != 0; }
  /// Unit directions of motion.
  Vec2 tangent_at_start() const;
  Vec2 tangent_at_end() const;
};

/// Offset element at the distance `left` to the left (negative: right) [mm]. For a distance above the radius
/// the radius of an arc becomes negative: it then runs the other way round.
PlaneElement beside(const PlaneElement& element, double left);

/// Meeting points of the endless lines or full circles of `a` and `b`.
struct Meetings {
  int count = 0;
  std::array<Vec2, 2> points;
};
Meetings meetings(const PlaneElement& a, const PlaneElement& b);

/// Sweep of the arc if it ran from `from` to `to` [rad], points on its circle less than half a turn away from
/// its own ends; negative if `to` comes before `from`.
double sweep_between(const PlaneElement& arc, const Vec2& from, const Vec2& to);

}  // namespace feedscope

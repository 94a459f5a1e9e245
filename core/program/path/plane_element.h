#pragma once

#include <Eigen/Core>
#include <array>

namespace feedscope {

using Vec2 = Eigen::Vector2d;

/// The direction a quarter turn to the left of `v`.
inline Vec2 left_of(const Vec2& v) {
  return {-v.y(), v.x()};
}

inline double cross(const Vec2& a, const Vec2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// A line or arc in a plane: an element of a contour, or of a path beside it.
struct PlaneElement {
  Vec2 start;                  ///< [mm]
  Vec2 end;                    ///< [mm]
  int turn = 0;                ///< 1: counter-clockwise arc, -1: clockwise arc, 0: line
  Vec2 center = Vec2::Zero();  ///< arcs [mm]
  double radius = 0;           ///< arcs [mm]
  double sweep = 0;            ///< arcs, whole turns included, >= 0 [rad]

  static PlaneElement line(const Vec2& start, const Vec2& end);
  /// Ends that coincide make `turns` whole circles, others `turns` more than the part between them.
  static PlaneElement arc(const Vec2& start, const Vec2& end, const Vec2& center, int turn, double turns);

  bool is_arc() const { return turn != 0; }
  /// Unit directions of motion.
  Vec2 tangent_at_start() const;
  Vec2 tangent_at_end() const;
};

/// All points `left` beside the element on its left (negative: right) [mm]. The radius of an arc comes out as
/// negative where the distance is larger than the radius: it then runs the other way round.
PlaneElement beside(const PlaneElement& element, double left);

/// Where the endless line or full circle of `a` and that of `b` meet.
struct Meetings {
  int count = 0;
  std::array<Vec2, 2> points;
};
Meetings meetings(const PlaneElement& a, const PlaneElement& b);

/// Of the arc, moved ends and all [rad]: its sweep if it ran from `from` to `to`, points on its circle less
/// than half a turn away from its own ends; negative if `to` comes before `from`.
double sweep_between(const PlaneElement& arc, const Vec2& from, const Vec2& to);

}  // namespace feedscope

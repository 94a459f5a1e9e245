#include "core/analysis/circularity/full_circles.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace feedscope {
namespace {

constexpr double full_turn = 2 * std::numbers::pi;
constexpr double along_axis = 1 - 1e-9;  // cosine of the angle to the axis

enum class Shape : std::uint8_t { flat, helix, tilted };

/// Common properties of consecutive arcs.
struct Turn {
  Shape shape = Shape::flat;
  Vec3 axis;    ///< unit; the arcs are right-handed about it
  Vec3 center;  ///< of the first arc [mm]
  double radius = 0;
  Vec3 sum_of_centers = Vec3::Zero();  ///< weighted by sweep
  double sum_of_radii = 0;
  FullCircle circle;
};

/// Plane whose normal is the axis, and whether the turn is counter-clockwise there.
std::optional<std::pair<CirclePlane, bool>> plane_of(const Vec3& axis) {
  for (const CirclePlane plane : {CirclePlane::xy, CirclePlane::zx, CirclePlane::yz}) {
    const PlaneInfo& info = info_of(plane);
    const double along = Vec3::Unit(info.first_index).cross(Vec3::Unit(info.second_index)).dot(axis);
    if (std::abs(along) > along_axis) {
      return std::pair(plane, along > 0);
    }
  }
  return std::nullopt;
}

Shape shape_of(const Arc& arc, const Vec3& axis) {
  if (arc.rise.norm() * arc.sweep > same_point) {
    return Shape::helix;
  }
  return plane_of(axis) ? Shape::flat : Shape::tilted;
}

bool goes_on(const Turn& turn, const Arc& arc, const Vec3& axis) {
  Vec3 between = arc.center - turn.center;
  if (turn.shape == Shape::helix) {
    between -= between.dot(turn.axis) * turn.axis;
  }
  return shape_of(arc, axis) == turn.shape && axis.dot(turn.axis) > along_axis &&
         between.norm() <= one_circle && std::abs(arc.radius - turn.radius) <= one_circle;
}

class Finder {
 public:
  explicit Finder(const Toolpath& path) : path_(path) {}

  FullCircles found() {
    for (std::size_t i = 0; i < path_.segments.size(); ++i) {
      const Segment& segment = path_.segments[i];
      if (segment.kind == SegmentKind::arc && !segment.rapid) {
        add(i, segment);
      } else {
        close();
      }
    }
    close();
    return std::move(found_);
  }

 private:
  void add(std::size_t index, const Segment& segment) {
    const Arc& arc = path_.arc_of(segment);
    const Vec3 axis = arc.x.cross(arc.y).normalized();
    if (!turn_ || !goes_on(*turn_, arc, axis)) {
      close();
      begin(index, segment, arc, axis);
    }
    FullCircle& circle = turn_->circle;
    circle.last = index;
    circle.last_line = segment.line;
    circle.sweep += arc.sweep;
    circle.feed = std::max(circle.feed, segment.feed);
    turn_->sum_of_centers += arc.sweep * arc.center;
    turn_->sum_of_radii += arc.sweep * arc.radius;
  }

  void begin(std::size_t index, const Segment& segment, const Arc& arc, const Vec3& axis) {
    turn_.emplace();
    turn_->shape = shape_of(arc, axis);
    turn_->axis = axis;
    turn_->center = arc.center;
    turn_->radius = arc.radius;
    turn_->circle.first = index;
    turn_->circle.first_line = segment.line;
    if (const auto plane = plane_of(axis)) {
      const PlaneInfo& info = info_of(plane->first);
      turn_->circle.plane = plane->first;
      turn_->circle.counter_clockwise = plane->second;
      turn_->circle.start = std::atan2(arc.x[info.second_index], arc.x[info.first_index]);
    }
  }

  void close() {
    if (turn_ && is_whole(turn_->circle.sweep, turn_->radius)) {
      switch (turn_->shape) {
        case Shape::flat:
          turn_->circle.center = turn_->sum_of_centers / turn_->circle.sweep;
          turn_->circle.radius = turn_->sum_of_radii / turn_->circle.sweep;
          found_.circles.push_back(turn_->circle);
          break;
        case Shape::helix:
          ++found_.helices;
          break;
        case Shape::tilted:
          ++found_.tilted;
      }
    }
    turn_.reset();
  }

  static bool is_whole(double sweep, double radius) {
    constexpr double closed_angle = 0.01;
    return sweep >= full_turn - std::min(closed_angle, closed_circle / radius);
  }

  const Toolpath& path_;
  FullCircles found_;
  std::optional<Turn> turn_;
};

}  // namespace

FullCircles find_full_circles(const Toolpath& path) {
  return Finder(path).found();
}

bool is_same_circle(const FullCircle& a, const FullCircle& b) {
  constexpr double same_feed = 1e-9;  // [mm/s]
  return a.plane == b.plane && (a.center - b.center).norm() <= one_circle &&
         std::abs(a.radius - b.radius) <= one_circle && std::abs(a.feed - b.feed) <= same_feed;
}

}  // namespace feedscope

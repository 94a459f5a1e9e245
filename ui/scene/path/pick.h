#pragma once

#include <optional>
#include <vector>

#include "ui/scene/camera/projection.h"
#include "ui/scene/sampled_path.h"

namespace feedscope::ui {

/// Millimetres to display coordinates.
class ScreenMap {
 public:
  ScreenMap(const Projection& projection, const SceneFrame& frame);
  /// Display coordinates; third: towards the eye, in pixels at the focal point.
  Vec3 operator()(const Vec3& point) const;

  /// A rectangle that contains the projection of a box [mm].
  struct Rectangle {
    Vec2 low, high;
    double distance(const Vec2& place) const { return (place - place.cwiseMax(low).cwiseMin(high)).norm(); }
    bool touches(const Vec2& other_low, const Vec2& other_high) const {
      return (low.array() <= other_high.array()).all() && (high.array() >= other_low.array()).all();
    }
    bool within(const Vec2& other_low, const Vec2& other_high) const {
      return (low.array() >= other_low.array()).all() && (high.array() <= other_high.array()).all();
    }
  };
  Rectangle rectangle(const Vec3& low, const Vec3& high) const;

 private:
  Eigen::Matrix3d linear_;
  Vec3 offset_;
  Vec2 middle_;
  double eye_ = 0;  ///< distance from the focal point [pixels]; 0: parallel
};

/// A path as drawn, with the boxes for searching its spans.
struct PickablePath {
  const SampledPath* samples = nullptr;
  const std::vector<Eigen::Vector3f>* positions = nullptr;  ///< of the samples, as drawn
  const std::vector<SpanBox>* boxes = nullptr;              ///< boxes_of(*positions)
  std::optional<std::array<double, 2>> only = {};  ///< times at which it can be picked [s]; none: all
};

/// Time at which the path is nearest to `place`, if within `radius` [pixels]; of several passes less than a
/// pixel farther, the one in front. Searches the boxes, then the spans in near ones.
/// `trajectory`: if given, the search ends on the exact path instead of the span.
std::optional<double> nearest_time(const PickablePath& path, const Trajectory* trajectory,
                                   const ScreenMap& project, const Vec2& place, double radius);

/// First and last time at which the path is within a rectangle of the screen; none if it never is.
std::optional<std::array<double, 2>> times_within(const PickablePath& path, const ScreenMap& project,
                                                  const Vec2& low, const Vec2& high);

/// Value of the samples at a time, linear between two of them.
double value_at(const PickablePath& path, Colouring quantity, double time);
/// SampledPath::lost at a time; none without a comparison.
std::optional<double> lost_at(const PickablePath& path, double time);
Vec3 deviation_at(const PickablePath& path, double time);

/// Box around the path between two times [mm].
Bounds bounds_between(const PickablePath& path, double from, double to);

}  // namespace feedscope::ui

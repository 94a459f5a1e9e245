#pragma once

#include <optional>

#include "ui/scene/projection.h"
#include "ui/scene/sampled_path.h"

namespace feedscope::ui {

/// Millimetres to display coordinates, as one linear map; third: distance towards the eye, in pixels too.
struct MillimetreProjection {
  Eigen::Matrix3d linear;
  Vec3 offset;

  MillimetreProjection(const Projection& projection, const SceneFrame& frame);
  Vec3 operator()(const Vec3& point) const { return linear * point + offset; }
};

/// Time at which the executed path passes nearest to `place`, if within `radius` [pixels]; of several passes
/// less than a pixel farther, the one in front. Two passes over the samples, then a search on the exact path
/// between two of them.
std::optional<double> nearest_time(const SampledPath& samples, const Trajectory& trajectory,
                                   const MillimetreProjection& project, const Vec2& place, double radius);

}  // namespace feedscope::ui

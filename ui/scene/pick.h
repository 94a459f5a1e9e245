#pragma once

#include <optional>

#include "ui/scene/projection.h"
#include "ui/scene/sampled_path.h"

namespace feedscope::ui {

/// Millimetres to display coordinates, as one linear map.
struct MillimetreProjection {
  Eigen::Matrix<double, 2, 3> linear;
  Vec2 offset;

  MillimetreProjection(const Projection& projection, const SceneFrame& frame);
  Vec2 operator()(const Vec3& point) const { return linear * point + offset; }
};

/// Time at which the executed path passes nearest to `place`, if within `radius` [pixels]. One pass over the
/// samples, then a search on the exact path between the two nearest.
std::optional<double> nearest_time(const SampledPath& samples, const Trajectory& trajectory,
                                   const MillimetreProjection& project, const Vec2& place, double radius);

}  // namespace feedscope::ui

#include "ui/scene/pick.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace feedscope::ui {
namespace {

/// Where a span passes `place`.
struct Passage {
  double distance = 0;  ///< on the screen [pixels]
  double depth = 0;     ///< towards the eye [pixels]
};

Passage passage(const Vec2& place, const Vec3& from, const Vec3& to) {
  const Vec2 span = (to - from).head<2>();
  const double length = span.squaredNorm();
  const double u = length > 0 ? std::clamp((place - from.head<2>()).dot(span) / length, 0.0, 1.0) : 0.0;
  const Vec3 nearest = from + u * (to - from);
  return {(nearest.head<2>() - place).norm(), nearest.z()};
}

}  // namespace

MillimetreProjection::MillimetreProjection(const Projection& projection, const SceneFrame& frame) {
  linear << projection.right.transpose(), projection.up.transpose(), projection.towards.transpose();
  linear *= projection.scale / frame.unit;
  offset = Vec3::Zero();
  offset.head<2>() = projection.to_display(frame.to_scene(Vec3::Zero()));
}

std::optional<double> nearest_time(const SampledPath& samples, const Trajectory& trajectory,
                                   const MillimetreProjection& project, const Vec2& place, double radius) {
  if (samples.size() == 0) {
    return std::nullopt;
  }
  const std::size_t spans = std::max<std::size_t>(1, samples.size() - 1);
  const auto passage_of = [&](std::size_t i) {
    return passage(place, project(samples.position(i)),
                   project(samples.position(std::min(i + 1, samples.size() - 1))));
  };
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < spans; ++i) {
    least = std::min(least, passage_of(i).distance);
  }
  if (!(least <= radius)) {
    return std::nullopt;
  }
  std::size_t span = 0;
  Passage chosen{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i < spans; ++i) {
    const Passage p = passage_of(i);
    const bool in_front = p.depth > chosen.depth + 1;
    const bool level = std::abs(p.depth - chosen.depth) <= 1;
    if (p.distance <= least + 1 && (in_front || (level && p.distance < chosen.distance))) {
      chosen = p;
      span = i;
    }
  }
  // Within that pass, to where it comes nearest.
  while (span + 1 < spans && passage_of(span + 1).distance < passage_of(span).distance) {
    ++span;
  }
  while (span > 0 && passage_of(span - 1).distance < passage_of(span).distance) {
    --span;
  }
  double low = samples.times[span];
  double high = samples.times[std::min(span + 1, samples.size() - 1)];
  const auto distance_at = [&](double time) {
    return (project(trajectory.state(time).position).head<2>() - place).squaredNorm();
  };
  constexpr int rounds = 60;  // a third off each: 1e-10 of the span is left
  for (int i = 0; i < rounds; ++i) {
    const double a = low + (high - low) / 3;
    const double b = high - (high - low) / 3;
    if (distance_at(a) <= distance_at(b)) {
      high = b;
    } else {
      low = a;
    }
  }
  return (low + high) / 2;
}

}  // namespace feedscope::ui

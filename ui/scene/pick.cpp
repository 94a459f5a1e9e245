#include "ui/scene/pick.h"

#include <algorithm>

namespace feedscope::ui {
namespace {

double squared_distance(const Vec2& place, const Vec2& from, const Vec2& to) {
  const Vec2 span = to - from;
  const double length = span.squaredNorm();
  const double u = length > 0 ? std::clamp((place - from).dot(span) / length, 0.0, 1.0) : 0.0;
  return (from + u * span - place).squaredNorm();
}

}  // namespace

MillimetreProjection::MillimetreProjection(const Projection& projection, const SceneFrame& frame) {
  const double pixels = projection.scale / frame.unit;
  linear.row(0) = pixels * projection.right.transpose();
  linear.row(1) = pixels * projection.up.transpose();
  offset = projection.to_display(frame.to_scene(Vec3::Zero()));
}

std::optional<double> nearest_time(const SampledPath& samples, const Trajectory& trajectory,
                                   const MillimetreProjection& project, const Vec2& place, double radius) {
  if (samples.size() == 0) {
    return std::nullopt;
  }
  std::size_t nearest = 0;
  Vec2 from = project(samples.position(0));
  double best = (from - place).squaredNorm();
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const Vec2 to = project(samples.position(i));
    const double distance = squared_distance(place, from, to);
    if (distance < best) {
      best = distance;
      nearest = i - 1;
    }
    from = to;
  }
  if (best > radius * radius) {
    return std::nullopt;
  }
  double low = samples.times[nearest];
  double high = samples.times[std::min(nearest + 1, samples.size() - 1)];
  const auto distance_at = [&](double time) {
    return (project(trajectory.state(time).position) - place).squaredNorm();
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

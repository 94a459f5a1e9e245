#include "core/analysis/circularity/circle_pass.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace feedscope {
namespace {

using Eigen::Vector2d;

double angle_between(const Vector2d& from, const Vector2d& to) {
  return std::atan2(from.x() * to.y() - from.y() * to.x(), from.dot(to));
}

}  // namespace

CirclePass pass_between(const Run& run, const Bracket& time, const CircleFrame& frame) {
  const PlaneInfo& plane = info_of(frame.plane);
  const Trajectory& trajectory = *run.trajectory;
  CirclePass pass;
  pass.time = time.high - time.low;
  pass.places.reserve(circle_places);
  std::optional<ActualWalk> walk;
  if (run.sources.actual) {
    walk.emplace(run.sources.actual->response(), time.low);
  }
  double angle = 0;
  for (std::size_t k = 0; k < circle_places; ++k) {
    const double share = static_cast<double>(k) / static_cast<double>(circle_places - 1);
    const State state = trajectory.state(time.low + share * pass.time);
    const Vec3 at = (walk ? walk->at(state.time).position : state.position) - frame.center;
    pass.reached_feed = std::max(pass.reached_feed, state.speed);
    pass.places.push_back({at[plane.first_index], at[plane.second_index]});
    if (k > 0) {
      angle += angle_between(pass.places[k - 1], pass.places[k]);
    }
  }
  pass.evaluated = std::abs(angle);
  pass.circularity = circularity_of(pass.places, frame.radius);
  return pass;
}

}  // namespace feedscope

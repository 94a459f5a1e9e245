#include "core/models/ward/block_distances.h"

#include <cmath>

#include "core/trajectory/filtered_corner.h"

namespace feedscope {

template <typename F>
void BlockDistances::for_points_of_arc(std::size_t block, double step, double reach, F f) const {
  const double begin = train_.blocks[block].start;
  const double half = (train_.blocks[block + 1].start - begin) / 2;
  const double c = train_.half_delay();
  const auto at = [&](double t) { return f(train_.commanded(block, t), t + c); };
  for (double from_end = step; from_end < std::min(half, reach); from_end += step) {
    at(begin + from_end);
    at(begin + 2 * half - from_end);
  }
  at(begin + half);
}

double BlockDistances::of_arc(std::size_t block) {
  // Where an arc is near its tolerance, its ends are checked closely: there the neighbours add to the error
  // of the filters.
  constexpr double near_tolerance = 0.5;
  const double c = train_.half_delay();
  const double tolerance = pulses_.arc_tolerance(rules_, block);
  double largest = 0;
  const auto look = [&](double step, double reach) {
    for_points_of_arc(block, step, reach, [&](const Vec3& point, double time) {
      largest = std::max(largest, of_point(point, time, tolerance));
    });
  };
  const double half = (train_.blocks[block + 1].start - train_.blocks[block].start) / 2;
  look(std::min(c / 2, half / 2), 1.25 * c);
  if (largest > near_tolerance * tolerance && !exceeds(largest, tolerance)) {
    look(std::min(c / 8, half / 8), 2 * c);
  }
  return largest;
}

BlockDistance BlockDistances::of(std::size_t block) {
  BlockDistance distance;
  if (block > 0) {
    distance.corner =
        of_point(train_.programmed_point(block), train_.blocks[block].start + train_.half_delay(),
                 pulses_.corner_tolerance(rules_, block));
  }
  if (pulses_.is_arc(block)) {
    distance.arc = of_arc(block);
  }
  return distance;
}

double BlockDistances::of_point(const Vec3& point, double time, double tolerance) {
  constexpr double precision = 1e-4;  // of the distance squared
  const Kinematics at = walk_.motion_at(train_, time + lag_);
  const Vec3 offset = at.position - point;
  const double slope = offset.dot(at.velocity);
  const double curvature = at.velocity.squaredNorm() + offset.dot(at.acceleration);
  const double step = curvature > 0 ? -slope / curvature : 0;
  const double nearest = offset.squaredNorm() + slope * step;
  // Third and fourth order of the distance squared; at a reversal the third vanishes with the velocity.
  const double doubt = std::abs(at.velocity.dot(at.acceleration) * step * step * step) +
                       at.acceleration.squaredNorm() / 4 * step * step * step * step;
  if (curvature > 0 && std::abs(lag_ + step) < train_.filter_time / 4) {
    lag_ += step;
    const double allowed = tolerance * tolerance;
    const bool decided = !std::isfinite(allowed) || std::abs(nearest - allowed) > 2 * precision * allowed;
    // The jerk is in none of these terms: the gain of the step may be wrong by a tenth.
    const bool near = -slope * step <= 10 * precision * nearest;
    if (near && doubt <= precision * nearest && decided) {
      return std::sqrt(nearest);
    }
  } else {
    lag_ = 0;
  }
  return closest_approach(walk_, train_, point, time + lag_).distance;
}

}  // namespace feedscope

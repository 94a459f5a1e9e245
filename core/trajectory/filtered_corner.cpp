#include "core/trajectory/filtered_corner.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/blend/junction.h"
#include "core/trajectory/length_walk.h"

namespace feedscope {

Approach closest_approach(FilterWalk& walk, const PulseTrain& train, const Vec3& point, double time) {
  constexpr int newton_steps = 8;
  constexpr double precision = 1e-9;  // share of the squared distance below which another step is not worth
                                      // it
  const double longest_step = train.half_delay() / 2;
  Approach best;
  best.distance = std::numeric_limits<double>::infinity();
  for (int i = 0; i < newton_steps; ++i) {
    const Kinematics at = walk.motion_at(train, time);
    const Vec3 offset = at.position - point;
    const double squared = offset.squaredNorm();
    if (const double distance = std::sqrt(squared); distance < best.distance) {
      best = {distance, time, at};
    }
    const double slope = offset.dot(at.velocity);
    const double curvature = at.velocity.squaredNorm() + offset.dot(at.acceleration);
    if (!(curvature > 0) || slope * slope <= precision * curvature * squared) {
      break;
    }
    time += std::clamp(-slope / curvature, -longest_step, longest_step);
  }
  return best;
}

double corner_turn(const PulseTrain& train, std::size_t block) {
  if (block == 0) {
    return 0;
  }
  const std::size_t segment = train.first + block;
  return turn_angle(train.path->tangent_at_end(segment - 1), train.path->tangent_at_start(segment));
}

BlendRecord filtered_corner(FilterWalk& walk, const PulseTrain& train, std::size_t block) {
  const double middle = train.blocks[block].start + train.half_delay();
  const double before = train.widths(block - 1).right;
  const double after = train.widths(block).left;
  const Approach nearest = closest_approach(walk, train, train.programmed_point(block), middle);
  const double bend = nearest.motion.velocity.cross(nearest.motion.acceleration).norm();

  BlendRecord record;
  record.line = train.segment(block - 1).line;
  record.corner = train.programmed_point(block);
  record.turn = corner_turn(train, block);
  record.transition = train.blocks[block].corner_speed * std::max(before, after);
  record.epsilon = nearest.distance;
  record.min_radius = bend > 0 ? std::pow(nearest.motion.velocity.norm(), 3) / bend : 0;
  record.entry_speed = walk.velocity_at(train, middle - before).velocity.norm();
  record.length = LengthWalk(walk, train, middle - before).advance_to(middle + after);
  record.exit_speed = walk.velocity_at(train, middle + after).velocity.norm();
  return record;
}

}  // namespace feedscope

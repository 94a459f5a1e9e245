#include <algorithm>
#include <cmath>

#include "core/models/ward/short_blocks.h"
#include "core/models/ward/ward_runner.h"

namespace feedscope {
namespace {

// Where corners are dense their distance goes with the square of the speed. The later passes end what
// converges too slowly, at the latest by a stop in the corner.
constexpr double aim = 0.98;
constexpr double slack = 1e-6;
constexpr int careful_passes = 32;
constexpr int last_passes = 40;

// What check_ holds of a block. Most are settled after a few passes, but lie in the window of one that is
// not: only those that were lowered are looked at again at once, the others when these are settled.
constexpr char due = 1;
constexpr char lowered_last = 2;

double lowering_factor(double distance, double tolerance, int pass) {
  const double factor = std::sqrt(aim * tolerance / distance);
  return pass < careful_passes ? factor : std::min(factor, 0.5);
}

}  // namespace

void WardRunner::enforce_tolerance(ProgressSteps& steps) {
  check_.assign(train_.size(), due);
  distance_.assign(train_.size(), 0);
  slowed_.assign(train_.size(), 0);
  lag_ = 0;
  bool every = true;
  for (int pass = 0;; ++pass) {
    if (lower_blocks(pass, every, steps)) {
      cap_by_short_blocks(train_, corner_speeds_);
      mark_neighbours();
      lay_pulses(train_, limits_, corner_speeds_);
      walk_.forget();
      lag_ = 0;
      every = false;
    } else if (every) {
      return;
    } else {
      every = true;
    }
  }
}

bool WardRunner::lower_blocks(int pass, bool every, ProgressSteps& steps) {
  steps.at(train_.first);
  const char wanted = every ? due : due | lowered_last;
  bool any = false;
  for (std::size_t i = 0; i < train_.size(); ++i) {
    if ((check_[i] & wanted) == wanted) {
      const BlockDistance distance = distance_of_block(i);
      distance_[i] = distance.largest();
      const bool corner = lower_corner(i, distance.corner, pass);
      const bool arc = lower_arc(i, distance.arc, pass);
      check_[i] = corner || arc ? lowered_last : 0;
      any = any || corner || arc;
    }
  }
  return any;
}

bool WardRunner::lower_corner(std::size_t block, double distance, int pass) {
  if (block == 0 || corner_speeds_[block] == 0 || distance <= corner_tolerance(block) * (1 + slack)) {
    return false;
  }
  corner_speeds_[block] *= pass < last_passes ? lowering_factor(distance, corner_tolerance(block), pass) : 0;
  return true;
}

bool WardRunner::lower_arc(std::size_t block, double distance, int pass) {
  const bool stops_after = block + 1 == train_.size() || corner_speeds_[block + 1] == 0;
  if (corner_speeds_[block] == 0 && stops_after && pass >= last_passes) {
    return false;  // alone between two stops it keeps the tolerance by its limit
  }
  const double tolerance = arc_tolerance(block);
  if (distance <= tolerance * (1 + slack)) {
    return false;
  }
  const double factor = lowering_factor(distance, tolerance, pass);
  limits_[block] = {factor * train_.blocks[block].feed, {CauseKind::contour_tolerance}};
  slowed_[block] = 1;
  const double end_speed = pass < last_passes ? limits_[block].value : 0;
  corner_speeds_[block] = std::min(corner_speeds_[block], end_speed);
  if (block + 1 < train_.size()) {
    corner_speeds_[block + 1] = std::min(corner_speeds_[block + 1], end_speed);
  }
  return true;
}

void WardRunner::mark_neighbours() {
  const auto& blocks = train_.blocks;
  std::size_t unmarked = 0;
  for (std::size_t i = 0; i < train_.size(); ++i) {
    if (corner_speeds_[i] == blocks[i].corner_speed && !slowed_[i]) {
      continue;
    }
    // The pulses of this corner end within half of the delay; where its blocks are short their feeds change
    // too, from their other corners on.
    const double before = i > 0 ? std::max(blocks[i - 1].start, blocks[i].start - train_.delay()) : 0;
    const double after =
        slowed_[i] ? blocks[i + 1].start : std::min(blocks[i + 1].start, blocks[i].start + train_.delay());
    const double first = before - train_.delay();
    const double last = after + train_.delay();
    slowed_[i] = 0;
    for (std::size_t k = i; k > unmarked && blocks[k].start >= first; --k) {
      check_[k - 1] |= due;
    }
    std::size_t k = std::max(i, unmarked);
    for (; k < train_.size() && blocks[k].start <= last; ++k) {
      check_[k] |= due;
    }
    unmarked = k;
  }
}

template <typename F>
void WardRunner::for_points_of_arc(std::size_t block, double step, double reach, F f) const {
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

double WardRunner::distance_of_arc(std::size_t block) {
  // Where an arc is near its tolerance, its ends are looked at closely: there the neighbours add to what the
  // filters take off.
  constexpr double near_tolerance = 0.5;
  const double c = train_.half_delay();
  const double tolerance = arc_tolerance(block);
  double largest = 0;
  const auto look = [&](double step, double reach) {
    for_points_of_arc(block, step, reach, [&](const Vec3& point, double time) {
      largest = std::max(largest, distance_of(point, time, tolerance));
    });
  };
  const double half = (train_.blocks[block + 1].start - train_.blocks[block].start) / 2;
  look(std::min(c / 2, half / 2), 1.25 * c);
  if (largest > near_tolerance * tolerance && largest <= tolerance * (1 + slack)) {
    look(std::min(c / 8, half / 8), 2 * c);
  }
  return largest;
}

WardRunner::BlockDistance WardRunner::distance_of_block(std::size_t block) {
  BlockDistance distance;
  if (block > 0) {
    distance.corner = distance_of(train_.programmed_point(block),
                                  train_.blocks[block].start + train_.half_delay(), corner_tolerance(block));
  }
  if (is_arc(block)) {
    distance.arc = distance_of_arc(block);
  }
  return distance;
}

double WardRunner::distance_of(const Vec3& point, double time, double tolerance) {
  constexpr double precision = 1e-4;  // of the distance squared
  const Kinematics at = walk_.motion_at(train_, time + lag_);
  const Vec3 offset = at.position - point;
  const double slope = offset.dot(at.velocity);
  const double curvature = at.velocity.squaredNorm() + offset.dot(at.acceleration);
  const double step = curvature > 0 ? -slope / curvature : 0;
  const double nearest = offset.squaredNorm() + slope * step;
  // The third and fourth order of the distance squared; at a reversal the third vanishes with the velocity.
  const double doubt = std::abs(at.velocity.dot(at.acceleration) * step * step * step) +
                       at.acceleration.squaredNorm() / 4 * step * step * step * step;
  if (curvature > 0 && std::abs(lag_ + step) < train_.filter_time / 4) {
    lag_ += step;
    const double allowed = tolerance * tolerance;
    const bool decided = !std::isfinite(allowed) || std::abs(nearest - allowed) > 2 * precision * allowed;
    // The jerk is in no term of these: what the step wins may be wrong by a tenth.
    const bool near = -slope * step <= 10 * precision * nearest;
    if (near && doubt <= precision * nearest && decided) {
      return std::sqrt(nearest);
    }
  } else {
    lag_ = 0;
  }
  return closest_approach(walk_, train_, point, time + lag_).distance;
}

void WardRunner::measure_distances() {
  distance_.clear();
  for (std::size_t i = 0; i < train_.size(); ++i) {
    distance_.push_back(distance_of_block(i).largest());
  }
}

}  // namespace feedscope

#include "core/models/klipper/klipper_moves.h"

#include <algorithm>
#include <cmath>

namespace feedscope {

void KlipperMoves::add(const Vec3& direction, double length, double feed, Cause feed_cause,
                       const KlipperSettings& limits) {
  constexpr std::int8_t z = 2;
  KlipperMove move;
  move.length = length;
  move.acceleration = limits.max_acceleration;
  move.smooth_acceleration = limits.max_acceleration * (1 - limits.minimum_cruise_ratio);
  move.corner_deviation = limits.square_corner_velocity * limits.square_corner_velocity *
                          (std::sqrt(2.0) - 1) / limits.max_acceleration;
  move.top_cause = feed_cause;
  double top = feed;
  if (limits.max_velocity < top) {
    top = limits.max_velocity;
    move.top_cause = {CauseKind::path_velocity};
  }
  if (direction[z] != 0) {
    const double share = 1 / std::abs(direction[z]);
    if (limits.max_z_velocity * share < top) {
      top = limits.max_z_velocity * share;
      move.top_cause = {CauseKind::axis_velocity, z};
    }
    if (limits.max_z_acceleration * share < move.acceleration) {
      move.acceleration = limits.max_z_acceleration * share;
      move.z_acceleration = true;
    }
  }
  move.top_squared = top * top;
  moves_.push_back(move);
  limit_junction(direction);
  direction_ = direction;
}

void KlipperMoves::limit_junction(const Vec3& direction) {
  KlipperMove& move = moves_.back();
  if (moves_.size() == 1) {
    return;  // from rest
  }
  const KlipperMove& before = moves_[moves_.size() - 2];
  const double cosine = -direction.dot(direction_);
  const double sine = std::sqrt(std::max(0.5 * (1 - cosine), 0.0));
  const double half_cosine = std::sqrt(std::max(0.5 * (1 + cosine), 0.0));
  move.limit = move.top_squared;
  move.limit_cause = move.top_cause;
  const auto lower = [&](double squared, Cause cause) {
    if (squared < move.limit) {
      move.limit = squared;
      move.limit_cause = cause;
    }
  };
  lower(before.top_squared, before.top_cause);
  lower(before.limit + before.change(), {CauseKind::path_acceleration});
  if (sine < 1 && half_cosine > 0) {
    const Cause corner{CauseKind::square_corner_velocity};
    const double radius = sine / (1 - sine);
    const double tangent = sine / half_cosine;
    for (const KlipperMove* of : {&before, static_cast<const KlipperMove*>(&move)}) {
      lower(radius * of->corner_deviation * of->acceleration, corner);
      lower(of->change() * tangent / 4, corner);
    }
  }
  move.smooth_limit = std::min(move.limit, before.smooth_limit + before.smooth_change());
}

void KlipperMoves::plan() {
  plan_backward();
  plan_forward();
}

void KlipperMoves::plan_backward() {
  double next = 0;
  double next_smooth = 0;
  double peak = 0;
  int pending = 0;
  for (std::size_t i = moves_.size(); i-- > 0;) {
    KlipperMove& move = moves_[i];
    const double reach = next + move.change();
    const double change = move.smooth_change();
    const double reach_smooth = next_smooth + change;
    const double start_smooth = std::min(move.smooth_limit, reach_smooth);
    move.start = std::min(move.limit, reach);
    move.end = next;
    move.cruise = -1;
    ++pending;
    if (start_smooth < reach_smooth) {
      if (start_smooth + change > next_smooth || pending > 1) {
        peak = (start_smooth + reach_smooth) / 2;
      }
      move.cruise = std::min((move.start + reach) / 2, move.top_squared);
      move.below_peak = peak < move.cruise;
      move.cruise = std::min(move.cruise, peak);
      pending = 0;
    }
    next = move.start;
    next_smooth = start_smooth;
  }
}

void KlipperMoves::plan_forward() {
  double before = 0;
  for (std::size_t i = 0; i < moves_.size(); ++i) {
    KlipperMove& move = moves_[i];
    if (move.cruise < 0) {
      move.cruise = i == 0 ? move.start : std::min(before, move.start);
    }
    move.start = std::min(move.start, move.cruise);
    move.end = std::min(move.end, move.cruise);
    before = move.cruise;
  }
}

}  // namespace feedscope

#include "core/trajectory/filtered_motion.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace feedscope {

LengthWalk::LengthWalk(FilterWalk& walk, const PulseTrain& train, double t)
    : walk_(walk), train_(train), last_(sample(t)), middle_(last_) {}

SpeedSample LengthWalk::sample(double t) {
  const auto [velocity, acceleration] = walk_.velocity_at(train_, t);
  const double speed = velocity.norm();
  return {t, speed, speed > 0 ? acceleration.dot(velocity) / speed : 0};
}

SpeedSample LengthWalk::sample_at(double t) {
  return t == middle_.time ? middle_ : sample(t);
}

double LengthWalk::advance_to(double t) {
  constexpr double least_share = 1.0 / 16;  // many short polynomials are taken together
  constexpr double largest_share = 1.0 / 2;
  constexpr int deepest = 10;
  // A second [mm/s]; the jerk of two filters jumps where pulses begin.
  const double tolerance = (train_.filters == 2 ? 1e-8 : 1e-7) * train_.largest_feed;
  double sum = 0;
  while (last_.time < t) {
    const double knot = walk_.next_knot(train_, last_.time);
    const bool settled = walk_.is_settled();
    const double least = last_.time + least_share * train_.filter_time;
    const double most = last_.time + largest_share * train_.filter_time;
    const double until = std::min(t, settled ? knot : std::clamp(knot, least, most));
    const SpeedSample end = sample(until);
    if (settled) {
      sum += last_.speed * (until - last_.time);
    } else {
      const double duration = until - last_.time;
      middle_ = sample(last_.time + duration / 2);
      sum += between(last_, middle_, end, tolerance * duration, deepest);
    }
    last_ = end;
  }
  return sum;
}

double LengthWalk::between(const SpeedSample& from, const SpeedSample& middle, const SpeedSample& to,
                           double tolerance, int depth) {
  const double h = to.time - from.time;
  const double ends = from.speed + to.speed;
  const double slopes = from.slope - to.slope;
  const double fine = h * ((7 * ends + 16 * middle.speed) / 30 + h * slopes / 60);
  const double coarse = h * ((ends + 2 * middle.speed) / 4 + h * slopes / 48);
  if (std::abs(fine - coarse) <= tolerance || depth == 0) {
    return fine;
  }
  return between(from, sample(from.time + h / 4), middle, tolerance / 2, depth - 1) +
         between(middle, sample(from.time + 3 * h / 4), to, tolerance / 2, depth - 1);
}

FilteredMotion::FilteredMotion(double start, PulseTrain train, double contour_error)
    : start_(start), train_(std::move(train)), contour_error_(contour_error) {
  assert(train_.filters == 2 || train_.filters == 3);
  assert(train_.filter_time > 0 && train_.blocks.size() >= 2);
}

Kinematics FilteredMotion::at(double t) const {
  return FilterWalk().at(train_, t);
}

bool FilteredMotion::is_settled(double t0, double t1) const {
  const double oldest = t0 - delay();
  if (oldest < 0) {
    return false;
  }
  const std::size_t block = train_.block_at(oldest);
  if (block == train_.size() || train_.segment(block).kind == SegmentKind::arc) {
    return block == train_.size();
  }
  const PulseWidths widths = train_.widths(block);
  const double start = train_.blocks[block].start;
  if (oldest < start + widths.left) {
    return t1 <= start + widths.left;
  }
  const double right = train_.blocks[block + 1].start - widths.right;
  return t1 <= (oldest < right ? right : right + widths.right);
}

double FilteredMotion::length(double t0, double t1) const {
  FilterWalk walk;
  return LengthWalk(walk, train_, t0).advance_to(t1);
}

double FilteredMotion::time_at_length(double t0, double t1, double target) const {
  FilterWalk walk;
  double low = t0;
  double high = t1;
  double covered_to_low = 0;
  const double resolution = 1e-14 * (1 + t1);
  double t = (t0 + t1) / 2;
  for (int i = 0; i < 100 && high - low > resolution; ++i) {
    const double covered = covered_to_low + LengthWalk(walk, train_, low).advance_to(t);
    const double newton = t - (covered - target) / walk.velocity_at(train_, t).velocity.norm();
    if (covered < target) {
      low = t;
      covered_to_low = covered;
    } else {
      high = t;
    }
    if (std::abs(newton - t) <= resolution) {
      return t;
    }
    t = newton > low && newton < high ? newton : (low + high) / 2;
  }
  return high;
}

}  // namespace feedscope

#include "core/trajectory/filtered_motion.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace feedscope {
namespace {

/// (-1)^i C(n, i) for n = 2 and 3.
constexpr std::array<std::array<double, 4>, 2> binomials{{{1, -2, 1, 0}, {1, -3, 3, -1}}};

/// Nodes and weights of the 3-point Gauss-Legendre rule on [0, 1].
constexpr std::array<std::array<double, 2>, 3> gauss_rule{
    {{0.11270166537925831, 5.0 / 18}, {0.5, 8.0 / 18}, {0.88729833462074169, 5.0 / 18}}};

/// S_(n,n+1), S_(n,n), S_(n,n-1), S_(n,n-2) at one place.
struct StepResponse {
  double position = 0;
  double velocity = 0;
  double acceleration = 0;
  double jerk = 0;
};

StepResponse step_response(int filters, double u) {
  const auto& signs = binomials[static_cast<std::size_t>(filters - 2)];
  StepResponse response;
  for (int i = 0; i < filters && u >= i; ++i) {
    const double sign = signs[static_cast<std::size_t>(i)];
    const double w = u - i;
    const double lowest = filters == 2 ? 1 : w;
    const double second = filters == 2 ? w : w * w / 2;
    const double third = filters == 2 ? w * w / 2 : w * w * w / 6;
    response.jerk += sign * lowest;
    response.acceleration += sign * second;
    response.velocity += sign * third;
    response.position += sign * third * w / (filters + 1);
  }
  return response;
}

double velocity_response(int filters, double u) {
  const auto& signs = binomials[static_cast<std::size_t>(filters - 2)];
  double response = 0;
  for (int i = 0; i < filters && u >= i; ++i) {
    const double w = u - i;
    response += signs[static_cast<std::size_t>(i)] * (filters == 2 ? w * w / 2 : w * w * w / 6);
  }
  return response;
}

}  // namespace

FilteredMotion::FilteredMotion(int filters, double filter_time, double start, std::vector<Pulse> pulses)
    : filters_(filters),
      filter_time_(filter_time),
      delay_(filters * filter_time),
      start_(start),
      pulses_(std::move(pulses)) {
  assert(filters_ == 2 || filters_ == 3);
  assert(filter_time_ > 0 && pulses_.size() >= 2);
  for (const Pulse& pulse : pulses_) {
    largest_speed_ = std::max(largest_speed_, pulse.velocity.norm());
  }
}

std::size_t FilteredMotion::pulse_after(double t) const {
  const auto after = std::upper_bound(pulses_.begin(), pulses_.end(), t,
                                      [](double time, const Pulse& pulse) { return time < pulse.time; });
  return static_cast<std::size_t>(after - pulses_.begin());
}

Kinematics FilteredMotion::at(double t) const {
  const double oldest = t - delay_;
  std::size_t next = pulse_after(oldest);
  Kinematics motion{pulses_.front().position, Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
  if (next > 0) {
    const Pulse& first = pulses_[next - 1];
    motion.velocity = first.velocity;
    motion.position = first.position + first.velocity * (oldest - first.time + delay_ / 2);
  }
  Vec3 before = motion.velocity;
  for (; next < pulses_.size() && pulses_[next].time <= t; ++next) {
    const Vec3 step = pulses_[next].velocity - before;
    before = pulses_[next].velocity;
    const StepResponse response = step_response(filters_, (t - pulses_[next].time) / filter_time_);
    motion.position += step * (filter_time_ * response.position);
    motion.velocity += step * response.velocity;
    motion.acceleration += step * (response.acceleration / filter_time_);
    motion.jerk += step * (response.jerk / (filter_time_ * filter_time_));
  }
  return motion;
}

Vec3 FilteredMotion::velocity(double t) const {
  std::size_t next = pulse_after(t - delay_);
  Vec3 velocity = next > 0 ? pulses_[next - 1].velocity : Vec3(Vec3::Zero());
  Vec3 before = velocity;
  for (; next < pulses_.size() && pulses_[next].time <= t; ++next) {
    velocity += (pulses_[next].velocity - before) *
                velocity_response(filters_, (t - pulses_[next].time) / filter_time_);
    before = pulses_[next].velocity;
  }
  return velocity;
}

bool FilteredMotion::is_settled(double t0, double t1) const {
  const std::size_t next = pulse_after(t0 - delay_);
  return next > 0 && (next == pulses_.size() || pulses_[next].time >= t1);
}

double FilteredMotion::quadrature(double t0, double t1) const {
  double sum = 0;
  for (const auto& [node, weight] : gauss_rule) {
    sum += weight * velocity(t0 + node * (t1 - t0)).norm();
  }
  return sum * (t1 - t0);
}

double FilteredMotion::refined(double t0, double t1, double whole, double tolerance, int depth) const {
  const double middle = (t0 + t1) / 2;
  const double first = quadrature(t0, middle);
  const double second = quadrature(middle, t1);
  if (std::abs(first + second - whole) <= tolerance || depth == 0) {
    return first + second;
  }
  return refined(t0, middle, first, tolerance / 2, depth - 1) +
         refined(middle, t1, second, tolerance / 2, depth - 1);
}

double FilteredMotion::length(double t0, double t1) const {
  constexpr double relative_tolerance = 1e-9;
  constexpr int deepest = 10;
  double sum = 0;
  while (t0 < t1) {
    const std::size_t next = pulse_after(t0 - delay_);
    const double settled_until = next < pulses_.size() ? std::min(t1, pulses_[next].time) : t1;
    if (next > 0 && settled_until > t0) {
      sum += pulses_[next - 1].velocity.norm() * (settled_until - t0);
      t0 = settled_until;
      continue;
    }
    // Neighbouring polynomials are not taken together, unless many short ones are.
    double knot = t0 + filter_time_ / 2;
    for (int i = 0; i <= filters_; ++i) {
      const std::size_t pulse = pulse_after(t0 - i * filter_time_);
      if (pulse < pulses_.size()) {
        knot = std::min(knot, pulses_[pulse].time + i * filter_time_);
      }
    }
    const double until = std::min(t1, std::max(knot, t0 + filter_time_ / 16));
    const double whole = quadrature(t0, until);
    sum += refined(t0, until, whole, relative_tolerance * largest_speed_ * (until - t0), deepest);
    t0 = until;
  }
  return sum;
}

double FilteredMotion::time_at_length(double t0, double t1, double target) const {
  double low = t0;
  double high = t1;
  double covered_to_low = 0;
  const double resolution = 1e-14 * (1 + t1);
  double t = (t0 + t1) / 2;
  for (int i = 0; i < 100 && high - low > resolution; ++i) {
    const double covered = covered_to_low + length(low, t);
    const double newton = t - (covered - target) / velocity(t).norm();
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

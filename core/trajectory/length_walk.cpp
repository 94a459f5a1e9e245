#include "core/trajectory/length_walk.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/roots.h"

namespace feedscope {
namespace {

/// Sums of the samples of a step, from which the rules are easy to compute.
struct StepSums {
  double h;
  double ends;
  double slopes;
  explicit StepSums(const SpeedSample& from, const SpeedSample& to)
      : h(to.time - from.time), ends(from.speed + to.speed), slopes(from.slope - to.slope) {}
  double fine(double middle) const { return h * ((7 * ends + 16 * middle) / 30 + h * slopes / 60); }
  double coarse(double middle) const { return h * ((ends + 2 * middle) / 4 + h * slopes / 48); }
};

/// True if the polynomial of a step lies above -floor, by its control points.
bool is_above(const SpeedSample& from, const SpeedSample& middle, const SpeedSample& to, double floor) {
  const double h = to.time - from.time;
  const double second = from.speed + h * from.slope / 4;
  const double fourth = to.speed - h * to.slope / 4;
  const double third = (16 * middle.speed - from.speed - to.speed - 4 * (second + fourth)) / 6;
  return std::min({second, third, fourth}) >= -floor;
}

}  // namespace

LengthStep::LengthStep(const SpeedSample& from, const SpeedSample& middle, const SpeedSample& to)
    : start_(from.time),
      duration_(to.time - from.time),
      length_(std::max(0.0, StepSums(from, to).fine(middle.speed))) {
  const double slope = duration_ * from.slope;
  const double a = to.speed - from.speed - slope;
  const double b = duration_ * to.slope - slope;
  const double c = 16 * (middle.speed - from.speed - slope / 2);
  const double fourth = c - 8 * a + 2 * b;
  const double third = b - 2 * a - 2 * fourth;
  coefficients_ = {from.speed, slope, a - third - fourth, third, fourth};
}

LengthStep::LengthStep(double start, double duration, double length)
    : start_(start), duration_(duration), length_(length), coefficients_{length / duration, 0, 0, 0, 0} {}

double LengthStep::covered(double t) const {
  const double x = (t - start_) / duration_;
  const auto& w = coefficients_;
  const double sum = x * (w[0] + x * (w[1] / 2 + x * (w[2] / 3 + x * (w[3] / 4 + x * w[4] / 5))));
  return std::clamp(duration_ * sum, 0.0, length_);
}

double LengthStep::time_at(double target) const {
  const auto& w = coefficients_;
  const double x = rising_root({0, 1}, length_ > 0 ? target / length_ : 0, {}, [&](double at) {
    const double speed = w[0] + at * (w[1] + at * (w[2] + at * (w[3] + at * w[4])));
    return ValueAndSlope{covered(start_ + at * duration_) - target, duration_ * speed};
  });
  return start_ + x * duration_;
}

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

template <typename Visit>
void LengthWalk::advance_to(double t, const Visit& visit) {
  constexpr double min_share = 1.0 / 16;  // combines many short polynomials
  constexpr double largest_share = 1.0 / 2;
  constexpr int deepest = 10;
  // Per second [mm/s]; the jerk of two filters jumps where pulses begin.
  const double tolerance = (train_.filters == 2 ? 1e-8 : 1e-7) * train_.largest_feed;
  while (last_.time < t) {
    const double knot = walk_.next_knot(train_, last_.time);
    const bool settled = walk_.is_settled();
    const double least = last_.time + min_share * train_.filter_time;
    const double most = last_.time + largest_share * train_.filter_time;
    const double until = std::min(t, settled ? knot : std::clamp(knot, least, most));
    const double duration = until - last_.time;
    const SpeedSample end = sample(until);
    if (settled) {
      visit(LengthStep(last_.time, duration, last_.speed * duration));
    } else {
      middle_ = sample(last_.time + duration / 2);
      between(last_, middle_, end, tolerance * duration, deepest, visit);
    }
    last_ = end;
  }
}

double LengthWalk::advance_to(double t) {
  double sum = 0;
  advance_to(t, [&](const LengthStep& step) { sum += step.length(); });
  return sum;
}

template <typename Visit>
void LengthWalk::between(const SpeedSample& from, const SpeedSample& middle, const SpeedSample& to,
                         double tolerance, int depth, const Visit& visit) {
  const StepSums sums(from, to);
  const double fine = sums.fine(middle.speed);
  if (depth == 0) {
    visit(LengthStep(from.time, sums.h, std::max(0.0, fine)));
    return;
  }
  constexpr double rounding = 1e-9;  // of a speed that falls to a standstill
  if (std::abs(fine - sums.coarse(middle.speed)) <= tolerance &&
      is_above(from, middle, to, rounding * train_.largest_feed)) {
    visit(LengthStep(from, middle, to));
    return;
  }
  between(from, sample(from.time + sums.h / 4), middle, tolerance / 2, depth - 1, visit);
  between(middle, sample(from.time + 3 * sums.h / 4), to, tolerance / 2, depth - 1, visit);
}

double SpanCourse::share_at(double t) const {
  double whole = 0;
  double covered = 0;
  LengthWalk(walk_, train_, from_).advance_to(to_, [&](const LengthStep& step) {
    whole += step.length();
    if (step.end() <= t) {
      covered = whole;
    } else if (step.start() < t) {
      covered += step.covered(t);
    }
  });
  return whole > 0 ? std::min(covered / whole, 1.0) : (t - from_) / (to_ - from_);
}

double SpanCourse::time_at(double share) const {
  // Keeps the steps: those of a second walk could differ, since the filters remember their last time.
  std::vector<LengthStep> steps;
  double whole = 0;
  LengthWalk(walk_, train_, from_).advance_to(to_, [&](const LengthStep& step) {
    steps.push_back(step);
    whole += step.length();
  });
  if (!(whole > 0)) {
    return from_ + share * (to_ - from_);
  }
  const double target = share * whole;
  if (!(target > 0)) {
    return from_;
  }
  double covered = 0;
  for (const LengthStep& step : steps) {
    if (covered + step.length() >= target) {
      return step.time_at(target - covered);
    }
    covered += step.length();
  }
  return to_;
}

}  // namespace feedscope

#include "core/drives/arc_course.h"

#include <algorithm>
#include <cmath>

namespace feedscope {
namespace {

/// n over k, for the sums of the product rule over phi', phi'' and phi'''.
constexpr double binomial(std::size_t n, std::size_t k) {
  const auto m = static_cast<double>(n);
  return k == 0 ? 1 : k == 1 ? m : m * (m - 1) / 2;
}

constexpr double factorial(std::size_t n) {
  double product = 1;
  for (std::size_t k = 2; k <= n; ++k) {
    product *= static_cast<double>(k);
  }
  return product;
}

constexpr std::size_t short_degree = 4;
/// Above it, differences of positions would lose the digits needed for spans that match both ends [mm].
constexpr double largest_radius = 1e4;

}  // namespace

ArcCourse::ArcCourse(const Arc& arc, const Part& part, double tolerance)
    : arc_(arc), part_duration_(part.duration), duration_(part.duration) {
  const double rate = 1 / arc.length_per_radian();
  start_ = {rate * part.q, rate * part.v, rate * part.a, rate * part.j};
  const auto bound = bounds();
  const double allowed = tolerance / arc.radius;
  if (bound[short_degree + 1] * std::pow(duration_, short_degree + 1) <=
      allowed * factorial(short_degree + 1)) {
    degree_ = short_degree;
    return;
  }
  constexpr std::size_t next = order + 1;
  const double h = std::pow(allowed * factorial(next) / bound[next], 1.0 / next);
  if (duration_ <= h) {
    return;
  }
  meets_end_ = arc.radius <= largest_radius;
  duration_ = part_duration_ / std::ceil(part_duration_ / (meets_end_ ? 2 * h : h));
}

ArcCourse::Phase ArcCourse::phase_at(double tau) const {
  const LawPoint at = advance({start_[0], start_[1], start_[2], start_[3]}, tau);
  return {at.q, at.v, at.a, at.j};
}

/// Bounds of the derivatives of exp(i phi) on the part.
std::array<double, ArcCourse::order + 2> ArcCourse::bounds() const {
  const Phase end = phase_at(part_duration_);
  double speed = std::max(std::abs(start_[1]), std::abs(end[1]));
  if (start_[2] * end[2] < 0) {
    speed = std::max(speed, std::abs(phase_at(-start_[2] / start_[3])[1]));
  }
  const std::array<double, 3> largest{speed, std::max(std::abs(start_[2]), std::abs(end[2])),
                                      std::abs(start_[3])};
  std::array<double, order + 2> bound{1};
  for (std::size_t n = 0; n <= order; ++n) {
    for (std::size_t k = 0; k < std::min<std::size_t>(n + 1, 3); ++k) {
      bound[n + 1] += binomial(n, k) * largest[k] * bound[n - k];
    }
  }
  return bound;
}

ArcCourse::Turn ArcCourse::turn(const Phase& phase, std::size_t highest) {
  Turn turn;
  turn.re[0] = std::cos(phase[0]);
  turn.im[0] = std::sin(phase[0]);
  for (std::size_t n = 0; n < highest; ++n) {
    double re = 0;
    double im = 0;
    for (std::size_t k = 0; k < std::min<std::size_t>(n + 1, 3); ++k) {
      const double factor = binomial(n, k) * phase[k + 1];
      re += factor * turn.re[n - k];
      im += factor * turn.im[n - k];
    }
    turn.re[n + 1] = -im;
    turn.im[n + 1] = re;
  }
  return turn;
}

void ArcCourse::fill(SetSpan& span, double from) const {
  const Phase phase = phase_at(from);
  Turn turn = ArcCourse::turn(phase, meets_end_ ? SetCourse::met : degree_);
  if (meets_end_) {
    const Turn end = ArcCourse::turn(phase_at(from + duration_), SetCourse::met);
    const auto met = [](const SetCourse::Derivatives& all) {
      return std::array{all[0], all[1], all[2], all[3], all[4]};
    };
    meet_end(turn.re, met(end.re), duration_);
    meet_end(turn.im, met(end.im), duration_);
  }
  const Vec3 x = arc_.radius * arc_.x;
  const Vec3 y = arc_.radius * arc_.y;
  span.begin(arc_.center + phase[0] * arc_.rise + turn.re[0] * x + turn.im[0] * y, degree_, duration_);
  for (std::size_t k = 1; k <= degree_; ++k) {
    Vec3 value = turn.re[k] * x + turn.im[k] * y;
    if (k < phase.size()) {
      value += phase[k] * arc_.rise;
    }
    span.set_derivative(k, value);
  }
}

}  // namespace feedscope

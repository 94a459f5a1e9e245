#include "core/toolpath/gentle_blend.h"

#include <algorithm>
#include <cmath>

namespace feedscope {

std::optional<GentleBlend> GentleBlend::of(const CubicBlend& blend, double length) {
  constexpr double least_cosine = 0.9848;  // of 10 degrees
  constexpr double least_weight = 1.25;
  constexpr double largest_weight = 3;
  constexpr double rounding = 1e-9;
  const Vec3 in = blend.corner - blend.start;
  const Vec3 out = blend.end - blend.corner;
  const double square = in.squaredNorm();
  const bool even = std::abs(square - out.squaredNorm()) <= rounding * square;
  const bool gentle = in.dot(out) >= least_cosine * square;
  return even && gentle && blend.alpha >= least_weight && blend.alpha <= largest_weight && length > 0
             ? std::optional(GentleBlend(blend, length))
             : std::nullopt;
}

GentleBlend::GentleBlend(const CubicBlend& blend, double length) : half_(length / 2) {
  const CurvePoint middle = blend.at(0.5);
  powers_ = {middle.position, middle.d1 / 2, middle.d2 / 8, middle.d3 / 48};
  const Vec3& first = powers_[1];
  const Vec3& second = powers_[2];
  const Vec3& third = powers_[3];
  const Vec3 end_slope = first + 2 * second + 3 * third;
  const double end_speed = end_slope.norm();
  const double end_change = end_slope.dot(2 * second + 6 * third) / end_speed;
  // a + b + c + d = half, a + 3 b + 5 c + 7 d = end_speed, 6 b + 20 c + 42 d = end_change
  const double a = first.norm();
  const double p = end_speed - a;
  const double q = half_ - a;
  const double d = (end_change + 15 * q - 7 * p) / 8;
  const double c = (p - 3 * q) / 2 - 2 * d;
  odd_powers_ = {a, q - c - d, c, d};
  middle_rise_ = half_ / a - 1;
  end_rise_ = (1 - half_ / end_speed) / 2 - middle_rise_;
}

/// x at a path length, by one step of third order from a polynomial that has the slopes of middle and ends.
double GentleBlend::place_of(double s) const {
  const double from_middle = s - half_;
  if (!(std::abs(from_middle) < half_)) {
    return from_middle < 0 ? -1 : 1;
  }
  const double share = from_middle / half_;
  const double rest = 1 - share * share;
  const double x = share * (1 + rest * (middle_rise_ + end_rise_ * share * share));
  const auto& [a, b, c, d] = odd_powers_;
  const double square = x * x;
  const double missing = x * (a + square * (b + square * (c + square * d))) - from_middle;
  const double speed = a + square * (3 * b + square * (5 * c + square * 7 * d));
  const double change = x * (6 * b + square * (20 * c + square * 42 * d));
  return x - missing * speed / (speed * speed - missing * change / 2);
}

CurvePoint GentleBlend::at(double s) const {
  const double x = place_of(s);
  const auto& [place, first, second, third] = powers_;
  return by_path_length({place + x * (first + x * (second + x * third)),
                         first + x * (2 * second + 3 * x * third), 2 * second + 6 * x * third, 6 * third});
}

}  // namespace feedscope

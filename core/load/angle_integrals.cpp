#include "core/load/angle_integrals.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/units.h"

namespace feedscope {
namespace {

/// Gauss-Legendre rule with ten points on [-1, 1]: half of the symmetric points.
constexpr std::array<double, 5> points{0.1488743389816312, 0.4333953941292472, 0.6794095682990244,
                                       0.8650633666889845, 0.9739065285171717};
constexpr std::array<double, 5> weights{0.2955242247147529, 0.2692667193099964, 0.2190863625159820,
                                        0.1494513491505806, 0.0666713443086881};

/// Integral of sin^exponent from 0 to `angle`, at most pi/2. With x = t^4 the integrand begins as t^(4
/// exponent + 3), without the singular derivative of sin^exponent at 0.
double quadrature(double exponent, double angle) {
  constexpr int parts = 4;
  const double end = std::sqrt(std::sqrt(angle));
  double sum = 0;
  for (int part = 0; part < parts; ++part) {
    const double middle = end * (part + 0.5) / parts;
    const double half = end * 0.5 / parts;
    for (std::size_t i = 0; i < points.size(); ++i) {
      for (const double t : {middle - half * points[i], middle + half * points[i]}) {
        const double cube = t * t * t;
        sum += weights[i] * half * 4 * cube * std::pow(std::sin(cube * t), exponent);
      }
    }
  }
  return sum;
}

}  // namespace

AngleIntegrals::AngleIntegrals(double exponent) : exponent_(exponent) {
  if (exponent_ != 1) {
    half_power_ = quadrature(exponent_, units::pi / 2);
    half_sine_ = quadrature(exponent_ + 1, units::pi / 2);
  }
}

double AngleIntegrals::of_any_power(double exponent, double half, double angle) const {
  return angle <= units::pi / 2 ? quadrature(exponent, angle)
                                : 2 * half - quadrature(exponent, units::pi - angle);
}

double AngleIntegrals::power(double angle) const {
  const double sine = std::sin(angle);
  return sine <= 0 ? 0 : exponent_ == 1 ? sine : std::pow(sine, exponent_);
}

double AngleIntegrals::of_power(double angle) const {
  return exponent_ == 1 ? 1 - std::cos(angle) : of_any_power(exponent_, half_power_, angle);
}

double AngleIntegrals::of_power_times_sine(double angle) const {
  return exponent_ == 1 ? angle / 2 - std::sin(2 * angle) / 4
                        : of_any_power(exponent_ + 1, half_sine_, angle);
}

double AngleIntegrals::of_power_times_cosine(double angle) const {
  return power(angle) * std::max(0.0, std::sin(angle)) / (exponent_ + 1);
}

}  // namespace feedscope

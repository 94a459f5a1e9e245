#include "core/load/angle_integrals.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/units.h"

namespace feedscope {
namespace {

/// Of sin^exponent by Simpson's rule in many small steps; exact enough for exponents of 1 and more.
double simpson(double exponent, double angle) {
  constexpr int steps = 200000;
  double sum = 0;
  for (int i = 0; i <= steps; ++i) {
    const double value = std::pow(std::max(0.0, std::sin(angle * i / steps)), exponent);
    sum += value * (i == 0 || i == steps ? 1 : i % 2 == 1 ? 4 : 2);
  }
  return sum * angle / steps / 3;
}

TEST(AngleIntegrals, OfALinearLawAreThoseOfTheSine) {
  const AngleIntegrals integrals(1);
  EXPECT_DOUBLE_EQ(integrals.of_power(units::pi), 2);
  EXPECT_DOUBLE_EQ(integrals.of_power_times_sine(units::pi), units::pi / 2);
  EXPECT_NEAR(integrals.of_power_times_cosine(units::pi), 0, 1e-16);
  EXPECT_DOUBLE_EQ(integrals.of_power_times_cosine(units::pi / 2), 0.5);
}

/// From 0 to pi: sqrt(pi) Gamma((p + 1)/2)/Gamma(p/2 + 1).
TEST(AngleIntegrals, OfAHalfTurnAreTheBetaFunction) {
  for (const double q : {0.1, 0.5, 0.74, 0.86, 0.999}) {
    const AngleIntegrals integrals(q);
    const auto beta = [](double p) {
      return std::sqrt(units::pi) * std::tgamma((p + 1) / 2) / std::tgamma(p / 2 + 1);
    };
    EXPECT_NEAR(integrals.of_power(units::pi), beta(q), 1e-10) << q;
    EXPECT_NEAR(integrals.of_power_times_sine(units::pi), beta(q + 1), 1e-10) << q;
  }
}

TEST(AngleIntegrals, OfAnyAngleAreThoseOfSmallSteps) {
  const AngleIntegrals integrals(0.74);
  for (const double angle : {0.0, 0.01, 0.5, 1.5, 1.6, 2.9}) {
    EXPECT_NEAR(integrals.of_power_times_sine(angle), simpson(1.74, angle), 1e-9) << angle;
    const double step = 1e-5;
    if (angle > step) {
      const double slope = (integrals.of_power(angle + step) - integrals.of_power(angle - step)) / (2 * step);
      EXPECT_NEAR(slope, integrals.power(angle), 1e-6) << angle;
      const double turned =
          (integrals.of_power_times_cosine(angle + step) - integrals.of_power_times_cosine(angle - step)) /
          (2 * step);
      EXPECT_NEAR(turned, integrals.power(angle) * std::cos(angle), 1e-6) << angle;
    }
  }
}

}  // namespace
}  // namespace feedscope

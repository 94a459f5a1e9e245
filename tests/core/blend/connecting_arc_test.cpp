#include "core/blend/connecting_arc.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/base/units.h"

namespace feedscope {
namespace {

const Vec3 east(1, 0, 0);

Vec3 turned(double degrees) {
  const double angle = units::from_deg(degrees);
  return {std::cos(angle), std::sin(angle), 0};
}

TEST(ConnectingArc, OfTheInterpolationToleranceHasTheRadiiOfThePaper) {
  // Msaddek 2011, section 3.2.3: TIT 4 um gives radii of 1.9 to 11 um (models/msaddek/README.md: 129 to 40
  // degrees).
  const auto radius = [](double degrees) {
    return connecting_arc({0, 0, 0}, east, turned(degrees), 100, 0.004).arc.radius;
  };
  EXPECT_NEAR(radius(129), 0.0019, 0.00005);
  EXPECT_NEAR(radius(40), 0.011, 0.00005);
  EXPECT_NEAR(radius(90), 0.004, 1e-15);
}

TEST(ConnectingArc, RunsFromOneBlockToTheOtherWithoutAKink) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto direction = [&] { return Vec3(unit(random), unit(random), unit(random)).normalized(); };
  for (int i = 0; i < 200; ++i) {
    const Vec3 corner = 100 * direction();
    const Vec3 in = direction();
    const Vec3 out = direction();
    const ConnectingArc c = connecting_arc(corner, in, out, 10, 0.05);
    const CurvePoint start = c.arc.at(0);
    const CurvePoint end = c.arc.at(c.arc.length());
    EXPECT_LT((start.position - (corner - c.transition * in)).norm(), 1e-12);
    EXPECT_LT((end.position - (corner + c.transition * out)).norm(), 1e-12);
    EXPECT_LT((start.d1 - in).norm(), 1e-9);
    EXPECT_LT((end.d1 - out).norm(), 1e-9);
    EXPECT_NEAR((c.arc.at(c.arc.length() / 2).position - corner).norm(), c.epsilon, 1e-12);
    EXPECT_LE(c.epsilon, 0.05);
  }
}

TEST(ConnectingArc, OfShortBlocksIsTheSecondTermOfEquation1) {
  // b = 90 degrees: R = T = L/2 - TIT
  EXPECT_NEAR(connecting_arc({0, 0, 0}, east, turned(90), 0.025, 0.007).arc.radius, 0.0055, 1e-15);
}

TEST(ConnectingArc, OfVeryShortBlocksTakesAnEighthOfThem) {
  for (const double length : {0.018, 0.01, 1e-6}) {
    EXPECT_NEAR(connecting_arc({0, 0, 0}, east, turned(90), length, 0.007).transition, length / 8, 1e-15);
  }
}

}  // namespace
}  // namespace feedscope

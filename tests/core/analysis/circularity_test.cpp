#include "core/analysis/circularity/circularity.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace feedscope {
namespace {

using Eigen::Vector2d;

template <class Radius>
std::vector<Vector2d> places(const Vector2d& center, Radius radius, int count = 720) {
  std::vector<Vector2d> all;
  for (int i = 0; i < count; ++i) {
    const double a = 2 * std::numbers::pi * i / count;
    all.push_back(center + radius(a) * Vector2d(std::cos(a), std::sin(a)));
  }
  return all;
}

TEST(Circularity, OfAShiftedCircleIsNothingButItsRadialErrorsAreTheShift) {
  const Vector2d center(0.02, -0.01);
  const Circularity found = circularity_of(places(center, [](double) { return 30.05; }), 30);
  EXPECT_NEAR(found.zone, 0, 1e-9);
  EXPECT_NEAR(found.by_squares, 0, 1e-9);
  EXPECT_LT((found.zone_center - center).norm(), 1e-8);
  EXPECT_LT((found.squares_center - center).norm(), 1e-9);
  EXPECT_NEAR(found.largest, 0.05 + center.norm(), 1e-6);
  EXPECT_NEAR(found.smallest, 0.05 - center.norm(), 1e-6);
  EXPECT_NEAR(found.mean_radius, 30.05, 1e-4);
}

// r = R + a cos 2t has two equal highs and lows: no centre is better than the origin.
TEST(Circularity, OfAnOvalIsTwiceItsAmplitude) {
  const Circularity found =
      circularity_of(places({0, 0}, [](double a) { return 30 + 0.01 * std::cos(2 * a); }), 30);
  EXPECT_NEAR(found.zone, 0.02, 1e-8);
  EXPECT_NEAR(found.by_squares, 0.02, 1e-8);
  EXPECT_NEAR(found.largest, 0.01, 1e-12);
  EXPECT_NEAR(found.smallest, -0.01, 1e-12);
}

/// One bump: the least-squares centre is drawn towards it, the zone has a narrower one.
TEST(Circularity, ZoneIsNeverWiderThanAboutAnyOtherCentre) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int i = 0; i < 10; ++i) {
    const double at = 3 * unit(random);
    const double width = 0.3 + 0.2 * unit(random);
    const double slope = 0.005 * unit(random);
    const auto all = places({0.01 * unit(random), 0.01 * unit(random)}, [&](double a) {
      return 20 + 0.03 * std::exp(-std::pow(std::remainder(a - at, 2 * std::numbers::pi) / width, 2)) +
             slope * std::cos(3 * a);
    });
    const Circularity found = circularity_of(all, 20);
    EXPECT_LE(found.zone, found.by_squares + 1e-12);
    const auto separation = [&](const Vector2d& center) {
      double least = 1e9;
      double most = 0;
      for (const Vector2d& place : all) {
        least = std::min(least, (place - center).norm());
        most = std::max(most, (place - center).norm());
      }
      return most - least;
    };
    for (int k = 0; k < 400; ++k) {
      const double reach = std::pow(10, -2 - 2 * (unit(random) + 1));
      const Vector2d near = found.zone_center + reach * Vector2d(unit(random), unit(random));
      ASSERT_GE(separation(near), found.zone - 2e-9);
    }
  }
}

TEST(Circularity, PartOfACircleIsTakenAsItIs) {
  std::vector<Vector2d> half;
  for (int i = 0; i <= 180; ++i) {
    const double a = std::numbers::pi * i / 180;
    half.push_back(Vector2d(0.005, 0) + 10 * Vector2d(std::cos(a), std::sin(a)));
  }
  EXPECT_NEAR(circularity_of(half, 10).zone, 0, 1e-8);
}

TEST(Circularity, NeedsThreePlaces) {
  EXPECT_THROW(circularity_of(std::vector<Vector2d>{{1, 0}, {0, 1}}, 1), std::invalid_argument);
}

}  // namespace
}  // namespace feedscope

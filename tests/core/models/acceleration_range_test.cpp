#include "core/models/optimal/acceleration_range.h"

#include <gtest/gtest.h>

#include <random>

namespace feedscope {
namespace {

/// Tangent and curvature vector over limits of 1: what an axis asks is |t u + c x| <= 1.
struct Place {
  Vec3 t;
  Vec3 c;
  AccelerationRange range;

  Place(const Vec3& tangent, const Vec3& curvature)
      : t(tangent), c(curvature), range(tangent, tangent, curvature) {}
  double share(double u, double x) const { return (t * u + c * x).cwiseAbs().maxCoeff(); }
};

Place random_place(std::mt19937& random) {
  std::uniform_real_distribution<double> any(-1, 1);
  Vec3 tangent = Vec3(any(random), any(random), any(random)).normalized();
  if (random() % 4 == 0) {
    tangent[static_cast<int>(random() % 3)] = 0;  // an axis across the path
    tangent.normalize();
  }
  const Vec3 normal = tangent.cross(Vec3(any(random), any(random), any(random))).normalized();
  return {tangent, std::pow(10, 2 * any(random)) * normal};
}

/// Largest f(x) among many x in [0, most].
template <typename F>
double largest_of(double most, const F& f) {
  double largest = f(0);
  for (int k = 1; k <= 4000; ++k) {
    largest = std::max(largest, f(most * k / 4000));
  }
  return largest;
}

TEST(AccelerationRange, IsWhereNoAxisExceedsItsLimit) {
  std::mt19937 random(5);
  for (int i = 0; i < 500; ++i) {
    const Place place = random_place(random);
    const double most = place.range.largest_x().value;
    ASSERT_LE(most, 1e9);
    for (const double share : {0.0, 0.3, 0.99}) {
      const double x = share * most;
      ASSERT_LT(place.range.lowest(x), place.range.highest(x));
      ASSERT_NEAR(place.share(place.range.lowest(x), x), 1, 1e-6);
      ASSERT_NEAR(place.share(place.range.highest(x), x), 1, 1e-6);
    }
    const double above = most * (1 + 1e-6);
    const double middle = (place.range.lowest(above) + place.range.highest(above)) / 2;
    ASSERT_GT(place.share(middle, above), 1) << "place " << i;
  }
}

TEST(AccelerationRange, ReachesThroughACellAsFarAsItsLinesSay) {
  std::mt19937 random(6);
  std::uniform_real_distribution<double> exponent(-3, 1);
  for (int i = 0; i < 300; ++i) {
    const AccelerationRange range = random_place(random).range;
    const double most = range.largest_x().value;
    const double length = std::pow(10, exponent(random));
    const double least = -1e-3 * (most + length);
    const double back = range.reach_back(most, length);
    const double sampled = largest_of(most, [&](double x) { return x - length * range.lowest(x); });
    ASSERT_GE(back, sampled - 1e-9 * std::abs(sampled)) << "place " << i;
    ASSERT_LE(back, sampled + 2e-3 * (std::abs(sampled) + most)) << "place " << i;

    const double begin = range.begin_back(back / 2, length);
    ASSERT_LE(begin, most);
    if (begin < most && begin > 0) {
      ASSERT_NEAR(begin + length * range.lowest(begin), back / 2, -least) << "place " << i;
    }
    const double on = range.reach_on(back / 2, length);
    ASSERT_LE(on, most);
    if (on < most && on > 0) {
      ASSERT_NEAR(on - length * range.highest(on), back / 2, -least) << "place " << i;
    }
  }
}

TEST(CommonRange, AllowsWhatAllOfThreePlacesAllow) {
  std::mt19937 random(7);
  for (int i = 0; i < 500; ++i) {
    const AccelerationRange a = random_place(random).range;
    const AccelerationRange b = random_place(random).range;
    const AccelerationRange c = random_place(random).range;
    CommonRange common(a, b, c);
    const double most = common.largest_x().value;
    for (const double share : {0.0, 0.5, 1.0}) {
      const double x = share * most;
      ASSERT_DOUBLE_EQ(common.lowest(x), std::max({a.lowest(x), b.lowest(x), c.lowest(x)}));
      ASSERT_DOUBLE_EQ(common.highest(x), std::min({a.highest(x), b.highest(x), c.highest(x)}));
      ASSERT_LE(common.lowest(x), common.highest(x) + 1e-9 * std::abs(common.highest(x)));
    }
    const double above = most * (1 + 1e-6);
    const double largest = std::min({a.largest_x().value, b.largest_x().value, c.largest_x().value});
    ASSERT_TRUE(above > largest || common.lowest(above) > common.highest(above)) << "place " << i;
    const double highest = common.highest(0);
    common.tighten(0.9);
    ASSERT_DOUBLE_EQ(common.largest_x().value, 0.9 * most);
    ASSERT_DOUBLE_EQ(common.highest(0), 0.9 * highest);
  }
}

}  // namespace
}  // namespace feedscope

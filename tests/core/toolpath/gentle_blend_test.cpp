#include "core/toolpath/gentle_blend.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/blend/corner.h"

namespace feedscope {
namespace {

constexpr double degree = std::numbers::pi / 180;

CubicBlend turning(double degrees, double alpha, double transition = 0.04) {
  const Vec3 in = Vec3(2, -1, 0.5).normalized();
  const Vec3 across = in.cross(Vec3(0.3, 0.2, 1)).normalized();
  const double turn = degrees * degree;
  return corner_blend({100, 2, 3}, in, std::cos(turn) * in + std::sin(turn) * across, transition, alpha);
}

TEST(GentleBlend, IsWhereTheExactOneIs) {
  constexpr int places = 40;
  for (const double alpha : {1.25, 1.5, 2.0, 2.5, 3.0}) {
    for (const double degrees : {0.001, 0.1, 1.0, 3.0, 9.9}) {
      SCOPED_TRACE(testing::Message() << alpha << ", " << degrees);
      const CubicBlend blend = turning(degrees, alpha);
      const double length = blend.length();
      const auto gentle = GentleBlend::of(blend, length);
      ASSERT_TRUE(gentle.has_value());
      double bend = 0;
      double change = 0;
      for (int i = 0; i <= places; ++i) {
        const CurvePoint exact = by_path_length(blend.at(static_cast<double>(i) / places));
        bend = std::max(bend, exact.d2.norm());
        change = std::max(change, exact.d3.norm());
      }
      for (int i = 0; i <= places; ++i) {
        const double s = length * i / places;
        const CurvePoint exact = by_path_length(blend.at(blend.parameter_at(s)));
        const CurvePoint near = gentle->at(s);
        EXPECT_LE((near.position - exact.position).norm(), 6e-6 * length);
        EXPECT_LE((near.d1 - exact.d1).norm(), 2e-6);
        EXPECT_LE((near.d2 - exact.d2).norm(), 3e-5 * bend);
        EXPECT_LE((near.d3 - exact.d3).norm(), 3e-5 * change);
      }
    }
  }
}

TEST(GentleBlend, IsClampedToItsEnds) {
  const CubicBlend blend = turning(5, 2.5);
  const auto gentle = GentleBlend::of(blend, blend.length());
  EXPECT_LE((gentle->at(-1).position - blend.start).norm(), 1e-12);
  EXPECT_LE((gentle->at(1).position - blend.end).norm(), 1e-12);
}

TEST(GentleBlend, IsNoneWhereItWouldNotBeNear) {
  EXPECT_FALSE(GentleBlend::of(turning(12, 2.5), 0.08).has_value());
  EXPECT_FALSE(GentleBlend::of(turning(5, 3.2), 0.08).has_value());
  EXPECT_FALSE(GentleBlend::of(turning(5, 1.2), 0.08).has_value());
  CubicBlend uneven = turning(5, 2.5);
  uneven.end = uneven.corner + 1.01 * (uneven.end - uneven.corner);
  EXPECT_FALSE(GentleBlend::of(uneven, uneven.length()).has_value());
}

}  // namespace
}  // namespace feedscope

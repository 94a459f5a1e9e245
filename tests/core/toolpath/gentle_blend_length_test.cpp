#include "core/toolpath/gentle_blend_length.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/blend/corner.h"

namespace feedscope {
namespace {

TEST(GentleBlendLengthTest, IsThatOfTheQuadratureForEveryWeightAndGentleTurn) {
  int gentle = 0;
  for (const double alpha : {0.1, 0.5, 1.0, 2.0, 2.5, 3.0, 3.5, 3.9}) {
    const GentleBlendLength length(alpha);
    for (const double turn : {1e-6, 1e-3, 0.01, 0.1, 0.2, 0.3, 0.4, 0.44}) {
      const Vec3 in = Vec3::UnitX();
      const Vec3 out(std::cos(turn), std::sin(turn), 0);
      const double h = (out - in).squaredNorm() / 2;
      constexpr double transition = 0.3;
      const auto over_transition = length.over_transition(h);
      ASSERT_TRUE(over_transition.has_value()) << turn;
      const double expected = corner_blend({1, 2, 3}, in, out, transition, alpha).length();
      EXPECT_NEAR(transition * *over_transition, expected, 2e-13 * expected) << alpha << ", " << turn;
      ++gentle;
    }
  }
  EXPECT_EQ(gentle, 64);
}

TEST(GentleBlendLengthTest, IsTheChordOfAStraightOneAndNothingForAWideTurn) {
  const GentleBlendLength length(2.5);
  EXPECT_NEAR(*length.over_transition(0), 2, 1e-15);
  EXPECT_FALSE(length.over_transition(0.11).has_value());
}

}  // namespace
}  // namespace feedscope

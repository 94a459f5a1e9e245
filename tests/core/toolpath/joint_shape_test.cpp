#include "core/toolpath/joint_shape.h"

#include <gtest/gtest.h>

#include <cmath>

namespace feedscope {
namespace {

struct Reach {
  double before;
  double behind;
};

class JointShapes : public testing::TestWithParam<Reach> {
 protected:
  Series at(double away) const { return joint_shape(GetParam().before, GetParam().behind, away); }
  /// The slope of the angle: 0 before the place and 1 behind it, and what the shape adds.
  double slope(double away) const { return (std::signbit(away) ? 0 : 1) + at(away).d1(); }
};

TEST_P(JointShapes, JoinSmoothlyAtThePlaceAndAtBothEnds) {
  EXPECT_NEAR(at(-0.0).value(), at(0.0).value(), 1e-15);
  EXPECT_NEAR(slope(-0.0), slope(0.0), 1e-14);
  EXPECT_NEAR(at(-0.0).d2(), at(0.0).d2(), 1e-12);
  for (const double end : {-GetParam().before, GetParam().behind}) {
    EXPECT_EQ(at(end).value(), 0);
    EXPECT_EQ(at(end).d1(), 0);
    EXPECT_EQ(at(end).d2(), 0);
    EXPECT_NE(at(end).d3(), 0) << "an end belongs to the reach";
    EXPECT_EQ(at(1.001 * end).d3(), 0);
  }
}

/// Against sums of small steps from one end to the other.
TEST_P(JointShapes, AreTheIntegralsOfTheirDerivatives) {
  constexpr int steps = 40000;
  const auto [before, behind] = GetParam();
  const double h = (before + behind) / steps;
  double angle = 0;
  double turned = 0;
  for (int i = 0; i < steps; ++i) {
    const double middle = -before + (i + 0.5) * h;
    const double end = middle + h / 2;
    turned += at(middle).d2() * h;
    angle += slope(middle) * h;
    ASSERT_NEAR(turned, slope(end), 1e-4) << end;
    ASSERT_NEAR(angle, std::max(0.0, end) + at(end).value(), 1e-4) << end;
  }
}

TEST_P(JointShapes, BendToOneSideOnlyAndTurnTheThirdDerivativeEvenly) {
  const auto [before, behind] = GetParam();
  for (const auto& [from, to] : {std::pair(-before, -0.0), std::pair(0.0, behind)}) {
    for (const double share : {0.1, 0.25, 0.5, 0.8}) {
      const double away = from + share * (to - from);
      EXPECT_GT(at(away).d2(), 0) << away;
      EXPECT_NEAR(at(away).d3(), (1 - share) * at(from).d3() + share * at(to).d3(), 1e-9) << away;
    }
  }
}

TEST_P(JointShapes, AreTheSameBackwards) {
  const auto [before, behind] = GetParam();
  for (const double share : {0.0, 0.3, 0.9}) {
    EXPECT_NEAR(joint_shape(behind, before, -share * behind).value(), at(share * behind).value(), 1e-15);
    EXPECT_NEAR(joint_shape(behind, before, -share * behind).d2(), at(share * behind).d2(), 1e-12);
  }
}

INSTANTIATE_TEST_SUITE_P(Reaches, JointShapes,
                         testing::Values(Reach{1.3, 1.3}, Reach{1, 1.01}, Reach{0.1, 0.2}, Reach{2, 1},
                                         Reach{0.7, 0.9}));

TEST(JointShape, OfEqualReachesIsACubicThatLeansByASixthOfThem) {
  const double reach = 0.6;
  EXPECT_NEAR(joint_shape(reach, reach, 0).value(), reach / 6, 1e-15);
  EXPECT_NEAR(joint_shape(reach, reach, 0).d2(), 1 / reach, 1e-12);
  for (const double away : {-0.5, -0.1, 0.2, 0.55}) {
    const double t = 1 - std::abs(away) / reach;
    EXPECT_NEAR(joint_shape(reach, reach, away).value(), reach * t * t * t / 6, 1e-15);
  }
}

TEST(JointTurn, IsTheShapeTimesTheStepOfItsAxis) {
  TurnJoint joint;
  joint.step = {0, -0.3, 0.2};
  EXPECT_EQ(joint_turn(joint, 2, 0).d2(), 0) << "it reaches nowhere";
  joint.before = 0.5;
  joint.behind = 0.7;
  EXPECT_EQ(joint_turn(joint, 0, 0.1).value(), 0);
  EXPECT_DOUBLE_EQ(joint_turn(joint, 1, 0.1).d1(), -0.3 * joint_shape(0.5, 0.7, 0.1).d1());
  EXPECT_DOUBLE_EQ(joint_turn(joint, 2, -0.2).d3(), 0.2 * joint_shape(0.5, 0.7, -0.2).d3());
}

}  // namespace
}  // namespace feedscope

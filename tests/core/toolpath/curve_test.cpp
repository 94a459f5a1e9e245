#include "core/toolpath/curve.h"
#include "core/base/units.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/toolpath/blend_length.h"

namespace feedscope {
namespace {

using units::pi;

/// Each derivative is the slope of the one below, by central differences with one Richardson step.
template <typename Curve>
void expect_derivatives(const Curve& curve, double parameter, double step, double tolerance) {
  using Member = Vec3 CurvePoint::*;
  constexpr std::array<std::pair<Member, Member>, 3> pairs{{{&CurvePoint::position, &CurvePoint::d1},
                                                            {&CurvePoint::d1, &CurvePoint::d2},
                                                            {&CurvePoint::d2, &CurvePoint::d3}}};
  for (const auto& [below, above] : pairs) {
    const auto slope = [&, low = below](double h) -> Vec3 {
      return (curve.at(parameter + h).*low - curve.at(parameter - h).*low) / (2 * h);
    };
    const Vec3 extrapolated = (4 * slope(step / 2) - slope(step)) / 3;
    const Vec3 exact = curve.at(parameter).*above;
    EXPECT_LT((extrapolated - exact).norm(), tolerance * (1 + exact.norm())) << "at parameter " << parameter;
  }
}

Arc quarter_circle() {
  return {Vec3(5, 0, 2), Vec3::UnitX(), Vec3::UnitY(), Vec3::Zero(), 10, pi / 2};
}

/// Symmetric about the bisector: both legs `leg` long, direction change `turn` in the plane XY.
CubicBlend blend(double leg, double turn) {
  const Vec3 out(std::cos(turn), std::sin(turn), 0);
  return {Vec3(-leg, 0, 0), Vec3::Zero(), leg * out, 2.5};
}

TEST(Arc, StartsEndsAndTurnsLikeAQuarterCircle) {
  const Arc arc = quarter_circle();
  EXPECT_NEAR(arc.length(), 10 * pi / 2, 1e-12);
  EXPECT_LT((arc.at(0).position - Vec3(15, 0, 2)).norm(), 1e-12);
  EXPECT_LT((arc.at(arc.length()).position - Vec3(5, 10, 2)).norm(), 1e-12);
  EXPECT_LT((arc.at(0).d1 - Vec3::UnitY()).norm(), 1e-12);
  EXPECT_LT((arc.at(0).d2 - Vec3(-0.1, 0, 0)).norm(), 1e-12) << "curvature 1/10 towards the centre";
  EXPECT_NEAR(arc.curvature(), 0.1, 1e-15);
}

TEST(Arc, HelixHasUnitSpeedAndThePythagoreanLength) {
  Arc helix = quarter_circle();
  helix.sweep = 4 * pi;
  helix.rise = Vec3(0, 0, 3 / (2 * pi));  // 3 mm a turn
  EXPECT_NEAR(helix.length(), 2 * std::hypot(20 * pi, 3), 1e-10);
  for (const double share : {0.0, 0.3, 0.77, 1.0}) {
    const CurvePoint point = helix.at(share * helix.length());
    EXPECT_NEAR(point.d1.norm(), 1, 1e-12);
    EXPECT_NEAR(point.d2.norm(), helix.curvature(), 1e-12);
    EXPECT_NEAR(point.position.z(), 2 + 6 * share, 1e-12);
  }
}

TEST(Arc, DerivativesAgreeWithFiniteDifferences) {
  Arc helix = quarter_circle();
  helix.rise = Vec3(0, 0, 0.8);
  for (const double share : {0.1, 0.5, 0.9}) {
    expect_derivatives(helix, share * helix.length(), 0.05, 1e-9);
  }
}

TEST(CubicBlend, MeetsEndsWithTheDirectionsOfItsLegs) {
  const CubicBlend curve = blend(2, 1.1);
  EXPECT_EQ(curve.at(0).position, curve.start);
  EXPECT_LT((curve.at(1).position - curve.end).norm(), 1e-14);
  EXPECT_LT((curve.at(0).d1 - 2.5 * (curve.corner - curve.start)).norm(), 1e-14);
  EXPECT_LT((curve.at(1).d1 - 2.5 * (curve.end - curve.corner)).norm(), 1e-14);
}

TEST(CubicBlend, DerivativesAgreeWithFiniteDifferences) {
  for (const double turn : {0.2, 1.5, 3.0}) {
    for (const double u : {0.1, 0.5, 0.8}) {
      expect_derivatives(blend(1.3, turn), u, 0.01, 1e-9);
    }
  }
}

// Essid 2019, Table 1, corner 1: T_L = 0.824239 mm gives a blend of 1.619259 mm.
TEST(CubicBlend, LengthReproducesTheFirstCornerOfEssid) {
  const Vec3 before(0, 0, 0);
  const Vec3 corner(7.071, 7.071, 0);
  const Vec3 after(9.659, 16.73, 0);
  const double leg = 0.824239;
  const CubicBlend curve{corner - leg * (corner - before).normalized(), corner,
                         corner + leg * (after - corner).normalized(), 2.5};
  EXPECT_NEAR(curve.length(), 1.619259, 2e-6);
}

// alpha = 2 makes the cubic term vanish: S' = c1 + 2 u c2 with c2 across c1 for a right angle, a parabola.
TEST(CubicBlend, LengthIsThatOfTheParabolaForAlphaTwo) {
  CubicBlend curve = blend(3, pi / 2);
  curve.alpha = 2;
  // |S'| = 6 hypot(1 - u, u) = 6 sqrt(2 (u - 1/2)^2 + 1/2)
  const auto antiderivative = [](double x) {
    const double root = std::sqrt(2 * x * x + 0.5);
    return x / 2 * root + 0.5 / (2 * std::sqrt(2.0)) * std::log(std::sqrt(2.0) * x + root);
  };
  const double exact = 6 * (antiderivative(0.5) - antiderivative(-0.5));
  EXPECT_NEAR(curve.length(), exact, 1e-11 * exact);
}

// A reversal runs out and back on a line: S' = alpha leg (1 - 2u), so the length is alpha leg / 2.
TEST(CubicBlend, LengthOfAReversalIsItsWayOutAndBack) {
  CubicBlend curve = blend(4, 0);
  curve.end = curve.start;
  EXPECT_NEAR(curve.length(), 2.5 * 4 / 2, 1e-11);
}

TEST(CubicBlend, LengthIsAccurateForSharpTurns) {
  for (const double off : {1.0, 0.1, 1e-2, 1e-3, 1e-5}) {
    const CubicBlend curve = blend(1, pi - off);
    // Simpson sums over u = (1 + sinh(k t) / sinh(k)) / 2, which crowds the slow place, converge fast.
    const double k = std::asinh(1 / off);
    constexpr int steps = 20000;
    double sum = 0;
    for (int i = 0; i <= steps; ++i) {
      const double t = 2.0 * i / steps - 1;
      const double u = (1 + std::sinh(k * t) / std::sinh(k)) / 2;
      const double weight = i == 0 || i == steps ? 1 : 2 + 2 * (i % 2);
      sum += weight * curve.at(u).d1.norm() * k * std::cosh(k * t) / std::sinh(k) / (3.0 * steps);
    }
    EXPECT_NEAR(curve.length(), sum, 1e-10 * sum) << "turn of pi - " << off;
  }
}

TEST(CubicBlend, ParameterAtInvertsLengthTo) {
  for (const double turn : {0.0, 0.01, 1.0, 2.5, 3.1, pi - 1e-4}) {
    const CubicBlend curve = blend(0.7, turn);
    const double length = curve.length();
    for (int i = 0; i <= 20; ++i) {
      const double s = length * i / 20;
      EXPECT_NEAR(curve.length_to(curve.parameter_at(s)), s, 1e-11 * length) << "turn " << turn;
    }
    EXPECT_EQ(curve.parameter_at(-1), 0);
    EXPECT_EQ(curve.parameter_at(length + 1), 1);
  }
}

// From the other end the same blend is as long, and so is every part of it.
TEST(CubicBlend, LengthsFromBothEndsAddUp) {
  for (const double off : {3.0, 1.0, 0.1, 1e-2, 1.768e-3, 1e-4, 1e-6, 1e-8}) {
    const CubicBlend curve = blend(0.7, pi - off);
    const BlendLength there(curve);
    const BlendLength back({curve.end, curve.corner, curve.start, curve.alpha});
    EXPECT_NEAR(there.total(), curve.length(), 1e-15);
    for (int i = 0; i <= 100; ++i) {
      const double u = i / 100.0;
      EXPECT_NEAR(there.to(u) + back.to(1 - u), there.total(), 1e-12 * there.total())
          << "turn of pi - " << off << ", u " << u;
      const double s = there.total() * u;
      EXPECT_NEAR(there.to(there.parameter_at(s)), s, 1e-12 * there.total()) << "turn of pi - " << off;
    }
  }
}

}  // namespace
}  // namespace feedscope

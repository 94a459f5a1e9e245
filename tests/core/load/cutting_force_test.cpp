#include "core/load/cutting_force.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/base/units.h"

namespace feedscope {
namespace {

constexpr double pi = units::pi;

Engagement mill(double radial_depth, Milling milling, int teeth = 2, double helix = 0) {
  Engagement operation;
  operation.diameter = 12;
  operation.teeth = teeth;
  operation.helix = helix;
  operation.radial_depth = radial_depth;
  operation.axial_depth = 5;
  operation.milling = milling;
  return operation;
}

Material linear() {
  Material material;
  material.cutting = {800, 170, 220};
  material.edge = {28, 31, 1.4};
  return material;
}

Material kienzle(double exponent = 0.26) {
  Material material;
  material.law = CuttingLaw::kienzle;
  material.specific_force = 2500;
  material.exponent = exponent;
  material.share = {1, 0.3, 0.1};
  return material;
}

Engagement random_mill(std::mt19937& random) {
  std::uniform_real_distribution<double> share(0, 1);
  Engagement operation =
      mill(12 * std::max(0.02, share(random)), share(random) < 0.5 ? Milling::up : Milling::down,
           1 + static_cast<int>(share(random) * 7), share(random) < 0.3 ? 0 : share(random));
  operation.axial_depth = 0.1 + 30 * share(random);
  return operation;
}

/// A small sum over tooth and depth: what the closed forms stand for.
Vec3 summed_force(const Engagement& operation, const Material& material, double feed, double rotation) {
  constexpr int slices = 4000;
  const Immersion cut = immersion(operation);
  const ForceLaw law = force_law(material);
  Vec3 sum = Vec3::Zero();
  for (int tooth = 0; tooth < operation.teeth; ++tooth) {
    for (int i = 0; i < slices; ++i) {
      const double z = operation.axial_depth * (i + 0.5) / slices;
      double angle = rotation + 2 * pi * tooth / operation.teeth -
                     2 * std::tan(operation.helix) / operation.diameter * z;
      angle -= 2 * pi * std::floor(angle / (2 * pi));
      if (angle < cut.from || angle > cut.to) {
        continue;
      }
      const double chip = std::pow(feed * std::sin(angle), law.exponent);
      const auto component = [&](std::size_t k) { return law.chip[k] * chip + law.edge[k]; };
      const double sine = std::sin(angle);
      const double cosine = std::cos(angle);
      sum += operation.axial_depth / slices *
             Vec3(-component(0) * cosine - component(1) * sine, component(0) * sine - component(1) * cosine,
                  component(2));
    }
  }
  return sum;
}

/// Altintas, Manufacturing Automation, eq 2.86: slotting over half a turn.
TEST(CuttingForce, OfASlotHasThePrintedMeanForces) {
  for (const Milling milling : {Milling::up, Milling::down}) {
    const Engagement slot = mill(12, milling, 4);
    const double feed = 0.05;
    const Vec3 mean = CuttingForce(slot, linear()).at(feed).mean;
    const double share = 4 * slot.axial_depth;
    EXPECT_NEAR(mean.x(), -share / 4 * 170 * feed - share / pi * 31, 1e-9);
    EXPECT_NEAR(mean.y(), share / 4 * 800 * feed + share / pi * 28, 1e-9);
    EXPECT_NEAR(mean.z(), share / pi * 220 * feed + share / 2 * 1.4, 1e-9);
  }
}

/// From 0 to pi/2: int sin cos = 1/2, int sin^2 = pi/4, int sin = int cos = 1.
TEST(CuttingForce, OfHalfImmersionUpHasItsClosedForm) {
  const Engagement half = mill(6, Milling::up, 2);
  const double feed = 0.08;
  const Vec3 mean = CuttingForce(half, linear()).at(feed).mean;
  const double share = 2 * half.axial_depth / (2 * pi);
  EXPECT_NEAR(mean.x(), share * (feed * (-800 * 0.5 - 170 * pi / 4) - 28 - 31), 1e-9);
  EXPECT_NEAR(mean.y(), share * (feed * (800 * pi / 4 - 170 * 0.5) + 28 - 31), 1e-9);
  EXPECT_NEAR(mean.z(), share * (feed * 220 + 1.4 * pi / 2), 1e-9);
}

/// Chip volume by revolution times K_tc: a_e a_p f z; edge forces along the cut length.
TEST(CuttingForce, DoesTheWorkThatTheChipVolumeTakes) {
  for (const double radial_depth : {1.0, 6.0, 9.0, 12.0}) {
    const Engagement operation = mill(radial_depth, Milling::down, 3, 0.5);
    const double feed = 0.06;
    const Immersion cut = immersion(operation);
    const double work = 2 * pi * CuttingForce(operation, linear()).at(feed).torque;
    const double volume = radial_depth * operation.axial_depth * feed * 3;
    const double length = (cut.to - cut.from) * 6 * 3;
    EXPECT_NEAR(work, 800 * volume + 28 * operation.axial_depth * length, 1e-8 * work) << radial_depth;
  }
}

TEST(CuttingForce, MeansAreTheIntegralOverARevolution) {
  std::mt19937 random(11);
  for (int i = 0; i < 12; ++i) {
    const Engagement operation = random_mill(random);
    const Material material = i % 2 == 0 ? linear() : kienzle();
    const CuttingForce force(operation, material);
    constexpr int looks = 20000;
    Vec3 sum = Vec3::Zero();
    for (int k = 0; k < looks; ++k) {
      sum += force.force_at(0.04, 2 * pi * (k + 0.5) / looks) / looks;
    }
    const Vec3 mean = force.at(0.04).mean;
    EXPECT_NEAR((sum - mean).norm(), 0, 2e-3 * mean.norm()) << describe(operation) << " case " << i;
  }
}

TEST(CuttingForce, SumsTeethAndDepth) {
  std::mt19937 random(12);
  std::uniform_real_distribution<double> angle(0, 2 * pi);
  for (int i = 0; i < 40; ++i) {
    const Engagement operation = random_mill(random);
    const Material material = i % 2 == 0 ? linear() : kienzle();
    const CuttingForce force(operation, material);
    const double rotation = angle(random);
    const Vec3 summed = summed_force(operation, material, 0.05, rotation);
    EXPECT_NEAR((force.force_at(0.05, rotation) - summed).norm(), 0, 1e-2 * summed.norm() + 1) << i;
  }
}

TEST(CuttingForce, PeakIsTheLargestOverAllRotations) {
  std::mt19937 random(13);
  for (int i = 0; i < 60; ++i) {
    const Engagement operation = random_mill(random);
    const CuttingForce force(operation, i % 2 == 0 ? linear() : kienzle());
    for (const double feed : {0.0, 0.001, 0.013, 0.08, 0.4}) {
      double largest = 0;
      for (int k = 0; k < 3000; ++k) {
        largest = std::max(largest, force.force_at(feed, 2 * pi * k / 3000).head<2>().norm());
      }
      const double peak = force.at(feed).peak;
      EXPECT_GE(peak, largest * (1 - 2e-5)) << i << " at " << feed;
      EXPECT_LE(peak, largest * (1 + 5e-2)) << i << " at " << feed;
      EXPECT_GE(peak * (1 + 1e-9), force.at(feed).mean.head<2>().norm()) << i << " at " << feed;
    }
  }
}

/// One straight tooth in a slot, Kienzle's law: |F| = F_t sqrt(1 + 0.3^2), largest in front.
TEST(CuttingForce, PeakOfOneStraightToothIsThatOfTheThickestChip) {
  const Engagement slot = mill(12, Milling::up, 1);
  const double expected = 2500 * 5 * std::pow(0.1, 0.74) * std::hypot(1, 0.3);
  EXPECT_NEAR(CuttingForce(slot, kienzle()).at(0.1).peak, expected, 1e-5 * expected);
}

/// Down, a tooth enters with its thickest chip, sin(60 degrees).
TEST(CuttingForce, FindsThePeakWhereAToothEnters) {
  const Engagement narrow = mill(3, Milling::down, 1);
  const double expected = 2500 * 5 * std::pow(0.1 * std::sin(pi / 3), 0.74) * std::hypot(1, 0.3);
  EXPECT_NEAR(CuttingForce(narrow, kienzle()).at(0.1).peak, expected, 1e-6 * expected);
}

TEST(CuttingForce, DoublesWithTheDepthOfStraightTeeth) {
  Engagement operation = mill(4, Milling::down, 3);
  const auto single = CuttingForce(operation, linear()).at(0.05);
  operation.axial_depth *= 2;
  const auto twice = CuttingForce(operation, linear()).at(0.05);
  EXPECT_NEAR(twice.peak, 2 * single.peak, 1e-9 * single.peak);
  EXPECT_NEAR((twice.mean - 2 * single.mean).norm(), 0, 1e-9);
  EXPECT_NEAR(twice.torque, 2 * single.torque, 1e-9);
}

/// The same teeth the other way round: the part that F_r gives keeps its sign across the feed.
TEST(CuttingForce, UpAndDownAreMirrored) {
  Material tangential = kienzle();
  tangential.share = {1, 0, 0};
  const auto up = CuttingForce(mill(4, Milling::up, 3), tangential).at(0.05);
  const auto down = CuttingForce(mill(4, Milling::down, 3), tangential).at(0.05);
  EXPECT_NEAR(up.mean.x(), -down.mean.x(), 1e-9);
  EXPECT_NEAR(up.mean.y(), down.mean.y(), 1e-9);
  EXPECT_NEAR(up.peak, down.peak, 1e-6 * up.peak);
  EXPECT_NEAR(up.torque, down.torque, 1e-9);
}

TEST(CuttingForce, OfASmallHelixIsThatOfStraightTeeth) {
  const auto straight = CuttingForce(mill(4, Milling::down, 3), linear());
  const auto helical = CuttingForce(mill(4, Milling::down, 3, 1e-5), linear());
  for (const double feed : {0.0, 0.03, 0.2}) {
    EXPECT_NEAR(straight.at(feed).peak, helical.at(feed).peak, 1e-4 * straight.at(feed).peak);
    EXPECT_EQ(straight.at(feed).mean, helical.at(feed).mean);
  }
}

TEST(CuttingForce, ChipIsThickestInFrontOrWhereTheToothEnters) {
  EXPECT_DOUBLE_EQ(CuttingForce(mill(12, Milling::up), linear()).largest_chip(0.1), 0.1);
  EXPECT_DOUBLE_EQ(CuttingForce(mill(6, Milling::down), linear()).largest_chip(0.1), 0.1);
  // 2 f sqrt(a_e/D (1 - a_e/D))
  EXPECT_NEAR(CuttingForce(mill(3, Milling::up), linear()).largest_chip(0.1), 0.2 * std::sqrt(0.1875), 1e-15);
  EXPECT_NEAR(CuttingForce(mill(3, Milling::down), linear()).largest_chip(0.1), 0.2 * std::sqrt(0.1875),
              1e-15);
  // 2/pi over a slot
  EXPECT_NEAR(CuttingForce(mill(12, Milling::up), linear()).mean_chip(0.1), 0.2 / pi, 1e-15);
}

/// m_c = 0 is a linear law without edge forces.
TEST(CuttingForce, LawsAgreeWhereTheyAreTheSame) {
  Material same;
  same.cutting = {2500, 750, 250};
  const Engagement operation = mill(5, Milling::down, 3, 0.5);
  const auto one = CuttingForce(operation, kienzle(0)).at(0.07);
  const auto other = CuttingForce(operation, same).at(0.07);
  EXPECT_NEAR(one.peak, other.peak, 1e-9 * other.peak);
  EXPECT_NEAR((one.mean - other.mean).norm(), 0, 1e-9);
  const auto nearly = CuttingForce(operation, kienzle(1e-9)).at(0.07);
  EXPECT_NEAR(nearly.peak, other.peak, 1e-6 * other.peak);
  EXPECT_NEAR(nearly.torque, other.torque, 1e-6 * other.torque);
}

TEST(CuttingForce, OfTheLinearLawGrowsAffinelyWithTheFeed) {
  const CuttingForce force(mill(5, Milling::down, 3, 0.5), linear());
  const Vec3 first = force.at(0.02).mean - force.at(0.01).mean;
  const Vec3 second = force.at(0.12).mean - force.at(0.11).mean;
  EXPECT_NEAR((first - second).norm(), 0, 1e-9);
  EXPECT_GT(force.at(0).peak, 0);
  EXPECT_EQ(CuttingForce(mill(5, Milling::down, 3, 0.5), kienzle()).at(0).peak, 0);
}

}  // namespace
}  // namespace feedscope

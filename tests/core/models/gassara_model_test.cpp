#include "core/models/gassara/gassara_model.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/units.h"
#include "tests/support/parts.h"
#include "tests/support/paths.h"

namespace feedscope {
namespace {

Trajectory run(const Toolpath& path) {
  const ControlModel& gassara = find_model("gassara");
  return gassara.simulate(path, testing::spinner(), testing::spinner_settings(gassara));
}

TEST(GassaraSpline, ReproducesTheComparisonOfEssid2019) {
  // models/gassara/README.md: at P_4 R 6.916 mm and 37.19 mm/s, total 2.903 s
  const Trajectory trajectory = run(testing::polyline(testing::essid_spline(), 50));
  ASSERT_EQ(trajectory.blend_count(), 9u);
  const BlendRecord& blend = trajectory.blend(2);
  EXPECT_NEAR(units::to_deg(blend.turn), 17.35, 0.005);
  EXPECT_NEAR(blend.min_radius, 6.916, 1e-3);
  EXPECT_NEAR(blend.entry_speed, 37.19, 0.005);
  EXPECT_NEAR(blend.entry_speed, blend.exit_speed, 1e-9);
  EXPECT_NEAR(trajectory.duration(), 2.903, 0.0005);
}

TEST(GassaraModel, BlendsTheCornersOfEssidByArcsOfTheSameDepth) {
  const Toolpath path = testing::polyline(testing::essid_table1(), 50);
  const ControlModel& essid = find_model("essid");
  const Trajectory cubic = essid.simulate(path, testing::spinner(), testing::spinner_settings(essid));
  const Trajectory arcs = run(path);
  ASSERT_EQ(arcs.blend_count(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    const BlendRecord& blend = arcs.blend(i);
    EXPECT_NEAR(blend.epsilon, cubic.blend(i).epsilon, 1e-12);
    // closed form: eps = R (1 / cos(phi/2) - 1)
    EXPECT_NEAR(blend.min_radius * (1 / std::cos(blend.turn / 2) - 1), blend.epsilon, 1e-12);
    const ElementCurve curve = arcs.path().curve(blend.element);
    const Vec3 middle = curve.at(curve.length / 2).position;
    EXPECT_NEAR((middle - blend.corner).norm(), blend.epsilon, 1e-12);
  }
}

TEST(GassaraModel, PassesABlendAtTheLeastOfItsThreeLimits) {
  // Right angle, eps = 0.8 rho = 0.08 mm: R = eps / (sqrt 2 - 1); 0.2 of 1 m/s2 across the path, 0.8 of 10
  // m/s3 along it
  const double radius = 0.08 / (std::sqrt(2.0) - 1);
  const auto entry = [](double feed) {
    const Trajectory trajectory = run(testing::polyline({{0, 0, 0}, {50, 0, 0}, {50, 50, 0}}, feed));
    const BlendRecord& blend = trajectory.blend(0);
    EXPECT_NEAR(trajectory.state_at_path(50 - blend.transition + blend.length / 2).speed, blend.entry_speed,
                1e-9);
    return blend.entry_speed;
  };
  EXPECT_NEAR(entry(50), std::sqrt(200 * radius), 1e-9);
  EXPECT_NEAR(entry(2), 2, 1e-12);
}

TEST(GassaraModel, HoldsItsSpeedOnEveryBlendAndSaysWhatLimitsIt) {
  const Trajectory trajectory = run(testing::polyline(testing::essid_spline(), 50));
  for (const BlendRecord& blend : testing::blends_of(trajectory)) {
    for (const Part& part : testing::parts_of(trajectory)) {
      if (part.element == blend.element) {
        EXPECT_NEAR(part.v, blend.entry_speed, 1e-9);
        EXPECT_EQ(part.a, 0);
      }
    }
  }
  const State middle = trajectory.state_at_path(trajectory.path().s(trajectory.blend(2).element) +
                                                trajectory.blend(2).length / 2);
  EXPECT_EQ(middle.cause.kind, CauseKind::blend_radial_acceleration);
}

TEST(GassaraTable1, TakesTheDerivedTimeAndNamesTheJerkAlongThePath) {
  // models/gassara/README.md: v^3/R^2 lies along the path and has the share 1 - R_J of 10 m/s3
  const Trajectory trajectory = run(testing::polyline(testing::essid_table1(), 50));
  EXPECT_NEAR(trajectory.duration(), 1.2223659, 5e-7);
}

TEST(GassaraModel, NamesTheJerkAlongThePathOnATightArc) {
  // Right angle, eps = 0.8 rho = 0.008 mm: v^3/R^2 = 8 m/s3 at 1.44 mm/s, v^2/R = 0.2 m/s2 at 1.97 mm/s only
  const ControlModel& gassara = find_model("gassara");
  Settings settings = testing::spinner_settings(gassara);
  settings.set("contour_tolerance_mm", 0.01);
  const Trajectory trajectory = gassara.simulate(testing::polyline({{0, 0, 0}, {50, 0, 0}, {50, 50, 0}}, 50),
                                                 testing::spinner(), settings);
  const BlendRecord blend = trajectory.blend(0);
  EXPECT_NEAR(blend.entry_speed, std::cbrt(8000 * blend.min_radius * blend.min_radius), 1e-9);
  const State middle = trajectory.state_at_path(trajectory.path().s(blend.element) + blend.length / 2);
  EXPECT_EQ(middle.cause.kind, CauseKind::blend_tangential_jerk);
}

/// A circle of R 14 mm in chords of 1.2 mm, whose blends meet in their middles.
Toolpath chorded_circle() {
  std::vector<Vec3> points;
  constexpr int chords = 73;
  for (int i = 0; i <= chords; ++i) {
    const double angle = 2 * units::pi * i / chords;
    points.emplace_back(14 * std::cos(angle), 14 * std::sin(angle), 0);
  }
  return testing::polyline(points, 50);
}

TEST(GassaraModel, SpeedsUpOverBlendsThatMeet) {
  const Trajectory trajectory = run(chorded_circle());
  const auto speed_on = [&](std::size_t blend) {
    const BlendRecord& record = trajectory.blend(blend);
    return trajectory.state_at_path(trajectory.path().s(record.element) + record.length / 2).speed;
  };
  // 0.2 m/s2 of 1 m/s2 across the path: sqrt(200 * 14) = 52.9 mm/s, above the programmed 50 mm/s
  EXPECT_NEAR(speed_on(40), 50, 0.5);
  EXPECT_LT(speed_on(0), 25);  // half a chord from rest reaches 21 mm/s
  EXPECT_GT(speed_on(8), 1.3 * speed_on(1));
}

TEST(GassaraModel, KeepsTheSharesOfTurningAndOfRampsOnBlendsThatItSpeedsUpOn) {
  const Trajectory trajectory = run(chorded_circle());
  for (const Part& part : testing::parts_of(trajectory)) {
    const State s = testing::state_in(trajectory, part, part.duration / 2);
    if (trajectory.path().kind(s.element) != ElementKind::connecting_arc) {
      continue;
    }
    const Vec3 tangent = s.velocity / s.speed;
    const auto across = [&](const Vec3& vector) { return (vector - vector.dot(tangent) * tangent).norm(); };
    ASSERT_LE(std::abs(s.acceleration.dot(tangent)), 800 * 1.00001);
    ASSERT_LE(across(s.acceleration), 200 * 1.00001);
    ASSERT_LE(std::abs(s.jerk.dot(tangent)), 8000 * 1.00001);
    ASSERT_LE(across(s.jerk), 2000 * 1.00001);
  }
}

}  // namespace
}  // namespace feedscope

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
  // MODELS section 6: at P_4 R 6.916 mm and 37.19 mm/s, total 2.903 s
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
  // Right angle, eps = 0.8 rho = 0.08 mm: R = eps / (sqrt 2 - 1); A_R = 0.2 m/s2, J_R = 2 m/s3
  const double radius = 0.08 / (std::sqrt(2.0) - 1);
  const auto entry = [](double feed) {
    const Trajectory trajectory = run(testing::polyline({{0, 0, 0}, {50, 0, 0}, {50, 50, 0}}, feed));
    const BlendRecord& blend = trajectory.blend(0);
    EXPECT_NEAR(trajectory.state_at_path(50 - blend.transition + blend.length / 2).speed, blend.entry_speed,
                1e-9);
    return blend.entry_speed;
  };
  EXPECT_NEAR(entry(50), std::cbrt(2000 * radius * radius), 1e-9);
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

TEST(GassaraModel, ABlendBetweenSlowerOnesIsLimitedByTheSlowerOfThem) {
  // 0.4 mm on both sides of a gentle corner: too short to speed up much between two nearly right angles
  const auto cause_behind = [](const Vec3& last) {
    const Trajectory trajectory =
        run(testing::polyline({{0, 0, 0}, {20, 0, 0}, {20, 0.4, 0}, {20.002, 0.8, 0}, last}, 50));
    const BlendRecord gentle = trajectory.blend(1);
    EXPECT_LT(gentle.entry_speed, std::sqrt(200 * gentle.min_radius));
    const double start = trajectory.path().s(gentle.element);
    return trajectory.state_at_path(start + gentle.length / 2).cause.kind;
  };
  EXPECT_EQ(cause_behind({0, 0.8, 0}), CauseKind::ramp_down);   // X reverses: 0.6 of the tolerance
  EXPECT_EQ(cause_behind({40, 0.8, 0}), CauseKind::axis_jerk);  // 0.8 of it, as before
}

}  // namespace
}  // namespace feedscope

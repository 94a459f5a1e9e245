#include "core/models/msaddek/msaddek_model.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/units.h"
#include "core/feed/ramp.h"
#include "tests/support/paths.h"

namespace feedscope {
namespace {

constexpr double feed = 160;  // 9.6 m/min, set on the Huron for figure 21 of the paper
constexpr double tit = 0.007;
constexpr double period = 0.002;
const RampLimits xy_ramp{5000, 50000};

/// Huron KX10 (Msaddek 2011, table 1).
Machine huron() {
  Machine machine;
  machine.id = "huron-kx10";
  for (AxisLimits& axis : machine.axes) {
    axis = {units::from_m_min(10), units::from_m(5), units::from_m(50), units::from_m(50)};
  }
  machine.axes[2].acceleration = units::from_m(3);
  return machine;
}

Settings settings_for(const std::string& law, double compaction = 0, double lookahead = 100) {
  Settings settings = complete_settings(find_model("msaddek"), huron());
  settings.set("contour_tolerance_mm", tit);
  settings.set("interpolation_period_s", period);
  settings.set("lookahead_blocks", lookahead);
  settings.set("curvilinear_jerk_m_s3", 50.0);
  settings.set("tangential_share", 0.6);
  settings.set("compaction_mm", compaction);
  settings.set("law", law);
  return settings;
}

Trajectory run(const Toolpath& path, const Settings& settings) {
  return find_model("msaddek").simulate(path, huron(), settings);
}

/// 100 mm along X, then 100 mm along Y.
Toolpath right_angle() {
  return testing::polyline({{0, 0, 0}, {100, 0, 0}, {100, 100, 0}}, feed);
}

Toolpath cut_line(int blocks, double length) {
  std::vector<Vec3> points;
  for (int i = 0; i <= blocks; ++i) {
    points.push_back({length * i, 0, 0});
  }
  return testing::polyline(points, feed);
}

TEST(MsaddekModel, PutsAConnectingArcIntoACorner) {
  const Trajectory trajectory = run(right_angle(), settings_for("dynamic"));
  ASSERT_EQ(trajectory.blend_count(), 1u);
  const BlendRecord& arc = trajectory.blend(0);
  EXPECT_EQ(trajectory.path().kind(arc.element), ElementKind::connecting_arc);
  EXPECT_EQ(arc.line, 1u);
  EXPECT_NEAR(arc.min_radius, tit, 1e-12);
  EXPECT_NEAR(arc.epsilon, (std::sqrt(2) - 1) * tit, 1e-12);
  EXPECT_NEAR(arc.length, tit * units::pi / 2, 1e-12);
}

TEST(MsaddekModel, StaticFeedOfAConnectingArcIsTheLeastOfEquation18) {
  // R = 7 um: R b/t_cy = 5.50, sqrt(R A) = 5.92, (J R^2)^(1/3) = 1.35, (0.6 J R^2)^(1/3) = 1.14 mm/s
  const Trajectory trajectory = run(right_angle(), settings_for("static"));
  const double on_arc = std::cbrt(0.6 * 50000 * tit * tit);
  EXPECT_NEAR(trajectory.blend(0).entry_speed, on_arc, 1e-9);
  EXPECT_NEAR(trajectory.duration(), 2 * (100 - tit) / feed + tit * units::pi / 2 / on_arc, 1e-9);
}

TEST(MsaddekModel, StaticFeedOfAnArcNamesWhatLimitsIt) {
  struct Case {
    double radius;
    double speed;
    CauseKind cause;
  };
  const auto jerk_speed = [](double r) { return std::cbrt(0.6 * 50000 * r * r); };
  for (const Case& c :
       {Case{200, feed, CauseKind::programmed_feed}, Case{10, jerk_speed(10), CauseKind::curvilinear_jerk}}) {
    Toolpath path;
    path.start = Vec3(c.radius, 0, 0);
    testing::append_arc(path, {0, 0, 0}, 3, feed);
    const State state = run(path, settings_for("static")).state(0);
    EXPECT_NEAR(state.speed, c.speed, 1e-9);
    EXPECT_EQ(state.cause.kind, c.cause);
  }
}

TEST(MsaddekModel, StaticFeedOnAShortBlockIsItsLengthOverTheInterpolationPeriod) {
  const Trajectory trajectory = run(cut_line(100, 0.1), settings_for("static"));
  EXPECT_NEAR(trajectory.duration(), 100 * period, 1e-12);
  EXPECT_EQ(trajectory.state(0.01).cause.kind, CauseKind::interpolation_period);
}

TEST(MsaddekModel, CompactionConservesTheFeedOnShortBlocks) {
  // Msaddek 2011, section 3.3.4: small blocks compacted into 5 mm segments keep more of the feed.
  const Trajectory trajectory = run(cut_line(1000, 0.1), settings_for("static", 5));
  EXPECT_NEAR(trajectory.duration(), 100 / feed, 1e-9);
  EXPECT_EQ(trajectory.path().size(), 1000u) << "every block keeps its element";
}

TEST(MsaddekModel, CompactionErrorCountsAsContourError) {
  std::vector<Vec3> points;
  for (int i = 0; i <= 200; ++i) {
    points.push_back({0.1 * i, i % 2 == 0 ? 0.0 : 0.003, 0});
  }
  const Trajectory trajectory = run(testing::polyline(points, feed), settings_for("dynamic", 5));
  EXPECT_NEAR(trajectory.compaction_error(), 0.003, 1e-4);
}

TEST(MsaddekModel, AStraightLineIsTheJerkLimitedClosedForm) {
  const Trajectory trajectory =
      run(testing::polyline({{0, 0, 0}, {100, 0, 0}}, feed), settings_for("dynamic"));
  const double ramp = ramp_time(0, feed, xy_ramp);
  EXPECT_NEAR(trajectory.duration(), 2 * ramp + (100 - feed * ramp) / feed, 1e-12);
}

TEST(MsaddekModel, DynamicFeedCrossesIntoAConnectingArcByEquation3) {
  // V = sqrt(J t_cy R)
  const Trajectory trajectory = run(right_angle(), settings_for("dynamic"));
  const double crossing = std::sqrt(50000 * period * tit);
  EXPECT_NEAR(trajectory.blend(0).entry_speed, crossing, 1e-9);
  EXPECT_NEAR(trajectory.blend(0).exit_speed, crossing, 1e-9);

  const double ramps = ramp_time(0, feed, xy_ramp) + ramp_time(feed, crossing, xy_ramp);
  const double ramped = ramp_length(0, feed, xy_ramp) + ramp_length(feed, crossing, xy_ramp);
  const double line = ramps + (100 - tit - ramped) / feed;
  const double on_arc = trajectory.duration() - 2 * line;
  EXPECT_LT(on_arc, tit * units::pi / 2 / crossing);
  EXPECT_GT(on_arc, tit * units::pi / 2 / std::cbrt(0.6 * 50000 * tit * tit));
}

TEST(MsaddekModel, FeedIsNearZeroAtSharpCornersOfTheHermle) {
  // Msaddek 2011, figure 16: 15 m/min, TIT 4 um, A 5 m/s2, J 0.5 m/s3 as printed.
  Machine hermle = huron();
  for (AxisLimits& axis : hermle.axes) {
    axis = {units::from_m_min(35), units::from_m(5), units::from_m(0.5), units::from_m(0.5)};
  }
  Settings settings = settings_for("dynamic", 0, 200);
  settings.set("contour_tolerance_mm", 0.004);
  const Trajectory trajectory = find_model("msaddek").simulate(
      testing::polyline({{0, 0, 0}, {100, 0, 0}, {100, 100, 0}}, 250), hermle, settings);
  EXPECT_LT(trajectory.blend(0).entry_speed, 0.01 * 250);
}

TEST(MsaddekModel, AShortLookaheadSlowsShortBlocks) {
  const Toolpath path = cut_line(400, 0.5);
  EXPECT_GT(run(path, settings_for("dynamic", 0, 5)).duration(),
            1.2 * run(path, settings_for("dynamic", 0, 400)).duration());
}

TEST(MsaddekModel, LookaheadSeesCompactedBlocksAsOne) {
  const Toolpath path = cut_line(4000, 0.05);
  EXPECT_LT(run(path, settings_for("dynamic", 5, 10)).duration(),
            run(path, settings_for("dynamic", 0, 10)).duration() / 2);
}

TEST(MsaddekModel, ACornerThatTouchesAnArcIsAnExactStop) {
  Toolpath path = testing::polyline({{0, 0, 0}, {50, 0, 0}}, feed);
  testing::append_arc(path, {30, 0, 0}, 1, feed);
  const Trajectory trajectory = run(path, settings_for("dynamic"));
  EXPECT_EQ(trajectory.blend_count(), 0u);
  EXPECT_LT(trajectory.state_at_path(50).speed, 1e-6);
}

TEST(MsaddekModel, TakesEmptyProgramsDwellsAndSingleBlocks) {
  for (const char* law : {"static", "dynamic"}) {
    EXPECT_EQ(run(Toolpath{}, settings_for(law, 5)).duration(), 0);
    Toolpath path = testing::polyline({{0, 0, 0}, {1e-6, 0, 0}}, 0);
    testing::append_dwell(path, 1.5);
    const Trajectory trajectory = run(path, settings_for(law, 5));
    EXPECT_GT(trajectory.duration(), 1.5);
    EXPECT_LT(trajectory.duration(), 1.51);
  }
}

}  // namespace
}  // namespace feedscope

#include "core/models/essid/essid_model.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/units.h"
#include "tests/support/paths.h"

namespace feedscope {
namespace {

Trajectory run(const Toolpath& path, const std::string& reading = "corrected", double beta = 0) {
  const ControlModel& essid = find_model("essid");
  Settings settings = testing::spinner_settings(essid);
  settings.set("reading", reading);
  settings.set("beta", beta);
  return essid.simulate(path, testing::spinner(), settings);
}

Toolpath table1() {
  return testing::polyline(testing::essid_table1(), 50);
}
Toolpath spline() {
  return testing::polyline(testing::essid_spline(), 50);
}

TEST(EssidTable1, BlendsAreThoseOfThePaper) {
  // models/essid/README.md, 1e-5 relative
  const Trajectory trajectory = run(table1());
  ASSERT_EQ(trajectory.blend_count(), 3u);
  const double transition[] = {.824239, .226274, .320003};
  const double radius[] = {1.81987, .09800, .29401};
  const double length[] = {1.619259, .386451, .596059};
  const double entry[] = {20.7093, 5.9661, 8.0994};
  const double turn[] = {30, 90, 60};
  for (std::size_t i = 0; i < 3; ++i) {
    const BlendRecord& blend = trajectory.blend(i);
    EXPECT_EQ(blend.line, i + 1);
    EXPECT_NEAR(blend.turn, units::from_deg(turn[i]), 2e-5);
    EXPECT_NEAR(blend.transition, transition[i], 1e-5 * transition[i]);
    EXPECT_NEAR(blend.min_radius, radius[i], 5e-5 * radius[i]);
    EXPECT_NEAR(blend.length, length[i], 1e-5 * length[i]);
    EXPECT_NEAR(blend.entry_speed, entry[i], 1e-5 * entry[i]);
  }
}

TEST(EssidTable1, BlendsBeginAndEndWhereThePaperPutsThem) {
  const Trajectory trajectory = run(table1());
  const Vec3 starts[] = {{6.48818, 6.48818, 0}, {9.60044, 16.51144, 0}, {19.00890, 14.22482, 0}};
  const Vec3 ends[] = {{7.28432, 7.86716, 0}, {9.87756, 16.67144, 0}, {19.54428, 14.36828, 0}};
  for (std::size_t i = 0; i < 3; ++i) {
    const PathElement element = trajectory.path().element(trajectory.blend(i).element);
    EXPECT_LT((element.start - starts[i]).norm(), 1e-5);
    EXPECT_LT((element.end - ends[i]).norm(), 1e-5);
  }
}

TEST(EssidTable1, WithTheFullToleranceBlendsAreLongerAndFaster) {
  const Trajectory trajectory = run(table1(), "corrected", 1);
  const double transition[] = {1.030298, .377124, .533339};
  const double entry[] = {24.0310, 8.3867, 11.3855};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(trajectory.blend(i).transition, transition[i], 1e-5 * transition[i]);
    EXPECT_NEAR(trajectory.blend(i).entry_speed, entry[i], 1e-5 * entry[i]);
  }
}

TEST(EssidTable1, TimesAreThoseOfTheReadings) {
  // models/essid/README.md: 0.5 % for the same law (strict, which samples nothing), 3 % for another sampled
  // reading; never below the time-optimal bound 1.179 s. Measured: -0.6 %, -0.5 %, 0.0 %.
  EXPECT_NEAR(run(table1(), "strict").duration(), 1.267, 0.001 * 1.267);
  EXPECT_NEAR(run(table1(), "corrected").duration(), 1.249, 0.01 * 1.249);
  EXPECT_NEAR(run(table1(), "published").duration(), 1.278, 0.01 * 1.278);
}

TEST(EssidSpline, TimesAreThoseOfTheReadings) {
  EXPECT_NEAR(run(spline(), "strict").duration(), 3.195, 0.001 * 3.195);
  EXPECT_NEAR(run(spline(), "strict", 1).duration(), 3.078, 0.001 * 3.078);
  EXPECT_NEAR(run(spline(), "published").duration(), 3.069, 0.005 * 3.069);
  EXPECT_NEAR(run(spline(), "published", 1).duration(), 2.951, 0.005 * 2.951);
  EXPECT_NEAR(run(spline(), "corrected").duration(), 3.030, 0.005 * 3.030);
  EXPECT_NEAR(run(spline(), "corrected", 1).duration(), 2.926, 0.005 * 2.926);
}

TEST(EssidSpline, ReproducesThePaperWithinTwoPercentAndItsGainOfTheFullTolerance) {
  // Paper: simulated 3.063 s, with beta = 1 2.943 s (ratio 1.041), measured 3.024 s. Ours: 1.034 corrected,
  // 1.042 published, 1.038 strict.
  for (const char* reading : {"corrected", "published", "strict"}) {
    const double time = run(spline(), reading).duration();
    const double ratio = time / run(spline(), reading, 1).duration();
    if (std::string(reading) != "strict") {
      EXPECT_NEAR(time, 3.063, 0.02 * 3.063);
    }
    EXPECT_GT(ratio, 1.033);
    EXPECT_LT(ratio, 1.043);
  }
}

TEST(EssidModel, AStraightLineIsTheJerkLimitedClosedForm) {
  // A = 1 m/s2, J = 15 m/s3 along X: 100 mm at 50 mm/s (below A^2/J = 66.7 mm/s)
  const Trajectory trajectory = run(testing::polyline({{0, 0, 0}, {100, 0, 0}}, 50));
  const double ramp = 2 * std::sqrt(50.0 / 15000);
  EXPECT_NEAR(trajectory.duration(), 2 * ramp + (100 - 50 * ramp) / 50, 1e-12);
}

TEST(EssidModel, CuttingALineIntoBlocksChangesNothing) {
  std::vector<Vec3> points;
  for (int i = 0; i <= 400; ++i) {
    points.push_back({0.25 * i, 0, 0});
  }
  const ControlModel& essid = find_model("essid");
  Settings settings = testing::spinner_settings(essid);
  settings.set("lookahead_blocks", 1000.0);
  const double cut = essid.simulate(testing::polyline(points, 50), testing::spinner(), settings).duration();
  EXPECT_NEAR(cut, run(testing::polyline({{0, 0, 0}, {100, 0, 0}}, 50)).duration(), 1e-9);
}

TEST(EssidModel, AShortLookaheadSlowsShortBlocks) {
  std::vector<Vec3> points;
  for (int i = 0; i <= 400; ++i) {
    points.push_back({0.1 * i, 0, 0});
  }
  const ControlModel& essid = find_model("essid");
  Settings settings = testing::spinner_settings(essid);
  double last = 0;
  for (const double blocks : {100.0, 8.0, 4.0, 2.0}) {
    settings.set("lookahead_blocks", blocks);
    const double time =
        essid.simulate(testing::polyline(points, 50), testing::spinner(), settings).duration();
    EXPECT_GT(time, last);
    last = time;
  }
}

TEST(EssidModel, AReversalIsAnExactStop) {
  const Trajectory trajectory = run(testing::polyline({{0, 0, 0}, {10, 0, 0}, {0, 0, 0}}, 50));
  EXPECT_EQ(trajectory.blend_count(), 0u);
  EXPECT_LT(trajectory.state(trajectory.duration() / 2).speed, 1e-6);
  EXPECT_LT((trajectory.state(trajectory.duration() / 2).position - Vec3(10, 0, 0)).norm(), 1e-9);
}

TEST(EssidModel, ATangentArcIsPassedWithoutAStop) {
  Toolpath path = testing::polyline({{0, 0, 0}, {50, 0, 0}}, 50);
  testing::append_arc(path, Vec3(50, 20, 0), units::pi / 2, 50);
  testing::append_line(path, Vec3(70, 70, 0), 50);
  const Trajectory trajectory = run(path);
  const State crossing = trajectory.state_at_path(50);
  // line into R 20: v = sqrt(J t_cy R) = sqrt(15000 * 0.001 * 20)
  EXPECT_NEAR(crossing.speed, std::sqrt(300.0), 1e-6);
  EXPECT_GT(trajectory.state_at_path(50 + 5 * units::pi).speed, crossing.speed);
  EXPECT_EQ(trajectory.blend_count(), 0u);
}

TEST(EssidModel, RapidsAndDwellsAreStops) {
  Toolpath path = testing::polyline({{0, 0, 0}, {10, 0, 0}}, 50);
  testing::append_dwell(path, 0.5);
  testing::append_line(path, Vec3(20, 0, 0), 50);
  const double moves = 2 * run(testing::polyline({{0, 0, 0}, {10, 0, 0}}, 50)).duration();
  EXPECT_NEAR(run(path).duration(), moves + 0.5, 1e-9);
}

}  // namespace
}  // namespace feedscope

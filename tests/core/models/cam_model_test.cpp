#include "core/models/cam/cam_model.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/units.h"
#include "tests/support/paths.h"

namespace feedscope {
namespace {

Trajectory run(const Toolpath& path) {
  const ControlModel& cam = find_model("cam");
  return cam.simulate(path, testing::spinner(), complete_settings(cam, testing::spinner()));
}

TEST(CamModel, TakesLengthOverProgrammedFeed) {
  Toolpath path = testing::polyline({{0, 0, 0}, {30, 40, 0}}, 100);
  testing::append_arc(path, Vec3(30, 50, 0), units::pi, 20);
  const Trajectory trajectory = run(path);
  EXPECT_NEAR(trajectory.duration(), 50.0 / 100 + 10 * units::pi / 20, 1e-12);
  EXPECT_DOUBLE_EQ(trajectory.state(0.25).speed, 100);
  EXPECT_LT((trajectory.state(0.25).position - Vec3(15, 20, 0)).norm(), 1e-12);
}

TEST(CamModel, RunsRapidsAtTheAxesAndWaitsAtDwells) {
  Toolpath path = testing::polyline({{0, 0, 0}, {0, 100, 0}}, 0);
  path.segments[0].rapid = true;
  testing::append_dwell(path, 1.5);
  const Trajectory trajectory = run(path);
  EXPECT_NEAR(trajectory.duration(), 100 / units::from_m_min(20) + 1.5, 1e-12);
  EXPECT_EQ(trajectory.state(0.1).cause.kind, CauseKind::rapid);
  EXPECT_EQ(trajectory.state(1).cause.kind, CauseKind::dwell);
  EXPECT_EQ(trajectory.state(1).speed, 0);
}

TEST(CamModel, GivesTheAxesSpeedToABlockWithoutFeed) {
  EXPECT_NEAR(run(testing::polyline({{0, 0, 0}, {100, 0, 0}}, 0)).duration(), 100 / units::from_m_min(20),
              1e-12);
}

TEST(CamModel, AnEmptyPathTakesNoTime) {
  EXPECT_EQ(run(Toolpath()).duration(), 0);
}

}  // namespace
}  // namespace feedscope

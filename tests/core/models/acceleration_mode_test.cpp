#include <gtest/gtest.h>

#include <cmath>

#include "core/limits/axis_share.h"
#include "core/models/control_model.h"
#include "tests/support/parts.h"
#include "tests/support/paths.h"

namespace feedscope {
namespace {

constexpr double feed = 50;  // mm/s

Toolpath with_mode(Toolpath path, AccelerationMode mode, std::size_t first = 0) {
  PathControl control;
  control.acceleration = mode;
  path.path_controls.push_back(control);
  for (std::size_t i = first; i < path.segments.size(); ++i) {
    path.segments[i].path_control = static_cast<std::uint16_t>(path.path_controls.size() - 1);
  }
  return path;
}

/// Of the models whose ramps a program may choose.
class AccelerationModeTest : public ::testing::TestWithParam<const char*> {
 protected:
  const ControlModel& model = find_model(GetParam());
  const Machine machine = testing::spinner();
  const Settings settings = complete_settings(model, machine);
  const double acceleration = axis_limit_vector(machine, &AxisLimits::acceleration)[0];
  const double jerk = axis_limit_vector(machine, &AxisLimits::jerk)[0];
  const double period = settings.number("interpolation_period_s");

  Trajectory run(const Toolpath& path) const { return model.simulate(path, machine, settings); }
};

TEST_P(AccelerationModeTest, BriskOnALineTakesTheTrapezoidAndOnePeriod) {
  ASSERT_GT(acceleration / period, jerk);
  ASSERT_LT(feed, acceleration * acceleration / jerk);  // a ramp of limited jerk does not reach A
  constexpr double length = 100;
  const Toolpath line = testing::polyline({{0, 0, 0}, {length, 0, 0}}, feed);
  const double trapezoid = length / feed + feed / acceleration;
  EXPECT_NEAR(run(with_mode(line, AccelerationMode::brisk)).duration(), trapezoid + period, 1e-9);
  EXPECT_NEAR(run(line).duration(), length / feed + 2 * std::sqrt(feed / jerk), 1e-9);
}

TEST_P(AccelerationModeTest, BriskOnAShortLineTakesTheTriangleAndOnePeriod) {
  // Each ramp lasts r and rises to A (r - t): length = r A (r - t).
  constexpr double length = 0.5;
  const Toolpath line = testing::polyline({{0, 0, 0}, {length, 0, 0}}, feed);
  const double rise = period;
  const double ramp = (rise + std::sqrt(rise * rise + 4 * length / acceleration)) / 2;
  ASSERT_LT(acceleration * (ramp - rise), feed);
  const Trajectory made = run(with_mode(line, AccelerationMode::brisk));
  EXPECT_NEAR(made.duration(), 2 * ramp, 1e-9);
  EXPECT_NEAR(made.state(made.duration() / 4).tangential_acceleration, acceleration, 1e-6);
  EXPECT_EQ(made.state(rise / 2).cause, (Cause{CauseKind::axis_acceleration, 0}));
}

TEST_P(AccelerationModeTest, SoftAndDriveAreRampsOfLimitedJerk) {
  const Toolpath path = testing::polyline({{0, 0, 0}, {30, 0, 0}, {30, 40, 0}}, feed);
  const double usual = run(path).duration();
  EXPECT_EQ(run(with_mode(path, AccelerationMode::soft)).duration(), usual);
  EXPECT_EQ(run(with_mode(path, AccelerationMode::drive)).duration(), usual);
  EXPECT_LT(run(with_mode(path, AccelerationMode::brisk)).duration(), usual);
}

TEST_P(AccelerationModeTest, BriskBeginsAtItsOwnBlock) {
  // There and back: the reversal is a standstill, and each way the time of a line alone.
  const Toolpath path = testing::polyline({{0, 0, 0}, {100, 0, 0}, {0, 0, 0}}, feed);
  const double usual = run(path).duration();
  const double brisk = run(with_mode(path, AccelerationMode::brisk)).duration();
  const double mixed = run(with_mode(path, AccelerationMode::brisk, 1)).duration();
  EXPECT_NEAR(mixed, (usual + brisk) / 2, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Models, AccelerationModeTest,
                         ::testing::Values("essid", "gassara", "msaddek", "tapie"),
                         [](const auto& name) { return std::string(name.param); });

TEST(AccelerationMode, ModelsThatFollowItSaySo) {
  for (const ControlModel* model : all_models()) {
    const Machine machine = testing::spinner();
    const Settings settings = complete_settings(*model, machine);
    const Toolpath line = testing::polyline({{0, 0, 0}, {100, 0, 0}}, feed);
    const double usual = model->simulate(line, machine, settings).duration();
    const double brisk =
        model->simulate(with_mode(line, AccelerationMode::brisk), machine, settings).duration();
    EXPECT_EQ(model->guarantees(settings).follows_brisk, brisk < usual) << model->info().id;
  }
}

}  // namespace
}  // namespace feedscope

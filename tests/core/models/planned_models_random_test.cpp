#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/models/control_model.h"
#include "tests/support/motion_checks.h"
#include "tests/support/paths.h"

namespace feedscope {
namespace {

/// What must hold on any path for models that keep to ramps between planned speeds.
class PlannedModelOnRandomPaths : public ::testing::TestWithParam<const char*> {
 protected:
  static constexpr int runs = 200;
  const Machine machine = testing::mikron();

  template <typename F>
  void for_each_run(F check) {
    std::mt19937 random(21);
    const ControlModel& model = find_model(GetParam());
    Settings settings = complete_settings(model, machine);
    for (int i = 0; i < runs; ++i) {
      SCOPED_TRACE(i);
      settings.set("interpolation_period_s", i % 2 == 0 ? 0.012 : 0.001);
      const Toolpath path = testing::random_path(random, 1 + i);
      check(path, model.simulate(path, machine, settings));
      if (HasFatalFailure()) {
        return;
      }
    }
  }
};

TEST_P(PlannedModelOnRandomPaths, PathAndSpeedHaveNoGapsAtPieceBorders) {
  for_each_run([](const Toolpath&, const Trajectory& run) { testing::expect_no_gaps_between_pieces(run); });
}

TEST_P(PlannedModelOnRandomPaths, BeginsAndEndsAtTheProgrammedPointsAtRest) {
  for_each_run([](const Toolpath& path, const Trajectory& run) {
    testing::expect_rest_at_the_programmed_ends(path, run);
  });
}

TEST_P(PlannedModelOnRandomPaths, KeepsTheProgrammedFeedAndTheAxisVelocities) {
  for_each_run([&](const Toolpath&, const Trajectory& run) {
    for (const Part& part : testing::parts_of(run)) {
      for (const double share : {0.0, 0.3, 0.7, 1.0}) {
        const State state = testing::state_in(run, part, share * part.duration);
        ASSERT_LE(state.speed, state.programmed_feed * (1 + 1e-6)) << "part at " << part.time;
        for (int j = 0; j < 3; ++j) {
          ASSERT_LE(std::abs(state.velocity[j]),
                    machine.axes[static_cast<std::size_t>(j)].velocity * (1 + 1e-6));
        }
      }
    }
  });
}

TEST_P(PlannedModelOnRandomPaths, KeepsAccelerationAndJerkOfEveryAxisOnLines) {
  for_each_run(
      [&](const Toolpath&, const Trajectory& run) { testing::expect_axis_limits_on_lines(run, machine); });
}

TEST_P(PlannedModelOnRandomPaths, GivesTheSameBytesAgain) {
  std::mt19937 random(10);
  const Toolpath path = testing::random_path(random, 300);
  const ControlModel& model = find_model(GetParam());
  const Settings settings = complete_settings(model, machine);
  const Trajectory a = model.simulate(path, machine, settings);
  const Trajectory b = model.simulate(path, machine, settings);
  ASSERT_EQ(a.pieces().size(), b.pieces().size());
  for (std::size_t p = 0; p < a.pieces().size(); ++p) {
    ASSERT_EQ(a.pieces()[p].time, b.pieces()[p].time);
    ASSERT_EQ(a.pieces()[p].v, b.pieces()[p].v);
  }
}

TEST_P(PlannedModelOnRandomPaths, RunsEmptyAndOneBlockProgramsAndBlocksOfAllSizes) {
  const ControlModel& model = find_model(GetParam());
  const Settings settings = complete_settings(model, machine);
  EXPECT_EQ(model.simulate(Toolpath(), machine, settings).duration(), 0);
  for (const double length : {1e-6, 1e-3, 1.0, 1000.0}) {
    for (const double feed : {0.0, 1e-3, 1000.0}) {
      const Trajectory run =
          model.simulate(testing::polyline({{0, 0, 0}, {length, 0, 0}, {length, length, 0}, {0, 0, 0}}, feed),
                         machine, settings);
      EXPECT_TRUE(std::isfinite(run.duration()) && run.duration() > 0)
          << length << " mm, " << feed << " mm/s";
      EXPECT_LT(run.state(run.duration()).position.norm(), 1e-9 * (1 + length));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Models, PlannedModelOnRandomPaths, ::testing::Values("gassara", "tapie"),
                         [](const auto& model) { return std::string(model.param); });

}  // namespace
}  // namespace feedscope

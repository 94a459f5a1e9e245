#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/models/control_model.h"
#include "tests/support/motion_checks.h"
#include "tests/support/paths.h"

namespace feedscope {
namespace {

/// What must hold on any path, whatever its corners.
class EssidOnRandomPaths : public ::testing::TestWithParam<const char*> {
 protected:
  static constexpr int runs = 150;

  template <typename F>
  void for_each_run(F check) {
    std::mt19937 random(9);
    const ControlModel& essid = find_model("essid");
    Settings settings = testing::spinner_settings(essid);
    settings.set("reading", std::string(GetParam()));
    for (int i = 0; i < runs; ++i) {
      SCOPED_TRACE(i);
      settings.set("contour_tolerance_mm", i % 3 == 0 ? 0.1 : 0.005);
      const Toolpath path = testing::random_path(random, 1 + i);
      check(path, essid.simulate(path, testing::spinner(), settings), settings);
      if (HasFatalFailure()) {
        return;
      }
    }
  }
};

TEST_P(EssidOnRandomPaths, PathAndSpeedHaveNoGapsAtPieceBorders) {
  for_each_run([](const Toolpath&, const Trajectory& run, const Settings&) {
    testing::expect_no_gaps_between_pieces(run);
  });
}

TEST_P(EssidOnRandomPaths, BeginsAndEndsAtTheProgrammedPointsAtRest) {
  for_each_run([](const Toolpath& path, const Trajectory& run, const Settings&) {
    testing::expect_rest_at_the_programmed_ends(path, run);
  });
}

TEST_P(EssidOnRandomPaths, KeepsTheContourToleranceAtEveryCorner) {
  for_each_run([](const Toolpath&, const Trajectory& run, const Settings& settings) {
    for (const BlendRecord& blend : testing::blends_of(run)) {
      ASSERT_LE(blend.epsilon, settings.number("contour_tolerance_mm"));
      ASSERT_GT(blend.min_radius, 0);
    }
  });
}

TEST_P(EssidOnRandomPaths, KeepsTheProgrammedFeedAndTheAxisVelocities) {
  const Machine machine = testing::spinner();
  for_each_run([&](const Toolpath&, const Trajectory& run, const Settings&) {
    for (const Part& part : testing::parts_of(run)) {
      const State state = testing::state_in(run, part, part.duration / 2);
      const bool blend = run.path().kind(state.element) == ElementKind::blend;
      // the law on a blend is checked once a sample: a little more is possible in between, and right behind
      // it
      const double slack = blend ? 1.01 : 1.001;
      ASSERT_LE(state.speed, state.programmed_feed * slack) << "part at " << part.time;
      for (int j = 0; j < 3; ++j) {
        ASSERT_LE(std::abs(state.velocity[j]), machine.axes[static_cast<std::size_t>(j)].velocity * slack);
      }
    }
  });
}

TEST_P(EssidOnRandomPaths, KeepsAccelerationAndJerkOfEveryAxisOnLines) {
  const Machine machine = testing::spinner();
  for_each_run([&](const Toolpath&, const Trajectory& run, const Settings&) {
    testing::expect_axis_limits_on_lines(run, machine);
  });
}

TEST_P(EssidOnRandomPaths, KeepsTheAxisAccelerationOnBlendsAndTheBlendJerkAboutTwiceOver) {
  // Radial and tangential shares add up to the acceleration; eq 26 lets the radial jerk share be exceeded.
  const Machine machine = testing::spinner();
  for_each_run([&](const Toolpath&, const Trajectory& run, const Settings&) {
    for (const Part& part : testing::parts_of(run)) {
      const State state = testing::state_in(run, part, part.duration / 2);
      if (run.path().kind(state.element) != ElementKind::blend) {
        continue;
      }
      for (int j = 0; j < 3; ++j) {
        const AxisLimits& axis = machine.axes[static_cast<std::size_t>(j)];
        ASSERT_LE(std::abs(state.acceleration[j]), axis.acceleration * 1.01) << "part at " << part.time;
        ASSERT_LE(std::abs(state.jerk[j]), axis.blend_jerk * 2.2) << "part at " << part.time;
      }
    }
  });
}

TEST_P(EssidOnRandomPaths, IsNeverFasterThanTheProgrammedFeeds) {
  const ControlModel& cam = find_model("cam");
  for_each_run([&](const Toolpath& path, const Trajectory& run, const Settings&) {
    const double promised =
        cam.simulate(path, testing::spinner(), complete_settings(cam, testing::spinner())).duration();
    // blends shorten the path a little
    ASSERT_GE(run.duration(), 0.9 * promised);
  });
}

TEST_P(EssidOnRandomPaths, GivesTheSameBytesAgain) {
  std::mt19937 random(10);
  const Toolpath path = testing::random_path(random, 200);
  const ControlModel& essid = find_model("essid");
  Settings settings = testing::spinner_settings(essid);
  settings.set("reading", std::string(GetParam()));
  const Trajectory a = essid.simulate(path, testing::spinner(), settings);
  const Trajectory b = essid.simulate(path, testing::spinner(), settings);
  ASSERT_EQ(a.pieces().size(), b.pieces().size());
  EXPECT_EQ(a.duration(), b.duration());
}

INSTANTIATE_TEST_SUITE_P(Readings, EssidOnRandomPaths, ::testing::Values("corrected", "published", "strict"),
                         [](const auto& reading) { return std::string(reading.param); });

}  // namespace
}  // namespace feedscope

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/models/control_model.h"
#include "tests/support/parts.h"
#include "tests/support/paths.h"

namespace feedscope {
namespace {

/// What must hold on any path beyond what tests/contract looks at: corner tables, and how far blends go where
/// the model promises nothing.
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
      check(essid.simulate(path, testing::spinner(), settings), settings);
      if (HasFatalFailure()) {
        return;
      }
    }
  }
};

TEST_P(EssidOnRandomPaths, KeepsTheContourToleranceAtEveryCorner) {
  for_each_run([](const Trajectory& run, const Settings& settings) {
    for (const BlendRecord& blend : testing::blends_of(run)) {
      ASSERT_LE(blend.epsilon, settings.number("contour_tolerance_mm"));
      ASSERT_GT(blend.min_radius, 0);
    }
  });
}

TEST_P(EssidOnRandomPaths, KeepsTheAxisAccelerationOnBlendsAndTheBlendJerkAboutTwiceOver) {
  // Radial and tangential shares add up to the acceleration; eq 26 lets the radial jerk share be exceeded.
  const Machine machine = testing::spinner();
  for_each_run([&](const Trajectory& run, const Settings&) {
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

INSTANTIATE_TEST_SUITE_P(Readings, EssidOnRandomPaths, ::testing::Values("corrected", "published", "strict"),
                         [](const auto& reading) { return std::string(reading.param); });

}  // namespace
}  // namespace feedscope

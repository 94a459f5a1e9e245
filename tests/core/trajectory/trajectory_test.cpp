#include "core/trajectory/trajectory.h"

#include <gtest/gtest.h>

#include <random>

#include "core/models/control_model.h"
#include "tests/support/parts.h"
#include "tests/support/paths.h"

namespace feedscope {
namespace {

Trajectory essid_run(const Toolpath& path) {
  const ControlModel& model = find_model("essid");
  return model.simulate(path, testing::spinner(), testing::spinner_settings(model));
}

TEST(Trajectory, AnEmptyOneIsAtRestAtTheOrigin) {
  const State state = Trajectory().state(1);
  EXPECT_EQ(state.position, Vec3::Zero());
  EXPECT_EQ(state.speed, 0);
}

TEST(Trajectory, TimesOutsideAreClampedToItsEnds) {
  const Trajectory run = essid_run(testing::polyline(testing::essid_table1(), 50));
  EXPECT_LT((run.state(-1).position - Vec3(0, 0, 0)).norm(), 1e-12);
  EXPECT_LT((run.state(1e9).position - Vec3(26.389, 21.213, 0)).norm(), 1e-9);
  EXPECT_LT(run.state(1e9).speed, 1e-6);
}

TEST(Trajectory, StateIsTheDerivativeOfItself) {
  std::mt19937 random(6);
  for (int i = 0; i < 20; ++i) {
    const Trajectory run = essid_run(testing::random_path(random, 12));
    for (const Part& part : testing::parts_of(run)) {
      const double duration = part.duration;
      const double h = duration * 1e-4;
      const double tau = duration * 0.43;
      const State at = testing::state_in(run, part, tau);
      const State before = testing::state_in(run, part, tau - h);
      const State after = testing::state_in(run, part, tau + h);
      // Central differences: relative error of the order of (h / duration)^2, plus rounding over h.
      const auto near = [&](const Vec3& low, const Vec3& high, const Vec3& exact, double rounding) {
        return ((high - low) / (2 * h) - exact).norm() <= 1e-4 * exact.norm() + rounding / h;
      };
      ASSERT_TRUE(near(before.position, after.position, at.velocity, 1e-11)) << i << ' ' << part.time;
      ASSERT_TRUE(near(before.velocity, after.velocity, at.acceleration, 1e-11 * (1 + at.speed)));
      ASSERT_TRUE(
          near(before.acceleration, after.acceleration, at.jerk, 1e-11 * (1 + at.acceleration.norm())));
      ASSERT_NEAR(at.velocity.norm(), at.speed, 1e-9 * (1 + at.speed));
      if (at.speed > 1e-6) {
        ASSERT_NEAR(at.acceleration.dot(at.velocity) / at.speed, at.tangential_acceleration,
                    1e-6 * (1 + at.acceleration.norm()));
      }
    }
  }
}

TEST(Trajectory, StateAtPathIsTheInverseOfPathLength) {
  std::mt19937 random(7);
  const Trajectory run = essid_run(testing::random_path(random, 60));
  for (int i = 0; i <= 500; ++i) {
    const double s = run.path_length() * i / 500;
    EXPECT_NEAR(run.state_at_path(s).path_length, s, 1e-8 * (1 + s));
  }
}

TEST(Trajectory, PathLengthNeverFallsWithTime) {
  std::mt19937 random(8);
  const Trajectory run = essid_run(testing::random_path(random, 60));
  double last = 0;
  for (int i = 0; i <= 5000; ++i) {
    const double s = run.state(run.duration() * i / 5000).path_length;
    ASSERT_GE(s, last - 1e-9);
    last = s;
  }
}

TEST(Trajectory, TimeOfLineIsWhereItsBlockBegins) {
  const Trajectory run = essid_run(testing::polyline(testing::essid_table1(), 50));
  EXPECT_EQ(run.time_of_line(1), 0);
  const double third = run.time_of_line(3);
  EXPECT_EQ(run.state(third).line, 3u);
  EXPECT_LT(run.state(third - 1e-6).line, 3u);
  EXPECT_EQ(run.time_of_line(99), run.duration());
}

}  // namespace
}  // namespace feedscope

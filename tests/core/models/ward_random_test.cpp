#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/analysis/contour/contour_errors.h"
#include "core/models/control_model.h"
#include "core/trajectory/filtered_corner.h"
#include "tests/support/parts.h"
#include "tests/support/paths.h"

namespace feedscope {
namespace {

/// What must hold on any path, with two and with three filters.
class WardOnRandomPaths : public ::testing::TestWithParam<int> {
 protected:
  static constexpr int runs = 60;
  static constexpr double tolerance = 0.01;

  static Trajectory run(const Toolpath& path) {
    const ControlModel& ward = find_model("ward");
    Settings settings = testing::spinner_settings(ward);
    settings.set("contour_tolerance_mm", tolerance);
    settings.set("filters", double(GetParam()));
    return ward.simulate(path, testing::spinner(), settings);
  }

  template <typename F>
  void for_each_run(F check) {
    std::mt19937 random(19);
    for (int i = 0; i < runs; ++i) {
      SCOPED_TRACE(i);
      const Toolpath path = testing::random_path(random, 1 + 2 * i);
      check(path, run(path));
      if (HasFatalFailure()) {
        return;
      }
    }
  }
};

TEST_P(WardOnRandomPaths, PathVelocityAndAccelerationHaveNoGaps) {
  for_each_run([](const Toolpath&, const Trajectory& run) {
    const std::vector<Part> parts = testing::parts_of(run);
    for (std::size_t p = 0; p + 1 < parts.size(); ++p) {
      const State end = testing::state_in(run, parts[p], parts[p].duration);
      const State next = testing::state_in(run, parts[p + 1], 0);
      ASSERT_LT((end.position - next.position).norm(), 1e-9) << "part at " << parts[p].time;
      ASSERT_LT((end.velocity - next.velocity).norm(), 1e-7 * (1 + end.speed)) << "part at " << parts[p].time;
      ASSERT_LT((end.acceleration - next.acceleration).norm(),
                1e-5 * (1 + end.acceleration.norm()) + 1e-14 * end.time * 15000)
          << "part at " << parts[p].time;
      ASSERT_NEAR(end.path_length, next.path_length, 1e-7 * (1 + end.path_length))
          << "part at " << parts[p].time;
      ASSERT_TRUE(end.jerk.allFinite() && std::isfinite(end.tangential_jerk));
    }
  });
}

TEST_P(WardOnRandomPaths, BeginsAndEndsAtTheProgrammedPointsAtRest) {
  for_each_run([](const Toolpath& path, const Trajectory& run) {
    ASSERT_LT((run.state(0).position - path.start).norm(), 1e-9);
    const State end = run.state(run.duration());
    ASSERT_LT((end.position - path.segments.back().end).norm(), 1e-9);
    ASSERT_LT(end.speed, 1e-6);
  });
}

TEST_P(WardOnRandomPaths, KeepsTheContourToleranceAtEveryCorner) {
  for_each_run([](const Toolpath&, const Trajectory& run) {
    for (const BlendRecord& blend : testing::blends_of(run)) {
      ASSERT_LE(blend.epsilon, tolerance * (1 + 1e-5)) << "line " << blend.line;
    }
  });
}

TEST_P(WardOnRandomPaths, KeepsTheContourToleranceOnArcs) {
  for_each_run([](const Toolpath&, const Trajectory& run) {
    constexpr double between_watched_places = 1.005;
    for (const FilteredMotion& motion : run.motions()) {
      ASSERT_LE(motion.contour_error(), tolerance * (1 + 1e-5));
    }
    ASSERT_LE(contour_errors(run).largest, tolerance * between_watched_places);
  });
}

TEST_P(WardOnRandomPaths, NoiseOfAPicometreChangesNoTime) {
  std::mt19937 random(23);
  std::uniform_real_distribution<double> noise(-1e-9, 1e-9);
  for_each_run([&](const Toolpath& path, const Trajectory& exact) {
    Toolpath moved = path;
    for (std::size_t i = 0; i < moved.segments.size(); ++i) {
      const auto is_line = [&](std::size_t k) {
        return k >= moved.segments.size() || moved.segments[k].kind == SegmentKind::line;
      };
      if (is_line(i) && is_line(i + 1)) {
        moved.segments[i].end += Vec3(noise(random), noise(random), noise(random));
      }
      if (is_line(i)) {
        moved.segments[i].length = (moved.segments[i].end - moved.start_of(i)).norm();
      }
    }
    ASSERT_NEAR(run(moved).duration(), exact.duration(), 1e-5 * exact.duration());
  });
}

TEST_P(WardOnRandomPaths, KeepsTheAxisVelocities) {
  const Machine machine = testing::spinner();
  for_each_run([&](const Toolpath&, const Trajectory& run) {
    for (const Part& part : testing::parts_of(run)) {
      const State state = testing::state_in(run, part, part.duration / 2);
      for (int j = 0; j < 3; ++j) {
        ASSERT_LE(std::abs(state.velocity[j]),
                  machine.axes[static_cast<std::size_t>(j)].velocity * (1 + 1e-9));
      }
    }
  });
}

TEST_P(WardOnRandomPaths, StateIsTheDerivativeOfItselfAndOfThePathLength) {
  for_each_run([](const Toolpath&, const Trajectory& run) {
    double largest = 0;  // the quadrature's measure [mm/s]
    for (const FilteredMotion& motion : run.motions()) {
      largest = std::max(largest, motion.train().largest_feed);
    }
    for (const Part& part : testing::parts_of(run)) {
      const double duration = part.duration;
      const double h = duration * 1e-4;
      const State at = testing::state_in(run, part, duration * 0.43);
      const State before = testing::state_in(run, part, duration * 0.43 - h);
      const State after = testing::state_in(run, part, duration * 0.43 + h);
      const FilteredMotion& motion = run.motion_of(at.element);
      const double jerk = 4 * largest / (motion.filter_time() * motion.filter_time());  // knots in between
      const auto near = [&](const Vec3& low, const Vec3& high, const Vec3& exact, double change,
                            double rounding) {
        return ((high - low) / (2 * h) - exact).norm() <= 1e-4 * exact.norm() + change + rounding / h;
      };
      ASSERT_TRUE(near(before.position, after.position, at.velocity, jerk * h * h,
                       1e-11 + 1e-15 * at.time * at.speed))
          << part.time;
      ASSERT_TRUE(near(before.velocity, after.velocity, at.acceleration, jerk * h,
                       1e-11 * (1 + at.speed) + 1e-15 * at.time * at.acceleration.norm()));
      ASSERT_NEAR((after.path_length - before.path_length) / (2 * h), at.speed,
                  1e-4 * (at.speed + at.acceleration.norm() * duration + jerk * duration * duration) +
                      (1e-11 * (1 + at.path_length) + 1e-9 * largest * duration) / h)
          << part.time;
    }
  });
}

TEST_P(WardOnRandomPaths, StateAtPathIsTheInverseOfPathLength) {
  for_each_run([](const Toolpath&, const Trajectory& run) {
    for (int i = 0; i <= 100; ++i) {
      const double s = run.path_length() * i / 100;
      ASSERT_NEAR(run.state_at_path(s).path_length, s, 1e-7 * (1 + s));
    }
  });
}

TEST_P(WardOnRandomPaths, TakesTheCommandedTimeAndTheDelayOfEveryStretch) {
  for_each_run([](const Toolpath&, const Trajectory& run) {
    double total = 0;
    for (const FilteredMotion& motion : run.motions()) {
      EXPECT_NEAR(motion.start(), total, 1e-9 * (1 + total));
      total += motion.train().end() + GetParam() * motion.filter_time();
    }
    ASSERT_NEAR(run.duration(), total, 1e-9 * (1 + total));
  });
}

TEST_P(WardOnRandomPaths, GivesTheSameBytesAgain) {
  std::mt19937 random(10);
  const Toolpath path = testing::random_path(random, 200);
  const Trajectory a = run(path);
  const Trajectory b = run(path);
  ASSERT_EQ(a.pieces().size(), b.pieces().size());
  EXPECT_EQ(a.duration(), b.duration());
  EXPECT_EQ(a.path_length(), b.path_length());
}

INSTANTIATE_TEST_SUITE_P(Filters, WardOnRandomPaths, ::testing::Values(2, 3),
                         [](const auto& filters) { return std::to_string(filters.param); });

}  // namespace
}  // namespace feedscope

#include "core/analysis/run/peak_search.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "core/analysis/run/run.h"
#include "core/analysis/run/summary.h"
#include "core/trajectory/state_walk.h"
#include "tests/core/analysis/hand_made_run.h"
#include "tests/support/paths.h"
#include "tests/support/random_cases.h"

namespace feedscope {
namespace {

PeakSearch peaks_of(const Trajectory& trajectory) {
  PeakSearch peaks;
  for (PartWalk walk(trajectory); !walk.done(); walk.next()) {
    peaks.add(trajectory, walk.part());
  }
  return peaks;
}

/// Largest magnitudes at instants `step` [s] apart, at the ends of all parts, and where pulses in filters
/// change, at which their jerk has kinks.
struct Sampled {
  double speed = 0;
  AxisVector<AxisPeaks> axes;

  Sampled(const Trajectory& trajectory, double step) {
    StateWalk walk(trajectory);
    for (double time = 0; time < trajectory.duration(); time += step) {
      const State state = walk.at_without_length(time);
      add({state.position, state.velocity, state.acceleration, state.jerk});
    }
    for (PartWalk parts(trajectory); !parts.done(); parts.next()) {
      const PartMotion motion = parts.motion();
      add(motion.kinematics(0));
      add(motion.kinematics(parts.part().duration));
    }
    for (const FilteredMotion& motion : trajectory.motions()) {
      FilterWalk filters;
      for (double time = 0; time < motion.duration();) {
        time = filters.next_knot(motion.train(), time);
        add(motion.at(std::min(time, motion.duration())));
      }
    }
  }

 private:
  void add(const Kinematics& at) {
    speed = std::max(speed, at.velocity.norm());
    for (std::size_t i = 0; i < 3; ++i) {
      const auto axis = static_cast<Eigen::Index>(i);
      axes[i].add(at.velocity[axis], at.acceleration[axis], at.jerk[axis]);
    }
  }
};

Trajectory on_arc(double radius, const feedscope::testing::Passage& run, double sweep) {
  Toolpath path;
  path.start = Vec3(radius, 0, 0);
  feedscope::testing::append_arc(path, Vec3::Zero(), sweep, 50);
  return feedscope::testing::trajectory_of(path, {run}, Vec3::Constant(500));
}

TEST(PeakSearch, FindsThePeaksOfACircleExactly) {
  // Steady v on radius r: v on each axis, v^2/r, v^3/r^2, wherever the axis is along or across the motion.
  const double turn = 2 * std::numbers::pi;
  const PeakSearch peaks = peaks_of(on_arc(10, {{0, 0, 50, 0, 0, 0, {}}, 10 * turn / 50}, turn));
  for (const std::size_t axis : {0U, 1U}) {
    EXPECT_NEAR(peaks.axes()[axis].velocity, 50, 1e-9);
    EXPECT_NEAR(peaks.axes()[axis].acceleration, 250, 1e-8);
    EXPECT_NEAR(peaks.axes()[axis].jerk, 1250, 1e-7);
  }
  EXPECT_NEAR(peaks.speed(), 50, 1e-12);
}

TEST(PeakSearch, FindsTheAccelerationOfAnArcThatSpeedsUp) {
  // From rest with a along the arc, v^2 = 2 a s and s = r phi: of X -a (sin phi + 2 phi cos phi), which is
  // largest where 3 cos phi = 2 phi sin phi.
  const double a = 100;
  const double radius = 5;
  const double sweep = std::numbers::pi / 2;
  const double duration = std::sqrt(2 * radius * sweep / a);
  double low = 0;
  double high = 1.5;
  for (int i = 0; i < 60; ++i) {
    const double phi = (low + high) / 2;
    (3 * std::cos(phi) > 2 * phi * std::sin(phi) ? low : high) = phi;
  }
  const double largest = a * (std::sin(low) + 2 * low * std::cos(low));
  const PeakSearch peaks = peaks_of(on_arc(radius, {{0, 0, 0, a, 0, 0, {}}, duration}, sweep));
  EXPECT_NEAR(peaks.axes()[0].acceleration, largest, 1e-8 * largest);
}

/// Programs of seconds, on shipped machines with every model: nothing that is sampled is above a peak, and a
/// peak is no more than 0.1 % above what is sampled.
class PeaksOfModels : public ::testing::TestWithParam<std::string> {};

TEST_P(PeaksOfModels, AreThoseOfCloseSamples) {
  constexpr double step = 1e-5;  // [s]
  constexpr double longest = 4;  // [s]
  const ControlModel& model = find_model(GetParam());
  const MachineLibrary library = shipped_machines();
  std::mt19937 random(53);
  const int programs = test::random_cases(GetParam() == "optimal" ? 24 : 96);
  for (int i = 0; i < programs; ++i) {
    const Toolpath path = feedscope::testing::random_path(random, 12);
    for (const char* id : {"spinner-mvc850", "huron-kx10", "dmg-mori-evo40"}) {
      const Machine machine = library.load(id);
      const Trajectory run = model.simulate(path, machine, complete_settings(model, machine));
      if (run.duration() > longest) {
        continue;
      }
      const PeakSearch peaks = peaks_of(run);
      const Sampled sampled(run, step);
      const auto check = [&](double peak, double sample, const char* what, std::size_t axis) {
        EXPECT_GE(peak, sample * (1 - 1e-9)) << what << ' ' << axis << ", program " << i << " on " << id;
        EXPECT_LE(peak, sample * 1.001 + 1e-9) << what << ' ' << axis << ", program " << i << " on " << id;
      };
      check(peaks.speed(), sampled.speed, "speed", 0);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        check(peaks.axes()[axis].velocity, sampled.axes[axis].velocity, "velocity", axis);
        check(peaks.axes()[axis].acceleration, sampled.axes[axis].acceleration, "acceleration", axis);
        check(peaks.axes()[axis].jerk, sampled.axes[axis].jerk, "jerk", axis);
      }
    }
  }
}

std::vector<std::string> ids_of_models() {
  std::vector<std::string> ids;
  for (const ControlModel* model : all_models()) {
    ids.push_back(model->info().id);
  }
  return ids;
}

INSTANTIATE_TEST_SUITE_P(Models, PeaksOfModels, ::testing::ValuesIn(ids_of_models()),
                         [](const auto& model) { return model.param; });

}  // namespace
}  // namespace feedscope

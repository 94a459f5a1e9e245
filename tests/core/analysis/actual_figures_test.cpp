#include "core/analysis/contour/actual_figures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/analysis/run/run.h"
#include "core/trajectory/state_walk.h"
#include "tests/support/paths.h"
#include "tests/support/random_cases.h"

namespace feedscope {
namespace {

Machine machine_with_drives(std::mt19937& random, bool rigid) {
  std::uniform_real_distribution<double> unit(0, 1);
  Machine machine = feedscope::testing::spinner();
  for (const char axis : {'X', 'Y', 'Z'}) {
    set_axis_value(machine, axis, "kv", 15 + 60 * unit(random));
    set_axis_value(machine, axis, "velocity_lag", 5 * unit(random));
    if (!rigid) {
      set_axis_value(machine, axis, "backlash", 10 * unit(random));
      set_axis_value(machine, axis, "friction_spike", 10 * unit(random));
      set_axis_value(machine, axis, "friction_time", 5 + 30 * unit(random));
    }
  }
  return machine;
}

/// What a CSV of small steps shows: its largest values are those of the figures, no more than 0.1 % below.
void expect_figures_of_close_samples(const std::shared_ptr<const Trajectory>& run, const Machine& machine) {
  constexpr double step = 2e-5;  // [s]
  const ActualPath path(run, machine);
  const ActualFigures figures = actual_figures(path);
  double error = 0;
  Vec3 following = Vec3::Zero();
  StateWalk states(*run);
  ActualSampler sampler(path);
  for (double time = 0; time < run->duration(); time += step) {
    const ActualSample sample = sampler.at(states.at_without_length(time));
    following = following.cwiseMax(sample.motion.following_error.cwiseAbs());
    error = sample.cuts ? std::max(error, sample.contour_error) : error;
  }
  constexpr double rounding = 1e-9;
  constexpr double below = 1e-3;
  EXPECT_GE(figures.worst.error, error * (1 - rounding));
  EXPECT_LE(figures.worst.error, error * (1 + below) + 1e-7);
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    EXPECT_GE(figures.largest_following_error[axis], following[axis] * (1 - rounding));
    EXPECT_LE(figures.largest_following_error[axis], following[axis] * (1 + below) + 1e-7);
  }
}

TEST(ActualFigures, AreThoseOfCloseSamples) {
  constexpr double longest = 4;  // [s]
  std::mt19937 random(55);
  const int programs = test::random_cases(96);
  for (int i = 0; i < programs; ++i) {
    SCOPED_TRACE(i);
    const Machine machine = machine_with_drives(random, i % 2 == 0);
    const ControlModel& model = find_model(i % 3 == 0 ? "ward" : i % 3 == 1 ? "msaddek" : "essid");
    const auto run = std::make_shared<const Trajectory>(model.simulate(
        feedscope::testing::random_path(random, 12), machine, complete_settings(model, machine)));
    if (run->duration() <= longest) {
      expect_figures_of_close_samples(run, machine);
    }
  }
}

/// Where a cut follows a rapid, the error is largest when the nearest programmed point comes to the cut.
TEST(ActualFigures, BeginBehindARapidWhereTheCutDoes) {
  std::mt19937 random(56);
  std::uniform_real_distribution<double> any(-30, 30);
  for (int i = 0; i < 12; ++i) {
    SCOPED_TRACE(i);
    const Machine machine = machine_with_drives(random, true);
    const ControlModel& model = find_model(i % 2 == 0 ? "msaddek" : "essid");
    Toolpath toolpath;
    for (int k = 0; k < 6; ++k) {
      feedscope::testing::append_line(toolpath, {any(random), any(random), 0}, k % 2 == 0 ? 0 : 100);
      toolpath.segments.back().rapid = k % 2 == 0;
    }
    expect_figures_of_close_samples(std::make_shared<const Trajectory>(
                                        model.simulate(toolpath, machine, complete_settings(model, machine))),
                                    machine);
  }
}

}  // namespace
}  // namespace feedscope

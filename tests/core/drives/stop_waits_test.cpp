#include "core/drives/stop_waits.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "core/base/units.h"
#include "core/drives/drive_response.h"
#include "core/models/control_model.h"
#include "tests/support/motion_checks.h"
#include "tests/support/paths.h"

namespace feedscope {
namespace {

constexpr double gain = 30;      // [1/s]
constexpr double window = 0.01;  // [mm]

Machine machine_with(double lag_ms) {
  Machine machine = testing::spinner();
  for (const char axis : {'X', 'Y', 'Z'}) {
    set_axis_value(machine, axis, "kv", gain);
    set_axis_value(machine, axis, "velocity_lag", lag_ms);
  }
  return machine;
}

/// Lines in random directions, all of them in exact stop mode with `stop_window`.
Toolpath stopping(int lines, ExactStopWindow stop_window) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> any(-20, 20);
  Toolpath path;
  for (int i = 0; i < lines; ++i) {
    testing::append_line(path, {any(random), any(random), any(random)}, units::from_m_min(6));
  }
  PathControl control;
  control.mode = PathMode::exact_stop;
  control.exact_stop_window = stop_window;
  path.path_controls.push_back(control);
  for (Segment& segment : path.segments) {
    segment.path_control = 1;
  }
  return path;
}

struct Rest {
  double begin = 0, end = 0;  // [s]
};

std::vector<Rest> rests(const Trajectory& motion) {
  std::vector<Rest> found;
  for (std::size_t i = 0; i < motion.pieces().size(); ++i) {
    const Piece& piece = motion.pieces()[i];
    if (piece.cause.kind == CauseKind::exact_stop && piece.law == Law::path_length && piece.v == 0 &&
        piece.a == 0 && piece.j == 0) {
      found.push_back({piece.time, motion.piece_end(i)});
    }
  }
  return found;
}

class StopWaits : public ::testing::TestWithParam<const char*> {
 protected:
  static Trajectory run(const Toolpath& path, const Machine& machine, double window_mm) {
    const ControlModel& model = find_model(GetParam());
    Settings settings = testing::spinner_settings(model);
    if (window_mm > 0) {
      settings.set(exact_stop_window_key, units::to_um(window_mm));
    }
    return model.simulate(path, machine, settings);
  }
};

/// A first-order drive that is e behind when the set positions come to rest: t = ln(e/w) / Kv.
TEST_P(StopWaits, LastAsTheClosedFormSays) {
  const Toolpath path = stopping(12, ExactStopWindow::fine);
  const Machine machine = machine_with(0);
  const auto motion = std::make_shared<const Trajectory>(run(path, machine, window));
  const DriveResponse response(motion, machine);
  const std::vector<Rest> waits = rests(*motion);
  ASSERT_EQ(waits.size(), path.segments.size());
  double sum = 0;
  for (const Rest& wait : waits) {
    const Vec3 behind = response.at(wait.begin).following_error;
    EXPECT_NEAR(wait.end - wait.begin, std::log(behind.cwiseAbs().maxCoeff() / window) / gain, 1e-7);
    EXPECT_NEAR(response.at(wait.end).following_error.cwiseAbs().maxCoeff(), window, 1e-7);
    sum += wait.end - wait.begin;
  }
  EXPECT_NEAR(motion->duration(), run(path, machine, 0).duration() + sum, 1e-9);
  testing::expect_no_gaps_between_pieces(*motion);
}

/// Times of pieces and of the spans that drives follow are sums of different parts; where round numbers make
/// them differ by rounding, the wait is still that of the following error at the end.
TEST_P(StopWaits, DoNotDependOnTheRoundingOfTimes) {
  for (const double feed : {3.0, 4.2, 6.0}) {  // [m/min]
    Toolpath path = stopping(0, ExactStopWindow::fine);
    for (const Vec3& end :
         {Vec3(50, 0, 0), Vec3(50, 30, 0), Vec3(20, 10, 0), Vec3(20, 10, 7), Vec3(0.3, 10, 7)}) {
      testing::append_line(path, end, units::from_m_min(feed));
      path.segments.back().path_control = 1;
    }
    const Machine machine = machine_with(0);
    const auto motion = std::make_shared<const Trajectory>(run(path, machine, window));
    const DriveResponse response(motion, machine);
    const std::vector<Rest> waits = rests(*motion);
    ASSERT_EQ(waits.size(), path.segments.size());
    for (const Rest& wait : waits) {
      EXPECT_NEAR(response.at(wait.end).following_error.cwiseAbs().maxCoeff(), window, 1e-7) << feed;
    }
  }
}

/// The motion between the waits is that without them.
TEST_P(StopWaits, LeaveTheMotionAsItIs) {
  const Toolpath path = stopping(8, ExactStopWindow::coarse);
  const Machine machine = machine_with(0);
  const Trajectory waiting = run(path, machine, window);
  const Trajectory plain = run(path, machine, 0);
  const std::vector<Rest> waits = rests(waiting);
  for (int k = 0; k <= 400; ++k) {
    const double time = plain.duration() * k / 400;
    double later = 0;
    for (const Rest& wait : waits) {
      later += wait.begin - later <= time ? wait.end - wait.begin : 0;
    }
    const State a = plain.state(time);
    const State b = waiting.state(time + later);
    ASSERT_LT((a.position - b.position).norm(), 1e-7) << time;
    ASSERT_NEAR(a.path_length, b.path_length, 1e-7);
    ASSERT_EQ(a.line, b.line);
  }
}

/// Also where the velocity loop lags: every motor comes into the window.
TEST_P(StopWaits, EndWithinTheWindow) {
  const Machine machine = machine_with(12);
  const auto motion =
      std::make_shared<const Trajectory>(run(stopping(12, ExactStopWindow::machine), machine, window));
  const DriveResponse response(motion, machine);
  ASSERT_FALSE(rests(*motion).empty());
  for (const Rest& wait : rests(*motion)) {
    EXPECT_LT(response.at(wait.end).following_error.cwiseAbs().maxCoeff(), 1.2 * window);
  }
}

/// With G603, in continuous mode but for the end, and without drives or a window there is none.
TEST_P(StopWaits, OnlyWhereTheControlChecks) {
  const Machine machine = machine_with(0);
  EXPECT_EQ(rests(run(stopping(5, ExactStopWindow::interpolation_end), machine, window)).size(), 1U)
      << "the end";
  Toolpath path = stopping(5, ExactStopWindow::fine);
  for (Segment& segment : path.segments) {
    segment.path_control = 0;
  }
  EXPECT_EQ(rests(run(path, machine, window)).size(), 1U) << "the end";
  const Toolpath stops = stopping(5, ExactStopWindow::fine);
  EXPECT_TRUE(rests(run(stops, testing::spinner(), window)).empty());
  EXPECT_EQ(run(stops, testing::spinner(), window).duration(), run(stops, testing::spinner(), 0).duration());
  testing::append_dwell(path, 0.5);
  testing::append_line(path, {0, 0, 0}, units::from_m_min(6));
  EXPECT_EQ(rests(run(path, machine, window)).size(), 2U) << "before the pause, too";
}

INSTANTIATE_TEST_SUITE_P(Models, StopWaits,
                         ::testing::Values("tapie", "essid", "gassara", "msaddek", "ward", "optimal"),
                         [](const auto& info) { return std::string(info.param); });

/// Braked evenly by a, an axis ends a/Kv^2 behind.
TEST(StopWaitsAfterEvenBraking, BeginFromTheAccelerationByTheGainSquared) {
  Machine machine = machine_with(0);
  const double acceleration = 2;  // [m/s2]
  set_axis_limit(machine, 'X', "acceleration", acceleration);
  set_axis_limit(machine, 'X', "jerk", 1e6);
  Toolpath path;
  testing::append_line(path, {500, 0, 0}, units::from_m_min(30));
  const ControlModel& model = find_model("tapie");
  Settings settings = testing::spinner_settings(model);
  settings.set(exact_stop_window_key, units::to_um(window));
  const Trajectory motion = model.simulate(path, machine, settings);
  const std::vector<Rest> waits = rests(motion);
  ASSERT_EQ(waits.size(), 1U);
  const double behind = 1000 * acceleration / (gain * gain);  // [mm]
  // A hundredth of it more or less: the braking lasts 0.25 s, and begins 16.7 mm behind, of which exp(-7.5)
  // are left.
  EXPECT_NEAR(waits[0].end - waits[0].begin, std::log(behind / window) / gain, 1e-2 / gain);
}

}  // namespace
}  // namespace feedscope

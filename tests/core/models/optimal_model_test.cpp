#include "core/models/optimal/optimal_model.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/base/error.h"
#include "core/base/units.h"
#include "core/models/optimal/acceleration_law.h"
#include "core/models/optimal/filtered_path.h"
#include "tests/support/motion_checks.h"
#include "tests/support/paths.h"

namespace feedscope {
namespace {

Settings settings_on(const std::string& path, const Machine& machine) {
  const ControlModel& optimal = find_model("optimal");
  Settings settings = complete_settings(optimal, machine);
  settings.set("path", path);
  settings.set("jerk", std::string("off"));
  return settings;
}

Machine spinner_as_published() {
  Machine machine = testing::spinner();
  machine.settings = testing::spinner_settings(find_model("essid"));
  return machine;
}

Trajectory optimal_run(const Toolpath& path, const std::string& model = "tapie",
                       const Machine& machine = spinner_as_published()) {
  return find_model("optimal").simulate(path, machine, settings_on(model, machine));
}

Toolpath circle(double radius, double feed) {
  Toolpath path;
  path.start = Vec3(radius, 0, 0);
  testing::append_arc(path, Vec3::Zero(), 2 * units::pi, feed);
  return path;
}

/// On the path of `model`, with cells `fineness` times as fine as usual.
double time_with_cells(const Toolpath& path, const Machine& machine, const std::string& model, int fineness) {
  const AxisVectors axes(machine);
  const Trajectory run = find_model(model).simulate(path, machine, settings_on(model, machine));
  const bool filtered = !run.motions().empty();
  TrajectoryBuilder builder =
      filtered ? TrajectoryBuilder(run.path().programmed(), axes.velocity) : TrajectoryBuilder(run);
  if (filtered) {
    FilteredPath(run, axes, FilteredPath::usual_error, builder).lay();
  }
  AccelerationLaw law(axes, fineness, builder);
  ProgressSteps steps(nullptr, 1);
  law.run(0, static_cast<std::uint32_t>(builder.path().size()), steps);
  return builder.finish().duration();
}

TEST(OptimalModel, RunsALineAsATrapezoid) {
  // 100 mm at 50 mm/s with 1000 mm/s2: L / F + F / A.
  const Trajectory run = optimal_run(testing::polyline({{0, 0, 0}, {100, 0, 0}}, 50));
  EXPECT_NEAR(run.duration(), 100.0 / 50 + 50.0 / 1000, 1e-12);
  EXPECT_EQ(cause_key(run.state(0.01).cause), "axis_acceleration_x");
  EXPECT_EQ(cause_key(run.state(1).cause), "programmed_feed");
  EXPECT_EQ(cause_key(run.state(2.04).cause), "ramp_down");
}

TEST(OptimalModel, RunsALineOfFilteredMotionAsATrapezoid) {
  const Trajectory run = optimal_run(testing::polyline({{0, 0, 0}, {100, 0, 0}}, 50), "ward");
  EXPECT_NEAR(run.duration(), 100.0 / 50 + 50.0 / 1000, 1e-9);
}

TEST(OptimalModel, RunsThePathOfFilteredMotionFasterThanTheFiltersAndWithinTheLimits) {
  std::mt19937 random(31);
  const Machine machine = spinner_as_published();
  const Settings settings = settings_on("ward", machine);
  const Guarantees promised = find_model("optimal").guarantees(settings);
  for (int i = 0; i < 20; ++i) {
    const Toolpath path = testing::random_path(random, 5 + i);
    const Trajectory run = optimal_run(path, "ward");
    testing::expect_rest_at_the_programmed_ends(path, run);
    testing::expect_no_gaps_between_pieces(run);
    for (const Part& part : testing::parts_of(run)) {
      for (const double share : {0.0, 0.3, 0.7, 1.0}) {
        const State state = testing::state_in(run, part, share * part.duration);
        for (int j = 0; j < 3; ++j) {
          ASSERT_LE(std::abs(state.acceleration[j]), machine.axes[static_cast<std::size_t>(j)].acceleration *
                                                         promised.arcs.acceleration.factor)
              << "part at " << part.time << " of path " << i;
        }
      }
    }
  }
}

TEST(OptimalModel, RunsAShortLineAsATriangle) {
  // Both axes accelerate with 1000 mm/s2: sqrt(2) of it along the diagonal.
  const Trajectory run = optimal_run(testing::polyline({{0, 0, 0}, {3, 3, 0}}, 1000));
  EXPECT_NEAR(run.duration(), 2 * std::sqrt(3.0 / 1000), 1e-12);
}

TEST(OptimalModel, PassesCollinearBlocksAsOneLine) {
  const Trajectory one = optimal_run(testing::polyline({{0, 0, 0}, {40, 30, 0}}, 50));
  const Trajectory four = optimal_run(
      testing::polyline({{0, 0, 0}, {4, 3, 0}, {4.0004, 3.0003, 0}, {28, 21, 0}, {40, 30, 0}}, 50));
  EXPECT_NEAR(one.duration(), four.duration(), 1e-9);
}

TEST(OptimalModel, RunsACircleAtTheFeedWhereTheAxesAllowIt) {
  // v^2 / R = 50 mm/s2 of 1000: only starting and stopping take longer than the feed, each about F / (2 A).
  const Trajectory run = optimal_run(circle(50, 50));
  EXPECT_NEAR(run.duration(), 2 * units::pi * 50 / 50 + 50.0 / 1000, 2e-4);
  EXPECT_EQ(cause_key(run.state(run.duration() / 2).cause), "programmed_feed");
}

TEST(OptimalModel, RunsACircleAtTheRadialAccelerationOfTheAxes) {
  // Far from both ends, x = A R: every axis reaches its limit in turn; in between the other one leaves room
  // to go faster, so that the mean lies above sqrt(A R).
  const double steady = std::sqrt(1000.0 * 10);
  Toolpath path = circle(10, 1e4);
  for (int i = 0; i < 4; ++i) {
    testing::append_arc(path, Vec3::Zero(), 2 * units::pi, 1e4);
  }
  const Trajectory run = optimal_run(path);
  const State crossing = run.state_at_path(4 * units::pi * 10);
  EXPECT_NEAR(crossing.speed, steady, 0.01 * steady);
  EXPECT_LT(run.duration(), path.length() / steady + steady / 1000);
}

TEST(OptimalModel, SlowsALineDownToItsArc) {
  // A quarter of R 2 mm in mid-path: its ends, tangent along the axes, allow sqrt(A R).
  Toolpath path = testing::polyline({{0, 0, 0}, {100, 0, 0}}, 300);
  testing::append_arc(path, Vec3(100, 2, 0), units::pi / 2, 300);
  testing::append_line(path, Vec3(102, 102, 0), 300);
  const Trajectory run = optimal_run(path);
  const double corner = run.state_at_path(100).speed;
  EXPECT_NEAR(corner, std::sqrt(1000.0 * 2), 0.01 * corner);
  // Each line: up to 300 mm/s, down to `corner`.
  const double line = 300.0 / 1000 + (300 - corner) / 1000 +
                      (100 - 300.0 * 300 / 2000 - (300 * 300 - corner * corner) / 2000) / 300;
  const double arc = units::pi / corner;
  EXPECT_LT(run.duration(), 2 * line + arc * 1.001);
  EXPECT_GT(run.duration(), 2 * line + arc * 0.8);
}

TEST(OptimalModel, StopsAtKinksReversalsAndDwellsOnly) {
  Toolpath path = testing::polyline({{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {10, 5, 0}}, 50);
  testing::append_dwell(path, 0.25);
  testing::append_line(path, Vec3(10, 0, 0), 50);
  const auto line = [](double length) { return length / 50 + 0.05; };
  EXPECT_NEAR(optimal_run(path).duration(), 2 * line(10) + 2 * line(5) + 0.25, 1e-9);
}

TEST(OptimalModel, HalvingTheCellsChangesTheTimeByLessThanAThousandth) {
  const Machine spinner = spinner_as_published();
  const Machine mikron = testing::mikron();
  const auto check = [](const Toolpath& path, const Machine& machine, const std::string& model) {
    const double usual = time_with_cells(path, machine, model, 1);
    EXPECT_NEAR(time_with_cells(path, machine, model, 2), usual, 1e-3 * usual) << model;
  };
  check(testing::polyline(testing::essid_table1(), 50), spinner, "essid");
  check(testing::polyline(testing::essid_table1(), 50), spinner, "gassara");
  check(testing::polyline(testing::essid_spline(), 50), spinner, "essid");
  check(testing::polyline(testing::essid_spline(), 50), spinner, "msaddek");
  check(testing::polyline(testing::essid_table1(), 50), spinner, "ward");
  check(testing::polyline(testing::essid_spline(), 50), spinner, "ward");
  check(testing::spiral(10, 5, 5, 0, units::pi, 100), mikron, "tapie");
  check(testing::spiral(10, 5, 5, 0, units::pi, 100), mikron, "ward");
  check(circle(30, 100), mikron, "tapie");
  check(circle(2.5, 100), mikron, "tapie");
}

TEST(OptimalModel, IsNeverSlowerThanTheModelWhosePathItRuns) {
  std::mt19937 random(7);
  const Machine machine = testing::mikron();
  for (int i = 0; i < 60; ++i) {
    const Toolpath path = testing::random_path(random, 1 + i);
    for (const std::string model : {"essid", "gassara", "tapie", "msaddek"}) {
      const Settings settings = settings_on(model, machine);
      const double bound = find_model("optimal").simulate(path, machine, settings).duration();
      // The junctions of arcs are tangent to 0.01 rad only, in every model.
      ASSERT_LE(bound, find_model(model).simulate(path, machine, settings).duration() * (1 + 1e-6))
          << model << ", program " << i;
    }
  }
}

TEST(OptimalModel, KeepsFeedVelocityAndAccelerationOnRandomPaths) {
  std::mt19937 random(11);
  const Machine machine = testing::mikron();
  for (int i = 0; i < 60; ++i) {
    const Toolpath path = testing::random_path(random, 1 + i);
    const Settings settings = settings_on(i % 2 == 0 ? "essid" : "msaddek", machine);
    const Trajectory run = find_model("optimal").simulate(path, machine, settings);
    const Guarantees promised = find_model("optimal").guarantees(settings);
    SCOPED_TRACE(i);
    testing::expect_no_gaps_between_pieces(run);
    testing::expect_rest_at_the_programmed_ends(path, run);
    for (const Part& part : testing::parts_of(run)) {
      for (const double share : {0.0, 0.2, 0.5, 0.8, 1.0}) {
        const State state = testing::state_in(run, part, share * part.duration);
        ASSERT_LE(state.speed, state.programmed_feed * (1 + 1e-6)) << "part at " << part.time;
        for (int j = 0; j < 3; ++j) {
          const AxisLimits& axis = machine.axes[static_cast<std::size_t>(j)];
          ASSERT_LE(std::abs(state.velocity[j]), axis.velocity * (1 + 1e-6)) << "part at " << part.time;
          ASSERT_LE(std::abs(state.acceleration[j]), axis.acceleration * promised.arcs.acceleration.factor)
              << "part at " << part.time;
        }
      }
    }
  }
}

TEST(OptimalModel, RunsEmptyAndOneBlockProgramsAndBlocksOfAllSizes) {
  EXPECT_EQ(optimal_run(Toolpath()).duration(), 0);
  for (const double length : {1e-6, 1e-3, 1.0, 1000.0}) {
    for (const double feed : {0.0, 1e-3, 1000.0}) {
      for (const std::string model : {"cam", "essid", "msaddek"}) {
        const Trajectory run = optimal_run(
            testing::polyline({{0, 0, 0}, {length, 0, 0}, {length, length, 0}, {0, 0, 0}}, feed), model);
        EXPECT_TRUE(std::isfinite(run.duration()) && run.duration() > 0) << length << " mm, " << feed;
        EXPECT_LT(run.state(run.duration()).position.norm(), 1e-9 * (1 + length));
      }
    }
  }
}

TEST(OptimalModel, GivesTheSameInWindowsAsAtOnce) {
  // More cells than fit a window, a fast feed and small steps: braking takes many blocks.
  std::vector<Vec3> points;
  for (int i = 0; i < 6000; ++i) {
    points.push_back({0.05 * i, 5 * std::sin(0.002 * i), 0});
  }
  const Trajectory run = optimal_run(testing::polyline(points, 200), "essid");
  testing::expect_no_gaps_between_pieces(run);
  const double length = run.path_length();
  // The ramps go along the first and last block, where both axes accelerate the tool.
  EXPECT_NEAR(run.duration(), length / 200 + 200.0 / 1000, 0.01);
}

/// A corner at the border of two windows must not slow the windows before it.
TEST(OptimalModel, IsNoSlowerOnAWholeZigzagThanOnItsPieces) {
  constexpr std::size_t piece = 200;
  Machine machine = spinner_as_published();
  for (const std::size_t axis : {0U, 1U}) {
    machine.axes[axis].acceleration = 400;
  }
  for (const unsigned seed : {1U, 2U, 3U}) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> turn(-2.6, 2.6);
    std::uniform_real_distribution<double> length(0.5, 3);
    std::vector<Vec3> points{Vec3::Zero()};
    double direction = 0;
    for (std::size_t i = 0; i < 20 * piece; ++i) {
      direction += turn(random);
      points.push_back(points.back() + length(random) * Vec3(std::cos(direction), std::sin(direction), 0));
    }
    double pieces = 0;
    for (std::size_t i = 0; i + piece < points.size(); i += piece) {
      const std::vector<Vec3> some(points.begin() + static_cast<std::ptrdiff_t>(i),
                                   points.begin() + static_cast<std::ptrdiff_t>(i + piece + 1));
      pieces += optimal_run(testing::polyline(some, 60), "essid", machine).duration();
    }
    EXPECT_LT(optimal_run(testing::polyline(points, 60), "essid", machine).duration(), pieces) << seed;
  }
}

TEST(OptimalModel, ListsTheSettingsOfThePathsItCanTake) {
  const ControlModel& optimal = find_model("optimal");
  Machine machine = testing::spinner();
  Settings settings = complete_settings(optimal, machine);
  EXPECT_EQ(settings.text("path"), "essid");
  for (const char* key : {"contour_tolerance_mm", "alpha", "reading", "compaction_mm", "tangential_share"}) {
    EXPECT_TRUE(settings.has(key)) << key;
  }
  EXPECT_TRUE(settings.has("filters"));
  try {
    apply_setting("path=optimal", optimal, machine, settings);
    FAIL() << "optimal is no path";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("essid, cam, gassara, tapie, msaddek, ward"));
  }
}

}  // namespace
}  // namespace feedscope

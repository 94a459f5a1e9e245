#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/base/units.h"
#include "core/feed/ramp.h"
#include "core/models/optimal/jerk_cell.h"
#include "core/models/optimal/optimal_model.h"
#include "tests/support/motion_checks.h"
#include "tests/support/paths.h"

namespace feedscope {
namespace {

Machine spinner_as_published() {
  Machine machine = testing::spinner();
  machine.settings = testing::spinner_settings(find_model("essid"));
  return machine;
}

Settings settings_on(const std::string& path, const Machine& machine, const std::string& jerk = "on") {
  Settings settings = complete_settings(find_model("optimal"), machine);
  settings.set("path", path);
  settings.set("jerk", jerk);
  return settings;
}

Trajectory jerk_run(const Toolpath& path, const std::string& model, const Machine& machine) {
  return find_model("optimal").simulate(path, machine, settings_on(model, machine));
}

double time_of(const Toolpath& path, const std::string& model, const Machine& machine,
               const std::string& jerk = "on") {
  return find_model("optimal").simulate(path, machine, settings_on(model, machine, jerk)).duration();
}

void expect_limits(const Trajectory& run, const Machine& machine, const Guarantees& promised) {
  for (const Part& part : testing::parts_of(run)) {
    const bool corner = run.path().in_corner(part.element);
    const KeptLimits& kept =
        run.path().kind(part.element) == ElementKind::line ? promised.lines : promised.arcs;
    for (const double share : {0.0, 0.3, 0.6, 1.0}) {
      const State state = testing::state_in(run, part, share * part.duration);
      ASSERT_LE(state.speed, state.programmed_feed * (1 + 1e-6)) << part.time;
      for (int j = 0; j < 3; ++j) {
        const AxisLimits& axis = machine.axes[static_cast<std::size_t>(j)];
        const double jerk = corner ? axis.blend_jerk : axis.jerk;
        ASSERT_LE(std::abs(state.velocity[j]), axis.velocity * (kept.velocity.factor + 1e-6)) << part.time;
        ASSERT_LE(std::abs(state.acceleration[j]), axis.acceleration * (kept.acceleration.factor + 1e-6))
            << part.time;
        ASSERT_LE(std::abs(state.jerk[j]), jerk * (kept.jerk.factor + 1e-6)) << part.time;
      }
    }
  }
}

TEST(CellMotion, MeetsSpeedsAccelerationsAndLength) {
  const CellMotion m = CellMotion::through(3, 10, 200, 14, -100);
  const Motion1d middle = advance({0, 10, 200}, m.j1, m.time / 2);
  const Motion1d end = advance(middle, m.j2, m.time / 2);
  EXPECT_NEAR(middle.v, m.v_middle, 1e-10);
  EXPECT_NEAR(middle.a, m.a_middle, 1e-9);
  EXPECT_NEAR(end.s, 3, 1e-12);
  EXPECT_NEAR(end.v, 14, 1e-10);
  EXPECT_NEAR(end.a, -100, 1e-9);
}

TEST(CellMotion, StartsFromRestWithOneJerk) {
  // 0.01 s of 15 000 mm/s3.
  const CellMotion m = CellMotion::through(15000 * 1e-6 / 6, 0, 0, 0.75, 150);
  EXPECT_NEAR(m.time, 0.01, 1e-12);
  EXPECT_NEAR(m.j1, 15000, 1e-6);
  EXPECT_NEAR(m.j2, 15000, 1e-6);
}

TEST(CellCost, HasTheSlopesOfItsValue) {
  PathPoint point;
  point.t = Vec3(0.8, 0.6, 0);
  point.c = Vec3(-0.06, 0.08, 0);
  point.d = Vec3(-0.008, -0.006, 0);
  std::vector<CellPlace> places;
  for (const double share : {0.0, 0.25, 0.5, 1.0}) {
    places.push_back({share, PlaceLimits(point, false, 50, Vec3(2e3, 2e3, 2e3), Vec3(6e4, 6e4, 6e4))});
  }
  const double length = 0.4;
  const double mu = 0.01;
  const CellPlace* last = places.data() + places.size();
  // In the squares of the speeds, and the accelerations.
  const auto value = [&](const Eigen::Vector4d& z) {
    return cell_value(CellMotion::through(length, std::sqrt(z[0]), z[1], std::sqrt(z[2]), z[3]),
                      places.data(), last, mu);
  };
  const Eigen::Vector4d z(900, 300, 1100, 200);
  const CellCost cost =
      cell_cost(CellMotion::through(length, 30, 300, std::sqrt(1100), 200), length, places.data(), last, mu);
  for (int i = 0; i < 4; ++i) {
    Eigen::Vector4d step = Eigen::Vector4d::Zero();
    step[i] = 1e-4 * z[i];
    const double difference = (value(z + step) - value(z - step)) / (2 * step[i]);
    EXPECT_NEAR(cost.slope[i], difference, 1e-5 * std::abs(difference) + 1e-12) << i;
  }
}

TEST(OptimalWithJerk, RunsALineInSevenPhases) {
  const Machine machine = spinner_as_published();
  for (const double length : {0.01, 2.0, 100.0}) {
    const SpeedProfile fastest = plan_profile(0, 0, 0, length, 50, {1000, 15000});
    const Trajectory run = jerk_run(testing::polyline({{0, 0, 0}, {length, 0, 0}}, 50), "tapie", machine);
    EXPECT_NEAR(run.duration(), fastest.duration(), 1e-9) << length;
  }
}

TEST(OptimalWithJerk, TakesNoLessThanWithout) {
  const Machine spinner = spinner_as_published();
  for (const std::string model : {"essid", "gassara", "msaddek", "tapie"}) {
    const Toolpath path = testing::polyline(testing::essid_table1(), 50);
    EXPECT_GE(time_of(path, model, spinner), time_of(path, model, spinner, "off")) << model;
  }
}

TEST(OptimalWithJerk, IsFasterThanTheModelsThatKeepTheLimits) {
  const Machine spinner = spinner_as_published();
  for (const Toolpath& path :
       {testing::polyline(testing::essid_table1(), 50), testing::polyline(testing::essid_spline(), 50)}) {
    for (const std::string model : {"essid", "gassara", "msaddek", "tapie"}) {
      const double bound = time_of(path, model, spinner);
      EXPECT_LE(bound, find_model(model).simulate(path, spinner, settings_on(model, spinner)).duration() *
                           (1 + 1e-9))
          << model;
    }
  }
}

/// What times must grow by for a run to keep velocity, acceleration and jerk, seen at 17 instants of each
/// part.
double slower_by(const Trajectory& run, const AxisVectors& axes) {
  double factor = 1;
  for (const Part& part : testing::parts_of(run)) {
    const Vec3& jerk = run.path().in_corner(part.element) ? axes.blend_jerk : axes.jerk;
    for (int k = 0; k <= 16; ++k) {
      const State state = testing::state_in(run, part, part.duration * k / 16);
      factor = std::max({factor, state.velocity.cwiseAbs().cwiseQuotient(axes.velocity).maxCoeff(),
                         std::sqrt(state.acceleration.cwiseAbs().cwiseQuotient(axes.acceleration).maxCoeff()),
                         std::cbrt(state.jerk.cwiseAbs().cwiseQuotient(jerk).maxCoeff())});
    }
  }
  return factor;
}

TEST(OptimalWithJerk, IsNeverSlowerThanTheModelPassedSoSlowlyThatItKeepsTheLimits) {
  std::mt19937 random(5);
  const Machine machine = testing::mikron();
  for (int i = 0; i < 40; ++i) {
    const Toolpath path = testing::random_path(random, 1 + i / 2);
    for (const std::string model : {"essid", "gassara", "tapie"}) {
      const Trajectory run = find_model(model).simulate(path, machine, settings_on(model, machine));
      const double allowed = run.duration() * slower_by(run, AxisVectors(machine));
      ASSERT_LE(time_of(path, model, machine), allowed * (1 + 1e-6)) << model << ", program " << i;
    }
  }
}

TEST(OptimalWithJerk, IsSlowAtANearReversalOnlyAroundIt) {
  // The blend's least radius is far below a micrometre; the law may nearly stop there, as one that stops.
  const Machine machine = spinner_as_published();
  const Toolpath path = testing::polyline({{0, 0, 0}, {5, 0, 0}, {0, 1e-4, 0}}, 50);
  const double with_stop = 2 * plan_profile(0, 0, 0, 5, 50, {1000, 15000}).duration();
  EXPECT_LT(time_of(path, "essid", machine), 1.5 * with_stop);
  EXPECT_LT(time_of(path, "essid", machine, "off"), with_stop);
}

TEST(OptimalWithJerk, RunsACircleAtTheSpeedThatItsJerkAllows) {
  // At constant speed the jerk v^3 / R^2 turns from axis to axis: v = (J R^2)^(1/3). Far from both ends a
  // turn takes no longer than that; where both axes share the jerk the tool may be a little faster.
  const Machine machine = spinner_as_published();
  const auto turns = [](int count) {
    Toolpath path;
    path.start = Vec3(5, 0, 0);
    for (int i = 0; i < count; ++i) {
      testing::append_arc(path, Vec3::Zero(), 2 * units::pi, 1000);
    }
    return path;
  };
  const double steady = std::cbrt(15000.0 * 25);
  const Trajectory run = jerk_run(turns(5), "tapie", machine);
  const double turn = (run.duration() - time_of(turns(3), "tapie", machine)) / 2;
  EXPECT_LT(turn, 2 * units::pi * 5 / steady * 1.01);
  EXPECT_GT(turn, 2 * units::pi * 5 / steady * 0.8);
  expect_limits(run, machine, find_model("optimal").guarantees(settings_on("tapie", machine)));
}

TEST(OptimalWithJerk, KeepsEveryLimitOnRandomPaths) {
  std::mt19937 random(3);
  const Machine machine = testing::mikron();
  for (int i = 0; i < 40; ++i) {
    SCOPED_TRACE(i);
    const Toolpath path = testing::random_path(random, 1 + i / 2);
    const std::string model = i % 2 == 0 ? "essid" : "gassara";
    const Trajectory run = jerk_run(path, model, machine);
    testing::expect_no_gaps_between_pieces(run);
    testing::expect_rest_at_the_programmed_ends(path, run);
    expect_limits(run, machine, find_model("optimal").guarantees(settings_on(model, machine)));
    if (HasFatalFailure()) {
      return;
    }
  }
}

TEST(OptimalWithJerk, RunsALineInPiecesInSevenPhases) {
  // One line of 20 mm in pieces of equal length, and one of 0.01 mm in pieces of a nanometre.
  // Of these the lengths are rounded, to 2^-36 mm.
  const Machine machine = spinner_as_published();
  for (const auto& [length, pieces] :
       {std::pair(20.0, 2), std::pair(20.0, 7), std::pair(20.0, 1000), std::pair(0.01, 10000)}) {
    std::vector<Vec3> points;
    for (int k = 0; k <= pieces; ++k) {
      points.emplace_back(length * k / pieces, 0, 0);
    }
    const SpeedProfile fastest = plan_profile(0, 0, 0, length, 50, {1000, 15000});
    for (const std::string model : {"tapie", "essid"}) {
      const Trajectory run = jerk_run(testing::polyline(points, 50), model, machine);
      EXPECT_NEAR(run.duration(), fastest.duration(), 1e-7) << model << ", " << pieces << " pieces";
    }
  }
}

TEST(OptimalWithJerk, IsNotSlowerWithMoreJerk) {
  // Every law that keeps the lower limits keeps the higher ones.
  constexpr double searched = 1e-3;  // of a time
  std::mt19937 random(9);
  for (int i = 0; i < 20; ++i) {
    const Toolpath path = testing::random_path(random, 1 + i);
    const std::string model = i % 2 == 0 ? "tapie" : "gassara";
    double before = infinite;
    for (const double factor : {1.0, 1.03, 1.3, 5.0}) {
      Machine machine = testing::mikron();
      Settings settings = settings_on(model, machine);
      for (AxisLimits& axis : machine.axes) {
        axis.jerk *= factor;
        axis.blend_jerk *= factor;
      }
      const double time = find_model("optimal").simulate(path, machine, settings).duration();
      EXPECT_LE(time, before * (1 + searched)) << "program " << i << ", " << factor << " times the jerk";
      before = time;
    }
  }
}

TEST(OptimalWithJerk, RunsEmptyAndOneBlockProgramsAndBlocksOfAllSizes) {
  const Machine machine = spinner_as_published();
  EXPECT_EQ(jerk_run(Toolpath(), "essid", machine).duration(), 0);
  for (const double length : {1e-6, 1e-3, 1.0, 1000.0}) {
    for (const double feed : {0.0, 1e-3, 1000.0}) {
      const Trajectory run =
          jerk_run(testing::polyline({{0, 0, 0}, {length, 0, 0}, {length, length, 0}, {0, 0, 0}}, feed),
                   "essid", machine);
      EXPECT_TRUE(std::isfinite(run.duration()) && run.duration() > 0) << length << " mm, " << feed;
      EXPECT_LT(run.state(run.duration()).position.norm(), 1e-9 * (1 + length));
    }
  }
}

}  // namespace
}  // namespace feedscope

#include "core/drives/drive_response.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "core/base/units.h"
#include "core/models/control_model.h"
#include "core/trajectory/state_walk.h"
#include "tests/support/paths.h"

namespace feedscope {
namespace {

constexpr double full_turn = 2 * std::numbers::pi;

/// Kv [1/s], f, Tv [ms] on X and Y.
Machine with_drives(double gain, double feedforward, double lag) {
  Machine machine = testing::spinner();
  for (const char axis : {'X', 'Y', 'Z'}) {
    set_axis_value(machine, axis, "kv", gain);
    set_axis_value(machine, axis, "velocity_feedforward", feedforward);
    set_axis_value(machine, axis, "velocity_lag", lag);
  }
  return machine;
}

std::shared_ptr<const Trajectory> run_of(const std::string& model_id, const Toolpath& path) {
  const ControlModel& model = find_model(model_id);
  return std::make_shared<const Trajectory>(
      model.simulate(path, testing::spinner(), testing::spinner_settings(model)));
}

/// Some turns of a circle about the origin, at constant feed from the first instant on.
std::shared_ptr<const Trajectory> turns(double radius, double feed) {
  Toolpath path;
  path.start = {radius, 0, 0};
  for (int i = 0; i < 4; ++i) {
    testing::append_arc(path, {0, 0, 0}, full_turn, feed);
  }
  return run_of("cam", path);
}

// Numbers of the closed form R' = R sqrt((Kv^2 + f^2 w^2)/((Kv - Tv w^2)^2 + w^2)) with w = v/R.
TEST(DriveResponse, SteadyCircleGrowsByTheGainOfTheDrive) {
  struct Case {
    double radius, feed, growth;  // mm, m/min, um
  };
  for (const Case& c :
       {Case{30, 6, 33.27}, Case{30, 9, 74.67}, Case{30, 10.53, 102.04}, Case{2.5, 2.01, 43.48}}) {
    const auto run = turns(c.radius, units::from_m_min(c.feed));
    const DriveResponse response(run, with_drives(60, 1, 6));
    for (int i = 0; i < 50; ++i) {
      const double time = run->duration() * (0.6 + 0.4 * i / 50);
      EXPECT_NEAR((response.at(time).position.norm() - c.radius) * 1000, c.growth, 0.01)
          << c.radius << ' ' << c.feed;
    }
  }
}

// dr = v^2/R (c_mean + (c_x - c_y)/2 cos 2 th) + v (tau_x - tau_y)/2 sin 2 th counter-clockwise, but for
// terms of higher order.
TEST(DriveResponse, UnequalAxesMakeAnOvalTiltedByTheirDelays) {
  constexpr double radius = 50;
  constexpr double feed = 20;
  Machine machine = with_drives(60, 1, 6);
  const auto run = turns(radius, feed);
  set_axis_value(machine, 'Y', "kv", 50.0);
  set_axis_value(machine, 'Y', "velocity_feedforward", 0.9);
  const auto c = [](double kv, double f, double lag) { return (f * f - 1 + 2 * kv * lag) / (2 * kv * kv); };
  const double cx = c(60, 1, 0.006);
  const double cy = c(50, 0.9, 0.006);
  const double tau_y = 0.1 / 50;
  const DriveResponse response(run, machine);
  for (int i = 0; i < 100; ++i) {
    const Vec3 at = response.at(run->duration() * (0.5 + 0.5 * i / 100)).position;
    const double angle = std::atan2(at.y(), at.x());
    const double expected = feed * feed / radius * ((cx + cy) / 2 + (cx - cy) / 2 * std::cos(2 * angle)) +
                            feed * (0 - tau_y) / 2 * std::sin(2 * angle);
    EXPECT_NEAR(at.norm() - radius, expected, 0.0008) << units::to_deg(angle);  // of up to 0.02 mm
  }
}

/// Tv y'' + y' + Kv y = Kv x + f x' for all axes, with x and x' of the trajectory, in small steps (Runge and
/// Kutta) that no piece border cuts: `steps` of at most `longest` [s] in each span.
class SmallSteps {
 public:
  SmallSteps(const Trajectory& run, double gain, double feedforward, double lag)
      : set_(run), gain_(gain), feedforward_(feedforward), lag_(lag), y_(run.state(0).position) {}

  void advance(const SetSpan& span, double longest) {
    const double steps = std::ceil(span.duration / longest);
    const double h = span.duration / steps;
    for (int i = 0; i < steps; ++i) {
      const double t = span.time + i * h;
      const Vec3 start = input(t + beside);
      const Vec3 middle = input(t + h / 2);
      const Vec3 end = input(t + h - beside);
      const Vec3 a = slope(start, y_, v_);
      const Vec3 b = slope(middle, y_ + h / 2 * v_, v_ + h / 2 * a);
      const Vec3 c = slope(middle, y_ + h / 2 * (v_ + h / 2 * a), v_ + h / 2 * b);
      const Vec3 d = slope(end, y_ + h * (v_ + h / 2 * b), v_ + h * c);
      y_ += h * v_ + h * h / 6 * (a + b + c);
      v_ += h / 6 * (a + 2 * b + 2 * c + d);
    }
  }
  const Vec3& position() const { return y_; }

 private:
  static constexpr double beside = 1e-12;  ///< of a piece border [s]

  Vec3 input(double t) {
    const State state = set_.at_without_length(t);
    return gain_ * state.position + feedforward_ * state.velocity;
  }
  Vec3 slope(const Vec3& input, const Vec3& y, const Vec3& v) const { return (input - v - gain_ * y) / lag_; }

  StateWalk set_;
  double gain_, feedforward_, lag_;
  Vec3 y_;
  Vec3 v_ = Vec3::Zero();
};

// The bound that core/drives/README.md states, on lines, blends, arcs and filtered motion.
TEST(DriveResponse, IsWithinTheStatedBoundOfTheEquation) {
  Toolpath path = testing::polyline({{300, 0, 0}, {308, 0, 0}, {308, 6, 1}, {303, 9, 0}}, 50);
  testing::append_arc(path, {303, 14, 0}, 2.5, 50);
  for (const ControlModel* model : all_models()) {
    const auto run = run_of(model->info().id, path);
    const DriveResponse response(run, with_drives(60, 0.5, 6));
    SmallSteps reference(*run, 60, 0.5, 0.006);
    ActualWalk walk(response);
    for (SetWalk set(*run); !set.done(); set.next()) {
      reference.advance(set.span(), 2e-4);
      ASSERT_LT((walk.at(set.span().end()).position - reference.position()).norm(), 1e-8)
          << model->info().id << " at " << set.span().end();
    }
  }
}

TEST(DriveResponse, WalkAndSingleInstantsAgree) {
  std::mt19937 random(31);
  for (const ControlModel* model : all_models()) {
    const auto run = run_of(model->info().id, testing::random_path(random, 40));
    Machine machine = with_drives(60, 0.8, 6);
    set_axis_value(machine, 'X', "backlash", 8.0);
    set_axis_value(machine, 'Y', "friction_spike", 5.0);
    set_axis_value(machine, 'Y', "friction_time", 20.0);
    const DriveResponse response(run, machine);
    ActualWalk walk(response);
    for (int i = 0; i <= 500; ++i) {
      const double time = run->duration() * i / 500;
      const ActualMotion in_order = walk.at(time);
      const ActualMotion alone = response.at(time);
      ASSERT_LT((in_order.position - alone.position).norm(), 3e-6) << model->info().id << " at " << time;
      const Vec3 set = run->state(time).position;
      ASSERT_LT((set - in_order.position - in_order.following_error).norm(), 4 * SetWalk::tolerance)
          << model->info().id;
    }
  }
}

TEST(DriveResponse, TendsToTheSetPathAsDrivesGetStiffer) {
  std::mt19937 random(32);
  for (const char* model : {"essid", "ward", "optimal"}) {
    const auto run = run_of(model, testing::random_path(random, 25));
    double before = 1e9;
    for (const double scale : {1.0, 8.0, 64.0, 512.0}) {
      const DriveResponse response(run, with_drives(40 * scale, 0.3, 4 / scale));
      double largest = 0;
      ActualWalk walk(response);
      for (int i = 0; i <= 2000; ++i) {
        largest = std::max(largest, walk.at(run->duration() * i / 2000).following_error.norm());
      }
      EXPECT_LT(largest, 0.3 * before) << model << ' ' << scale;
      before = largest;
    }
  }
}

TEST(DriveResponse, AxesWithoutAGainFollowExactly) {
  const auto run = run_of("essid", testing::polyline(testing::essid_table1(), 50));
  Machine machine = testing::spinner();
  EXPECT_FALSE(has_drives(machine));
  set_axis_value(machine, 'X', "kv", 60.0);
  EXPECT_TRUE(has_drives(machine));
  const DriveResponse response(run, machine);
  double largest_x = 0;
  for (int i = 0; i <= 200; ++i) {
    const double time = run->duration() * i / 200;
    const ActualMotion actual = response.at(time);
    EXPECT_NEAR(actual.following_error.y(), 0, 1e-9);
    EXPECT_NEAR(actual.following_error.z(), 0, 1e-9);
    largest_x = std::max(largest_x, std::abs(actual.following_error.x()));
  }
  EXPECT_GT(largest_x, 0.01);
}

TEST(DriveResponse, TinyChangesOfTheDrivesChangeLittle) {
  std::mt19937 random(34);
  const auto run = run_of("essid", testing::random_path(random, 40));
  const DriveResponse one(run, with_drives(60, 1, 6));
  const DriveResponse other(run, with_drives(60 * (1 + 1e-9), 1, 6 * (1 + 1e-9)));
  for (int i = 0; i <= 300; ++i) {
    const double time = run->duration() * i / 300;
    ASSERT_LT((one.at(time).position - other.at(time).position).norm(), 1e-8);
  }
}

TEST(DriveResponse, OfNoMotionIsAtTheOrigin) {
  const DriveResponse response(std::make_shared<const Trajectory>(), with_drives(60, 1, 6));
  EXPECT_EQ(response.at(1).position, Vec3::Zero());
}

TEST(DriveResponse, IsCancelled) {
  Toolpath path;
  path.start = {30, 0, 0};
  for (int i = 0; i < 5000; ++i) {
    testing::append_arc(path, {0, 0, 0}, full_turn, 100);
  }
  Progress progress;
  progress.cancel();
  EXPECT_THROW(DriveResponse(run_of("cam", path), with_drives(60, 1, 6), &progress), Cancelled);
}

}  // namespace
}  // namespace feedscope

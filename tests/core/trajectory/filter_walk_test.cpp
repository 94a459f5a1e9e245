#include "core/trajectory/filter_walk.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/base/units.h"
#include "core/models/control_model.h"
#include "core/trajectory/filtered_motion.h"
#include "core/trajectory/length_walk.h"
#include "tests/support/paths.h"

namespace feedscope {
namespace {

/// What the model commands on a path at 20 m/min at most, with a tolerance that keeps corners fast.
Trajectory run(const Toolpath& path, int filters) {
  const ControlModel& ward = find_model("ward");
  Settings settings = testing::spinner_settings(ward);
  settings.set("filters", double(filters));
  return ward.simulate(path, testing::spinner(), settings);
}

Toolpath random_polyline(std::mt19937& random, int blocks) {
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<Vec3> points{Vec3(100, -50, 3)};
  double heading = 0;
  for (int i = 0; i < blocks; ++i) {
    heading += (unit(random) - 0.5) * (unit(random) < 0.1 ? 3 : 0.1);
    const double length = std::pow(10, 3 * unit(random) - 2.5);
    points.push_back(points.back() +
                     length * Vec3(std::cos(heading), std::sin(heading), 0.3 * (unit(random) - 0.5)));
  }
  return testing::polyline(points, 100);
}

/// S_(n,m)(u) of models/ward/README.md.
double response(int n, int m, double u) {
  double sum = 0;
  double sign = 1;
  for (int i = 0; i <= n && u > i; ++i) {
    sum += sign * std::pow(u - i, m) / std::tgamma(m + 1);
    sign *= -double(n - i) / (i + 1);
  }
  return sum;
}

/// The sum of models/ward/README.md over all steps of velocity; arcs as chords, `chords` a pulse.
class DirectSum {
 public:
  DirectSum(const PulseTrain& train, int chords = 1) : train_(train), position_(train.point(0)) {
    for (std::size_t i = 0; i <= train.size(); ++i) {
      std::array<CommandPart, 3> parts;
      const std::size_t count = train.parts(i, parts);
      for (std::size_t k = 0; k < count; ++k) {
        const double end = k + 1 < count      ? parts[k + 1].time
                           : i < train.size() ? train.blocks[i + 1].start
                                              : 0;
        add(parts[k], end, chords);
      }
    }
  }

  Kinematics at(double t) const {
    const int n = train_.filters;
    const double t1 = train_.filter_time;
    Kinematics sum{position_, Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
    for (const auto& [time, step] : steps_) {
      const double u = (t - time) / t1;
      if (u >= n) {
        sum.position += step * (t1 * (u - n / 2.0));
        sum.velocity += step;
      } else if (u > 0) {
        sum.position += step * (t1 * response(n, n + 1, u));
        sum.velocity += step * response(n, n, u);
        sum.acceleration += step * (response(n, n - 1, u) / t1);
        sum.jerk += step * (response(n, n - 2, u) / (t1 * t1));
      }
    }
    return sum;
  }

 private:
  void add(const CommandPart& part, double end, int chords) {
    if (part.rate == 0) {
      add_step(part.time, part.velocity);
      return;
    }
    const double h = (end - part.time) / chords;
    for (int i = 0; i < chords; ++i) {
      CommandPart from = part;
      CommandPart to = part;
      from.begin_later(i * h);
      to.begin_later((i + 1) * h);
      add_step(from.time, (to.position - from.position) / h);
    }
  }
  void add_step(double time, const Vec3& velocity) {
    steps_.push_back({time, velocity - before_});
    before_ = velocity;
  }

  const PulseTrain& train_;
  Vec3 position_;
  Vec3 before_ = Vec3::Zero();
  std::vector<std::pair<double, Vec3>> steps_;
};

class FilterWalkTest : public ::testing::TestWithParam<int> {
 protected:
  /// Largest differences, in units of the largest feed F, F T1 for positions, F/T1 and F/T1^2.
  static void expect_near(const PulseTrain& train, const Kinematics& a, const Kinematics& b,
                          double tolerance) {
    const double f = train.largest_feed;
    const double t1 = train.filter_time;
    ASSERT_LT((a.position - b.position).norm(), tolerance * f * t1);
    ASSERT_LT((a.velocity - b.velocity).norm(), tolerance * f);
    ASSERT_LT((a.acceleration - b.acceleration).norm(), tolerance * f / t1);
    ASSERT_LT((a.jerk - b.jerk).norm(), tolerance * f / (t1 * t1));
  }
};

TEST_P(FilterWalkTest, IsTheSumOverAllSteps) {
  std::mt19937 random(4);
  const Trajectory trajectory = run(random_polyline(random, 3000), GetParam());
  ASSERT_EQ(trajectory.motions().size(), 1u);
  const PulseTrain& train = trajectory.motions()[0].train();
  const DirectSum sum(train);
  FilterWalk walk;
  for (int i = 0; i < 4000; ++i) {
    const double t = train.duration() * (i + 0.37) / 4000;  // no knot of n = 2, where the jerk jumps
    SCOPED_TRACE(t);
    expect_near(train, walk.at(train, t), sum.at(t), 1e-9);
  }
}

TEST_P(FilterWalkTest, DoesNotDependOnTheInstantsBefore) {
  std::mt19937 random(5);
  for (int i = 0; i < 30; ++i) {
    const Trajectory trajectory = run(testing::random_path(random, 40), GetParam());
    for (const FilteredMotion& motion : trajectory.motions()) {
      std::uniform_real_distribution<double> anywhere(0, motion.duration());
      FilterWalk in_order;
      FilterWalk at_random;
      for (int k = 0; k <= 200; ++k) {
        const double t = motion.duration() * k / 200;
        at_random.at(motion.train(), anywhere(random));
        const Kinematics fresh = motion.at(t);
        // A jerk that jumps may do so a rounding of time earlier.
        const double tolerance = 1e-9 + 1e-15 * t / motion.filter_time();
        Kinematics a = in_order.at(motion.train(), t);
        Kinematics b = at_random.at(motion.train(), t);
        if (GetParam() == 2) {
          a.jerk = b.jerk = fresh.jerk;
        }
        expect_near(motion.train(), a, fresh, tolerance);
        expect_near(motion.train(), b, fresh, tolerance);
      }
    }
  }
}

TEST_P(FilterWalkTest, ShrinksAnArcByTheSincOfEveryFilter) {
  for (const double radius : {0.05, 1.0, 30.0, 1e5}) {
    Toolpath path;
    path.start = Vec3(radius, 0, 0);
    testing::append_arc(path, Vec3::Zero(), 6, 50);
    PulseTrain train{std::make_shared<const Toolpath>(path), 0, GetParam(), 0.02, 50, {}};
    train.blocks = {{0, 50, 0}, {6 * radius / 50, 0, 0}};
    const double t = train.end() / 2 + train.half_delay();
    if (train.end() < train.delay()) {
      continue;
    }
    const double x = 50 / radius * 0.02 / 2;
    const double gain = std::pow(std::sin(x) / x, GetParam());
    FilterWalk walk;
    for (const double shift : {-0.3, 0.0, 0.2}) {
      const Kinematics at = walk.at(train, t + shift * (train.end() - train.delay()));
      const double w = 50 / radius;
      EXPECT_NEAR(at.position.norm(), gain * radius, 1e-12 * (1 + radius)) << radius;
      const double tolerance = 1e-10 + 1e-14 * radius;  // what rounding of the coordinates makes [mm]
      EXPECT_NEAR(at.velocity.norm(), gain * 50, tolerance / 0.02) << radius;
      EXPECT_NEAR(at.acceleration.norm(), gain * 50 * w, tolerance / (0.02 * 0.02)) << radius;
      EXPECT_NEAR(at.jerk.norm(), gain * 50 * w * w, tolerance / (0.02 * 0.02 * 0.02)) << radius;
    }
  }
}

TEST_P(FilterWalkTest, IsTheLimitOfChordsOnArcs) {
  std::mt19937 random(6);
  for (int i = 0; i < 6; ++i) {
    const Trajectory trajectory = run(testing::random_path(random, 30), GetParam());
    for (const FilteredMotion& motion : trajectory.motions()) {
      const PulseTrain& train = motion.train();
      constexpr int chord_count = 400;
      const DirectSum sum(train, chord_count);
      double sagitta = 0;
      for (const Arc& arc : train.path->arcs) {
        sagitta = std::max(sagitta, arc.radius * std::pow(arc.sweep / chord_count, 2) / 8);
      }
      FilterWalk walk;
      for (int k = 0; k <= 100; ++k) {
        const double t = motion.duration() * k / 100;
        const Kinematics at = walk.at(train, t);
        const Kinematics chords = sum.at(t);
        ASSERT_LT((at.position - chords.position).norm(), 1.01 * sagitta + 1e-9);
        ASSERT_LT((at.velocity - chords.velocity).norm(), 1e-2 * train.largest_feed);
      }
    }
  }
}

TEST_P(FilterWalkTest, LengthIsTheIntegralOfTheSpeed) {
  std::mt19937 random(7);
  for (int i = 0; i < 10; ++i) {
    const Trajectory trajectory = run(testing::random_path(random, 20), GetParam());
    for (const FilteredMotion& motion : trajectory.motions()) {
      FilterWalk walk;
      FilterWalk samples;
      LengthWalk length(walk, motion.train(), 0);
      const int count = 20 * (1 + static_cast<int>(motion.duration() / motion.filter_time()));
      if (count > 100000) {
        continue;
      }
      double covered = 0;
      double sum = 0;
      for (int k = 0; k < count; ++k) {
        const double h = motion.duration() / count;
        covered += length.advance_to((k + 1) * h);
        constexpr int cells = 10;
        for (int cell = 0; cell < cells; ++cell) {
          sum += h / cells * samples.at(motion.train(), (k + (cell + 0.5) / cells) * h).velocity.norm();
        }
      }
      ASSERT_NEAR(covered, sum, 2e-5 * sum);
      ASSERT_NEAR(LengthWalk(walk, motion.train(), 0).advance_to(motion.duration()), covered,
                  1e-8 * motion.train().largest_feed * motion.duration());
    }
  }
}

TEST_P(FilterWalkTest, KeepsTheSpeedOfAnArcAnHourLater) {
  constexpr double radius = 300;
  constexpr double feed = 0.5;
  constexpr double filter_time = 1e-3;
  Toolpath path;
  path.start = Vec3(radius, 0, 0);
  testing::append_arc(path, Vec3::Zero(), 6, feed);
  PulseTrain train{std::make_shared<const Toolpath>(path), 0, GetParam(), filter_time, feed, {}};
  train.blocks = {{0, feed, 0}, {6 * radius / feed, 0, 0}};
  FilterWalk walk;
  for (double t = 3500; t < 3500.1; t += 0.37 * filter_time) {
    ASSERT_NEAR(walk.velocity_at(train, t).velocity.norm(), feed, FilterWalk::velocity_rounding * feed) << t;
  }
}

TEST_P(FilterWalkTest, ShareOfASpanNeverDecreasesAndIsTheInverseOfItsTime) {
  std::mt19937 random(8);
  for (int i = 0; i < 20; ++i) {
    const Trajectory trajectory = run(testing::random_path(random, 20), GetParam());
    for (const FilteredMotion& motion : trajectory.motions()) {
      FilterWalk walk;
      const double from = 0.1 * motion.duration();
      const double to = std::min(0.9 * motion.duration(), from + 5 * motion.delay());
      const SpanCourse course(walk, motion.train(), from, to);
      ASSERT_EQ(course.share_at(from), 0);
      ASSERT_EQ(course.share_at(to), 1);
      constexpr int count = 300;
      double before = 0;
      for (int k = 1; k <= count; ++k) {
        const double t = from + (to - from) * k / count;
        const double share = course.share_at(t);
        ASSERT_GE(share, before) << t;
        const double found = course.time_at(share);
        ASSERT_LE(found, t + 1e-12 * to);  // the first instant, the later ones may be at rest
        ASSERT_NEAR(course.share_at(found), share, FilterWalk::velocity_rounding) << t;
        before = share;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Filters, FilterWalkTest, ::testing::Values(2, 3),
                         [](const auto& filters) { return std::to_string(filters.param); });

}  // namespace
}  // namespace feedscope

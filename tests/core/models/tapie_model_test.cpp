#include "core/models/tapie/tapie_model.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/units.h"
#include "core/models/tapie/set_point.h"
#include "tests/support/parts.h"
#include "tests/support/paths.h"

namespace feedscope {
namespace {

using units::from_deg;
using units::from_m_min;
using units::from_mm_min;
using units::pi;
using units::to_m_min;

constexpr double control_jerk = 6000;  // J_curv r_jct [mm/s3]

Trajectory run(const Toolpath& path) {
  const ControlModel& tapie = find_model("tapie");
  return tapie.simulate(path, testing::mikron(), complete_settings(tapie, testing::mikron()));
}

double largest_speed(const Trajectory& trajectory) {
  double largest = 0;
  for (const Part& part : testing::parts_of(trajectory)) {
    largest = std::max(largest, testing::state_in(trajectory, part, 0).speed);
  }
  return largest;
}

Toolpath circle(double radius, double from, double sweep, double feed) {
  return testing::spiral(radius, 0, 1, from, sweep, feed);
}

SteadyPlace place_on(const Toolpath& path) {
  return steady_place(path.arcs[0], AxisVectors(testing::mikron()), control_jerk);
}

// Set points: Tapie 2007, table 3 and section 5.3.1; models/tapie/README.md, 0.5 %.

struct SetPoint {
  double radius, sweep, programmed, expected;  // mm, degrees, m/min, m/min
};

class TapieSetPoint : public ::testing::TestWithParam<SetPoint> {};

TEST_P(TapieSetPoint, IsThatOfThePaper) {
  const auto [radius, sweep, programmed, expected] = GetParam();
  const Toolpath path = circle(radius, 0, from_deg(sweep), from_m_min(programmed));
  const SetPointRule rule{AxisVectors(testing::mikron()), control_jerk, 0.012};
  EXPECT_NEAR(to_m_min(rule.limits(path, 0).speed.value), expected, 0.005 * expected);
}

INSTANTIATE_TEST_SUITE_P(Table, TapieSetPoint,
                         ::testing::Values(SetPoint{2.5, 360, 6, 2.008}, SetPoint{2.5, 360, 24, 2.008},
                                           SetPoint{30, 360, 6, 6}, SetPoint{30, 360, 9, 9},
                                           SetPoint{30, 360, 12, 10.526}, SetPoint{30, 360, 24, 10.526},
                                           SetPoint{10, 180, 6, 5.061}, SetPoint{10, 90, 6, 5.061},
                                           SetPoint{12, 90, 6, 5.715}, SetPoint{14, 90, 6, 6}));

TEST(TapieSteadyPlace, IsWhereTheAxesAllowJustTheJerkOfTheControl) {
  // Section 5.2.4: a_c = 33.5 degrees, V_An = 5.7 and V_t = 36 m/min there; angles are those of the tangent,
  // which points along X where the circle begins at the bottom.
  const SteadyPlace place = place_on(circle(2.5, -pi / 2, 2 * pi, 1));
  EXPECT_NEAR(place.angle, std::acos(5.0 / 6), 1e-12);
  EXPECT_NEAR(units::to_deg(place.angle), 33.5, 0.1);
  EXPECT_NEAR(place.jerk.value, place.control_jerk, 1e-9);
  EXPECT_NEAR(to_m_min(place.acceleration.value), 5.7, 0.02);
  EXPECT_NEAR(to_m_min(place.velocity.value), 36, 1e-6);
}

TEST(TapieSteadyPlace, IsWhereTheAxesAllowMostIfTheyNeverAllowJustThat) {
  // Around the diagonal the axes allow more than 6 m/s3 everywhere, most at 45 degrees.
  const SteadyPlace fast = place_on(circle(10, from_deg(40), from_deg(10), 1));
  EXPECT_NEAR(fast.angle, from_deg(5), 1e-12);
  EXPECT_NEAR(fast.jerk.value, std::cbrt(5000 * std::sqrt(2) * 100), 1e-9);
  // Around an axis direction they allow less, most at the end farther from it.
  const SteadyPlace slow = place_on(circle(10, from_deg(-10), from_deg(25), 1));
  EXPECT_NEAR(slow.angle, from_deg(25), 1e-12);
  EXPECT_NEAR(slow.jerk.value, std::cbrt(5000 / std::cos(from_deg(15)) * 100), 1e-9);
  EXPECT_LT(slow.jerk.value, slow.control_jerk);
}

TEST(TapieSteadyPlace, AgreesWithASearchAlongHelicesInAnyDirection) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> unit(-1, 1);
  const AxisVectors axes(testing::mikron());
  for (int i = 0; i < 300; ++i) {
    SCOPED_TRACE(i);
    Arc arc;
    arc.center = Vec3::Zero();
    arc.radius = 10;
    arc.x = Vec3(unit(random), unit(random), unit(random)).normalized();
    arc.y = arc.x.cross(Vec3(unit(random), unit(random), unit(random))).normalized();
    arc.rise = arc.x.cross(arc.y) * (i % 3 == 0 ? 0 : 3 * unit(random));
    arc.sweep = 0.05 + 3.5 * std::abs(unit(random));
    const auto jerk_speed = [&](double a) {
      return std::cbrt(axis_share(axes.jerk, arc.at(a * arc.length_per_radian()).d3).value);
    };
    const SteadyPlace place = steady_place(arc, axes, control_jerk * (1 + unit(random) / 2));
    ASSERT_NEAR(place.jerk.value, jerk_speed(place.angle), 1e-9 * place.jerk.value);

    double fastest = 0;
    double slowest = std::numeric_limits<double>::infinity();
    double fastest_before = 0;
    double slowest_before = std::numeric_limits<double>::infinity();
    constexpr int intervals = 2000;
    for (int n = 0; n <= intervals; ++n) {
      const double a = arc.sweep * n / intervals;
      const double speed = jerk_speed(a);
      fastest = std::max(fastest, speed);
      slowest = std::min(slowest, speed);
      if (a < place.angle) {
        fastest_before = std::max(fastest_before, speed);
        slowest_before = std::min(slowest_before, speed);
      }
    }
    if (slowest <= place.control_jerk && place.control_jerk <= fastest) {
      ASSERT_NEAR(place.jerk.value, place.control_jerk, 1e-6 * place.control_jerk);
      ASSERT_FALSE(slowest_before < place.control_jerk * (1 - 1e-6) &&
                   fastest_before > place.control_jerk * (1 + 1e-6));
    } else {
      ASSERT_GE(place.jerk.value, fastest * (1 - 1e-12));
    }
  }
}

// Changes of curvature: section 5.4.1; models/tapie/README.md, 0.5 %.

TEST(TapieModel, CrossesArcsOfASpiralAtTheFeedsOfThePaper) {
  struct Inclined {
    double degrees, feed;
  };
  for (const auto& [degrees, feed] : {Inclined{0, 4.919}, {30, 5.285}, {45, 5.849}}) {
    const Toolpath path = testing::spiral(10, 2, 11, from_deg(degrees), pi / 2, from_m_min(12));
    const double before = (10 + 12 + 14) * pi / 2;
    EXPECT_NEAR(to_m_min(run(path).state_at_path(before).speed), feed, 0.005 * feed) << degrees;
  }
}

TEST(TapieModel, CrossesAnInflectionByTheSumOfTheCurvatures) {
  Toolpath path = circle(20, -pi / 2, pi / 2, 200);
  testing::append_arc(path, Vec3(50, 0, 0), -pi / 2, 200);
  testing::append_line(path, Vec3(200, 30, 0), 200);
  const Trajectory trajectory = run(path);
  const double inflection = std::sqrt(5000 * 0.012 / (1.0 / 20 + 1.0 / 30));
  EXPECT_NEAR(trajectory.state_at_path(10 * pi).speed, inflection, 1e-6);
  EXPECT_NEAR(trajectory.state_at_path(25 * pi).speed, std::sqrt(5000 * 0.012 * 30), 1e-6);
}

// Bores: section 6, tables 4 and 5; models/tapie/README.md, 0.5 %.

struct Bore {
  double radius, approach, programmed, crossing, expected;  // mm, mm, mm/min, m/min, s
};

class TapieBore : public ::testing::TestWithParam<Bore> {};

TEST_P(TapieBore, TakesTheTimeOfTheFullCircle) {
  const auto [radius, approach, programmed, crossing, expected] = GetParam();
  Toolpath path;
  path.start = Vec3(radius - approach, -approach, 0);
  const double feed = from_mm_min(programmed);
  testing::append_arc(path, Vec3(radius - approach, 0, 0), pi / 2, feed);
  testing::append_arc(path, Vec3::Zero(), 2 * pi, feed);
  testing::append_arc(path, Vec3(radius - approach, 0, 0), pi / 2, feed);
  const Trajectory trajectory = run(path);
  const State in = trajectory.state_at_path(approach * pi / 2);
  const State out = trajectory.state_at_path(approach * pi / 2 + 2 * pi * radius);
  EXPECT_NEAR(to_m_min(in.speed), crossing, 0.005 * crossing);
  EXPECT_NEAR(out.time - in.time, expected, 0.005 * expected);
}

INSTANTIATE_TEST_SUITE_P(Table, TapieBore,
                         ::testing::Values(Bore{30, 20, 6748, 3.6, 1.772}, Bore{30, 20, 9549, 3.6, 1.360},
                                           Bore{30, 20, 11968, 3.6, 1.274}, Bore{2.5, 1.5, 5984, 0.9, 0.536},
                                           Bore{2.5, 1.5, 7385, 0.9, 0.536},
                                           Bore{2.5, 1.5, 8531, 0.9, 0.536}));

// Stage 3.

TEST(TapieModel, AnArcTooShortForItsSetPointPeaksWhereEquation16Says) {
  // Quarter circle of 10 mm from rest into 12 mm: the set point of 5.06 m/min is not reached (fig. 15).
  const Trajectory trajectory = run(testing::spiral(10, 2, 2, 0, pi / 2, from_m_min(6)));
  const double exit = std::sqrt(5000 * 0.012 * 10 * 12 / 2);
  const double length = 5 * pi;
  double low = exit;
  double high = 200;
  for (int i = 0; i < 100; ++i) {
    const double peak = (low + high) / 2;
    const double used = std::sqrt(peak - exit) * (peak + exit) + std::sqrt(peak) * peak;
    (used < length * std::sqrt(5000.0) ? low : high) = peak;
  }
  double peak = 0;
  for (const Part& part : testing::parts_of(trajectory)) {
    peak = std::max(peak, part.element == 0 ? part.v : 0);
  }
  EXPECT_NEAR(trajectory.state_at_path(length).speed, exit, 1e-6);
  EXPECT_NEAR(peak, low, 1e-6);
  EXPECT_LT(to_m_min(peak), 5.06);
}

TEST(TapieModel, AHalfCircleOf10MmReachesItsSteadyFeedAndTheLongerOnesTheProgrammedOne) {
  const Trajectory trajectory = run(testing::spiral(10, 5, 5, 0, pi, from_m_min(6)));
  double largest[5] = {};
  for (const Part& part : testing::parts_of(trajectory)) {
    double& value = largest[part.element];
    value = std::max(value, testing::state_in(trajectory, part, 0).speed);
  }
  EXPECT_NEAR(to_m_min(largest[0]), 5.061, 0.005 * 5.061);
  for (const double speed : {largest[1], largest[2], largest[3], largest[4]}) {
    EXPECT_NEAR(to_m_min(speed), 6, 1e-6);
  }
}

TEST(TapieModel, ALineIsTheJerkLimitedClosedForm) {
  const Trajectory trajectory = run(testing::polyline({{0, 0, 0}, {100, 0, 0}}, 50));
  const double ramp = 2 * std::sqrt(50.0 / 5000);
  EXPECT_NEAR(trajectory.duration(), 2 * ramp + (100 - 50 * ramp) / 50, 1e-12);
}

TEST(TapieModel, NoBlockTakesLessThanAnInterpolationPeriod) {
  // 100 mm, 0.3 mm, 100 mm in a straight line at 100 mm/s: the short one at 0.3 / 0.012 = 25 mm/s
  const Trajectory trajectory =
      run(testing::polyline({{0, 0, 0}, {100, 0, 0}, {100.3, 0, 0}, {200, 0, 0}}, 100));
  const State inside = trajectory.state_at_path(100.15);
  EXPECT_NEAR(inside.speed, 25, 1e-9);
  EXPECT_EQ(inside.cause.kind, CauseKind::interpolation_period);
}

TEST(TapieModel, CornersAreExactStops) {
  Toolpath path = testing::polyline({{0, 0, 0}, {10, 0, 0}, {10, 10, 0}}, 50);
  testing::append_arc(path, Vec3(10, 20, 0), pi, 50);
  const Trajectory trajectory = run(path);
  EXPECT_EQ(trajectory.blend_count(), 0u);
  EXPECT_LT(trajectory.state_at_path(10).speed, 1e-3);
  EXPECT_LT((trajectory.state_at_path(10).position - Vec3(10, 0, 0)).norm(), 1e-9);
  EXPECT_LT(trajectory.state_at_path(20).speed, 1e-3);
}

TEST(TapieModel, ACircleInThePlaneOfZUsesTheJerkOfZ) {
  // In YZ the jerk of Z is ten times that of Y: the same J_curv, but V_An of 2.1 m/s2 in Z
  Toolpath path;
  Arc arc;
  arc.center = Vec3::Zero();
  arc.radius = 30;
  arc.x = Vec3::UnitY();
  arc.y = Vec3::UnitZ();
  arc.rise = Vec3::Zero();
  arc.sweep = 2 * pi;
  path.start = arc.at(0).position;
  path.arcs.push_back(arc);
  Segment segment;
  segment.kind = SegmentKind::arc;
  segment.index = 0;
  segment.end = arc.at(arc.length()).position;
  segment.length = arc.length();
  segment.feed = from_m_min(24);
  path.segments.push_back(segment);
  const SteadyPlace place = place_on(path);
  EXPECT_EQ(place.jerk.axis, 1);
  EXPECT_NEAR(place.jerk.value, std::cbrt(control_jerk * 900), 1e-9);
  EXPECT_NEAR(to_m_min(largest_speed(run(path))), 10.526, 0.005 * 10.526);
}

}  // namespace
}  // namespace feedscope

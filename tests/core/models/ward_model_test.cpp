#include "core/models/ward/ward_model.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/analysis/run/run.h"
#include "core/analysis/run/summary.h"
#include "core/base/error.h"
#include "core/base/units.h"
#include "core/models/ward/corner_pulse.h"
#include "core/models/ward/short_blocks.h"
#include "tests/support/parts.h"
#include "tests/support/paths.h"

namespace feedscope {
namespace {

constexpr double exact = 1e-6;  // relative: models/ward/README.md

struct Choice {
  int filters = 3;
  double jerk = 76.9;  // [m/s3]
  double time = 0;     // [s]
  double tolerance = 0.01;
  bool enforce = true;
};

Trajectory run(const Toolpath& path, const Choice& choice) {
  const ControlModel& ward = find_model("ward");
  Settings settings = testing::spinner_settings(ward);
  settings.set("filters", double(choice.filters));
  settings.set("filter_jerk_m_s3", choice.jerk);
  settings.set("filter_time_s", choice.time);
  settings.set("contour_tolerance_mm", choice.tolerance);
  settings.set("enforce", std::string(choice.enforce ? "on" : "off"));
  return ward.simulate(path, testing::spinner(), settings);
}

Toolpath right_angle(double feed) {
  return testing::polyline({{0, 0, 0}, {20, 0, 0}, {20, 20, 0}}, units::from_mm_min(feed));
}

/// Distance along one leg and speed along it, weighted by the filters centred on the corner, by sums over the
/// pulse and the B-spline that n boxes make.
struct Leg {
  double distance = 0;
  double speed = 0;
};
Leg sampled_leg(int filters, double a) {
  const auto kernel = [&](double u) {  // uniform B-spline centred on 0, boxes of length 1
    u = std::abs(u);
    if (filters == 2) {
      return std::max(0.0, 1 - u);
    }
    return u < 0.5 ? 0.75 - u * u : (u < 1.5 ? (1.5 - u) * (1.5 - u) / 2 : 0);
  };
  const double half = filters / 2.0;
  const double width = half * (1 - a);
  constexpr int samples = 200000;
  Leg leg;
  for (int i = 0; i < samples; ++i) {
    const double t = (i + 0.5) * half / samples;
    const double weight = kernel(t) * half / samples;
    leg.distance += weight * (t < width ? a * t : a * width + t - width);
    leg.speed += weight * (t < width ? a : 1);
  }
  return leg;
}

TEST(WardCorner, DistanceAndSpeedAreThoseOfTheFilteredPulses) {
  for (const int filters : {2, 3}) {
    for (const double a : {0.0, 0.05, 0.3, 0.6, 2.0 / 3, 0.7, 0.9, 1.0}) {
      const Leg leg = sampled_leg(filters, a);
      EXPECT_NEAR(corner_distance(filters, a), leg.distance, 1e-5) << filters << ' ' << a;
      EXPECT_NEAR(corner_speed_share(filters, a), leg.speed, 1e-5) << filters << ' ' << a;
    }
  }
}

TEST(WardCorner, SpeedIsTheRootOfTheErrorOrTheFeed) {
  const double t1 = 0.02;
  for (const int filters : {2, 3}) {
    for (const double after : {50.0, 20.0}) {
      for (const double tolerance : {1e-4, 0.01, 0.1, 10.0}) {
        const double v = corner_speed(filters, t1, {50, after, 1.2}, tolerance);
        const double error =
            t1 * std::sin(0.6) *
            (50 * corner_distance(filters, v / 50) + after * corner_distance(filters, v / after));
        if (v < std::min(50.0, after)) {
          EXPECT_NEAR(error, tolerance, 1e-9 * tolerance);
        } else {
          EXPECT_LE(error, tolerance);
        }
      }
    }
  }
}

/// Relative deviation, root mean square, of V_c at 90 degrees from the sharp corner of table 2 of the paper,
/// measured at 1000 and 3000 mm/min with 10 and 50 um; `filter_time` 0: from the feed, with 76.9 m/s3.
double deviation_from_sharp_corner(double filter_time) {
  struct Measured {
    double feed, tolerance, speed;  // mm/min, mm, mm/min
  };
  double sum = 0;
  for (const Measured& m : {Measured{1000, 0.01, 124}, Measured{1000, 0.05, 482}, Measured{3000, 0.01, 113},
                            Measured{3000, 0.05, 465}}) {
    const double feed = m.feed / 60;
    const double t1 = filter_time > 0 ? filter_time : std::sqrt(feed / 76900);
    const double off = 60 * corner_speed(3, t1, {feed, feed, units::pi / 2}, m.tolerance) / m.speed - 1;
    sum += off * off / 4;
  }
  return std::sqrt(sum);
}

TEST(WardCorner, SpeedsOfThePaperDoNotGiveTheFilterTime) {
  EXPECT_NEAR(deviation_from_sharp_corner(0.0255), 0.244, 5e-4);
  EXPECT_NEAR(deviation_from_sharp_corner(0), 0.237, 5e-4);
  EXPECT_NEAR(deviation_from_sharp_corner(0.0197), 0.105, 5e-4);
}

TEST(WardPointToPoint, TimesAndPeaksAreThoseOfThePaper) {
  // Ward 2021, section 2.2: 6 mm at 3000 mm/min, T_acc = 0.0765 s; models/ward/README.md.
  struct Case {
    int filters;
    double t1, acceleration, jerk;
  };
  for (const Case& c : {Case{2, 0.03825, 1307.19, 34175}, Case{3, 0.0255, 1470.59, 76894}}) {
    const Toolpath path = testing::polyline({{0, 0, 0}, {6, 0, 0}}, 50);
    const Trajectory trajectory = run(path, {c.filters, 0, c.t1});
    EXPECT_NEAR(trajectory.duration(), 0.1965, exact * 0.1965);
    const Summary summary = summarise(trajectory, path, Vec3::Constant(500));
    EXPECT_NEAR(summary.axes[0].acceleration, c.acceleration, 5e-6 * c.acceleration);
    EXPECT_NEAR(summary.axes[0].jerk, c.jerk, 2e-5 * c.jerk) << "printed with five digits";
    EXPECT_NEAR(summary.axes[0].jerk, 50 / (c.t1 * c.t1), exact * c.jerk);
    EXPECT_NEAR(summary.axes[0].acceleration, (c.filters == 2 ? 1 : 0.75) * 50 / c.t1, exact * 1000);
    EXPECT_NEAR(summary.peak_feed, 50, 1e-9);
    EXPECT_NEAR(trajectory.path_length(), 6, 1e-9);
  }
}

TEST(WardPointToPoint, FilterTimeIsTheRootOfFeedOverJerk) {
  const Toolpath path = testing::polyline({{0, 0, 0}, {6, 0, 0}}, 50);
  for (const int filters : {2, 3}) {
    const double t1 = std::sqrt(0.05 / 40);
    EXPECT_NEAR(run(path, {filters, 40}).duration(), 6 / 50.0 + filters * t1, 1e-12);
  }
}

TEST(WardRightAngle, PulsesAndTimesAreThoseDerived) {
  // models/ward/README.md: two 20 mm legs, n = 3, J 76.9 m/s3.
  struct Case {
    double feed, tolerance, a, width, time;
  };
  for (const Case& c :
       {Case{1000, 0.01, .141519, .0189576, 2.4767149}, Case{1000, 0.05, .645476, .0078288, 2.4497165},
        Case{3000, 0.01, .027304, .0372041, 0.9488733}, Case{3000, 0.05, .136212, .0330385, 0.9335732}}) {
    const double feed = units::from_mm_min(c.feed);
    const double t1 = std::sqrt(feed / 76900);
    const double a = corner_speed(3, t1, {feed, feed, units::pi / 2}, c.tolerance) / feed;
    EXPECT_NEAR(a, c.a, 5e-7);
    EXPECT_NEAR(1.5 * t1 * (1 - a), c.width, 5e-8);
    for (const bool enforce : {false, true}) {
      const Trajectory trajectory = run(right_angle(c.feed), {3, 76.9, 0, c.tolerance, enforce});
      EXPECT_NEAR(trajectory.duration(), c.time, exact * c.time);
      ASSERT_EQ(trajectory.blend_count(), 1u);
      EXPECT_NEAR(trajectory.blend(0).epsilon, c.tolerance, 1e-6 * c.tolerance);
    }
  }
}

TEST(WardRightAngle, SpeedInTheMiddleIsThatOfTheClosedForm) {
  for (const int filters : {2, 3}) {
    for (const double tolerance : {0.01, 0.2, 5.0}) {
      const Trajectory trajectory = run(right_angle(3000), {filters, 76.9, 0, tolerance});
      const double t1 = std::sqrt(50 / 76900.0);
      const double a = corner_speed(filters, t1, {50, 50, units::pi / 2}, tolerance) / 50;
      const double expected = 2 * std::cos(units::pi / 4) * 50 * corner_speed_share(filters, a);
      EXPECT_NEAR(trajectory.state(trajectory.duration() / 2).speed, expected, 1e-9 * expected);
    }
  }
}

TEST(WardShortBlocks, PulsesCoverTheBlockExactly) {
  for (const double length : {1e-6, 1e-3, 0.1, 0.7, 3.0}) {
    const auto path = std::make_shared<const Toolpath>(
        testing::polyline({{0, 0, 0}, {10, 0, 0}, {10, length, 0}, {20, length, 0}}, 50));
    PulseTrain train{path, 0, 2, 0.038, 0, std::vector<BlockPulses>(4)};
    const std::vector<SpeedBound> limits(3, {50, {}});
    std::vector<double> speeds{0, 3, 20};
    cap_by_short_blocks(train, speeds);
    lay_pulses(train, limits, speeds);
    double end = 0;
    for (std::size_t i = 0; i < train.size(); ++i) {
      const PulseWidths widths = train.widths(i);
      EXPECT_LE(train.blocks[i].feed, 50);
      EXPECT_NEAR(train.blocks[i].start, end, 1e-15);
      EXPECT_NEAR(train.blocks[i].corner_speed * widths.left + train.blocks[i].feed * widths.middle +
                      train.blocks[i + 1].corner_speed * widths.right,
                  train.segment(i).length, 1e-12);
      end += widths.sum();
    }
    EXPECT_NEAR(train.end(), end, 1e-15);
  }
}

TEST(WardShortBlocks, PulsesAndFeedSettleWhereTheToleranceIsNotEnforced) {
  // In the middle of a long regular polygon all corners are alike: V_c is that of legs with the feed f of a
  // short block, and f = 2 c V_c^2/(2 c V_c - L) is that of such corners (models/ward/README.md).
  for (const double radius : {2.0, 4.0, 8.6}) {
    for (const int degrees : {2, 5, 10}) {
      std::vector<Vec3> points;
      const double turn = units::from_deg(degrees);
      for (int i = 0; i <= 720; ++i) {
        points.push_back({radius * std::cos(i * turn), radius * std::sin(i * turn), 0});
      }
      const double length = (points[1] - points[0]).norm();
      const Trajectory trajectory = run(testing::polyline(points, 50), {3, 0, 0.0255, 0.01, false});
      const PulseTrain& train = trajectory.motions()[0].train();
      const BlockPulses& middle = train.blocks[360];
      EXPECT_NEAR(middle.corner_speed, corner_speed(3, 0.0255, {middle.feed, middle.feed, turn}, 0.01),
                  1e-9 * middle.corner_speed)
          << radius << ", " << degrees;
      const double reach = 2 * train.half_delay() * middle.corner_speed;
      const double feed = reach > length ? reach * middle.corner_speed / (reach - length) : 50;
      EXPECT_NEAR(middle.feed, std::min(feed, 50.0), 1e-9 * middle.feed) << radius << ", " << degrees;
    }
  }
}

TEST(WardSettings, TheFilterTimeOfTheDmgIsAConstantOfTheMachine) {
  const ControlModel& ward = find_model("ward");
  const Machine machine = shipped_machines().load("dmg-mori-evo40");
  const Settings settings = complete_settings(ward, machine);
  for (const double feed : {10.0, 50.0, 300.0}) {
    const Toolpath path = testing::polyline({{0, 0, 0}, {60, 0, 0}}, feed);
    EXPECT_NEAR(ward.simulate(path, machine, settings).duration(), 60 / feed + 3 * 0.0255, 1e-9) << feed;
  }
}

TEST(WardShortBlocks, CornersWithinOneWindowKeepTheToleranceOnlyIfEnforced) {
  std::vector<Vec3> points;
  for (int i = 0; i <= 90; ++i) {
    const double angle = units::from_deg(2 * i);  // every corner adds to what its neighbours cut off
    points.push_back({8.6 * std::cos(angle), 8.6 * std::sin(angle), 0});
  }
  const Toolpath path = testing::polyline(points, 50);
  const auto worst = [&](bool enforce) {
    const Trajectory trajectory = run(path, {3, 76.9, 0, 0.01, enforce});
    double error = 0;
    for (const BlendRecord& blend : testing::blends_of(trajectory)) {
      error = std::max(error, blend.epsilon);
    }
    return error;
  };
  EXPECT_GT(worst(false), 0.013);
  EXPECT_LE(worst(true), 0.01 * (1 + 1e-5));
}

TEST(WardStops, EveryStretchTakesItsPulsesAndTheDelay) {
  // There and back: the reversal is a full stop, so the two lines take what each takes alone.
  const Toolpath there = testing::polyline({{0, 0, 0}, {20, 0, 0}}, 50);
  const Toolpath both = testing::polyline({{0, 0, 0}, {20, 0, 0}, {0, 0, 0}}, 50);
  EXPECT_NEAR(run(both, {}).duration(), 2 * run(there, {}).duration(), 1e-12);
  EXPECT_LT(run(both, {}).state(run(there, {}).duration()).speed, 1e-9);
}

TEST(WardArc, RunsACircleInTheTimeOfTheArcWithinTheTolerance) {
  Toolpath path;
  path.start = Vec3(10, 0, 0);
  testing::append_arc(path, Vec3::Zero(), 2 * units::pi, 20);
  const Trajectory trajectory = run(path, {3, 76.9, 0, 0.05});
  const double t1 = std::sqrt(20 / 76900.0);
  EXPECT_NEAR(trajectory.duration(), 2 * units::pi * 10 / 20 + 3 * t1, 1e-5) << "T1 of the chords' speed";
  for (int i = 0; i <= 1000; ++i) {
    EXPECT_NEAR(trajectory.state(trajectory.duration() * i / 1000).position.norm(), 10, 0.05);
  }
}

TEST(WardArc, SpeedIsThatAtWhichTheFiltersLoseTheTolerance) {
  Toolpath path;
  path.start = Vec3(4, 0, 0);
  testing::append_arc(path, Vec3::Zero(), 2, 20);
  const Arc& arc = path.arcs[0];
  for (const int filters : {2, 3}) {
    for (const double tolerance : {1e-9, 1e-3, 0.1, 3.0}) {
      const double speed = arc_speed(filters, 0.05, arc, tolerance);
      const double x = speed / arc.radius * 0.05 / 2;
      EXPECT_NEAR(1 - turn_gain(filters, x), tolerance / arc.radius, 1e-15 + 1e-9 * tolerance);
      EXPECT_LT(x, units::pi);
    }
    EXPECT_TRUE(std::isinf(arc_speed(filters, 0.05, arc, 4)));
  }
}

TEST(WardArc, LosesTheToleranceIfEnforcedAndTellsWhatItLosesIfNot) {
  Toolpath path;
  path.start = Vec3(4, 0, 0);
  testing::append_arc(path, Vec3::Zero(), 4 * units::pi, 60);
  for (const int filters : {2, 3}) {
    const Trajectory kept = run(path, {filters, 15, 0, 0.02});
    EXPECT_NEAR(kept.state(kept.duration() / 2).position.norm(), 4 - 0.02, 1e-9);
    EXPECT_NEAR(kept.motions()[0].contour_error(), 0.02, 1e-7);
    EXPECT_EQ(kept.state(kept.duration() / 2).cause, Cause{CauseKind::contour_tolerance});
    const Trajectory free = run(path, {filters, 15, 0, 0.02, false});
    const double lost = 4 - free.state(free.duration() / 2).position.norm();
    const double t1 = free.motions()[0].filter_time();
    const double x = free.motions()[0].train().largest_feed / 4 * t1 / 2;
    EXPECT_NEAR(lost, 4 * (1 - std::pow(std::sin(x) / x, filters)), 1e-9);
    EXPECT_NEAR(free.motions()[0].contour_error(), lost, 1e-7);
    EXPECT_GT(lost, 0.1);
    EXPECT_NEAR(summarise(free, path, Vec3::Constant(500)).max_contour_error, lost, 1e-7);
  }
}

TEST(WardArc, ALargeOneIsALine) {
  Toolpath line;
  line.start = Vec3::Zero();
  testing::append_line(line, Vec3(5, 0, 0), 50);
  Toolpath arc;
  arc.start = Vec3::Zero();
  testing::append_arc(arc, Vec3(0, 1e6, 0), 5e-6, 50);
  const Trajectory straight = run(line, {});
  const Trajectory turned = run(arc, {});
  EXPECT_NEAR(turned.duration(), straight.duration(), 1e-9);
  for (int i = 0; i <= 20; ++i) {
    const double t = straight.duration() * i / 20;
    EXPECT_LT((turned.state(t).position - straight.state(t).position).norm(), 2e-5);  // sagitta of 5 mm
    EXPECT_NEAR(turned.state(t).speed, straight.state(t).speed, 1e-5);
  }
}

TEST(WardSettings, RefuseAnOddNumberOfFilters) {
  const ControlModel& ward = find_model("ward");
  Machine machine = testing::spinner();
  Settings settings = complete_settings(ward, machine);
  for (const char* wrong : {"filters=7", "filters=2.5", "filter_jerk_m_s3=-1", "enforce=maybe"}) {
    EXPECT_THROW(apply_setting(wrong, ward, machine, settings), InputError) << wrong;
  }
}

TEST(WardSettings, FiltersAreOffOrNotTooShort) {
  const ControlModel& ward = find_model("ward");
  Machine machine = testing::spinner();
  Settings settings = complete_settings(ward, machine);
  for (const char* wrong : {"filter_jerk_m_s3=5e-324", "filter_jerk_m_s3=0.0009", "filter_time_s=0.00009"}) {
    EXPECT_THROW(apply_setting(wrong, ward, machine, settings), InputError) << wrong;
  }
  for (const char* right :
       {"filter_jerk_m_s3=0", "filter_jerk_m_s3=0.001", "filter_time_s=0", "filter_time_s=0.0001"}) {
    EXPECT_NO_THROW(apply_setting(right, ward, machine, settings)) << right;
  }
}

TEST(WardSettings, AFilterLongerThanTheProgramIsARampUpAndDown) {
  const Toolpath path = testing::polyline({{0, 0, 0}, {1, 0, 0}}, 50);
  const Trajectory trajectory = run(path, {2, 0, 5});
  EXPECT_NEAR(trajectory.duration(), 1 / 50.0 + 10, 1e-12);
  EXPECT_LT((trajectory.state(trajectory.duration()).position - Vec3(1, 0, 0)).norm(), 1e-12);
}

}  // namespace
}  // namespace feedscope

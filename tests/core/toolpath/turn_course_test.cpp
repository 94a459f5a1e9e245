#include "core/toolpath/turn_course.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "core/base/units.h"
#include "tests/core/toolpath/table_machine.h"

namespace feedscope {
namespace {

constexpr double deg = units::pi / 180;

KinematicChain table() {
  return chain_of(table_machine().kinematics);
}

Vec3 direction_of(const KinematicChain& chain, const std::array<double, 3>& angles) {
  return chain.pose(std::vector<double>{angles[2], angles[0], 0, 0, 0}, 0).direction;
}

SegmentTurn turn_between(double a0, double c0, double a1, double c1) {
  SegmentTurn turn;
  turn.from = {a0 * deg, 0, c0 * deg};
  turn.to = {a1 * deg, 0, c1 * deg};
  turn.great_circle = true;
  return turn;
}

TEST(TurnCourses, OnAGreatCircleTurnTheToolAtAnEvenRateInOnePlane) {
  const KinematicChain chain = table();
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(0, 1);
  constexpr double length = 12;
  for (int i = 0; i < 100; ++i) {
    const double c0 = 360 * share(random);
    const SegmentTurn turn =
        turn_between(10 + 40 * share(random), c0, 10 + 40 * share(random), c0 + 100 * share(random) - 50);
    const TurnCourse course(chain, turn, length);
    const Vec3 start = direction_of(chain, turn.from);
    const Vec3 end = direction_of(chain, turn.to);
    const Vec3 across = start.cross(end).normalized();
    const double swing = std::acos(start.dot(end));
    for (int k = 0; k <= 10; ++k) {
      const Vec3 at = direction_of(chain, course.angles(length * k / 10));
      EXPECT_NEAR(at.dot(across), 0, 1e-9);
      EXPECT_NEAR(std::atan2(start.cross(at).dot(across), start.dot(at)), swing * k / 10, 1e-9);
    }
    EXPECT_NEAR(course.angles(length)[2], turn.to[2], 1e-9);
    EXPECT_NEAR(course.angles(length)[0], turn.to[0], 1e-9);
  }
}

/// Whether an axis moves by more than 0.1 rad however close two places of the way are.
bool jumps(const TurnCourse& course, double from, double to) {
  constexpr double close = 1e-13;
  const std::array<double, 3> a = course.angles(from);
  const std::array<double, 3> b = course.angles(to);
  double step = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    step = std::max(step, std::abs(b[k] - a[k]));
  }
  if (step < 0.1) {
    return false;
  }
  const double middle = (from + to) / 2;
  return to - from < close || jumps(course, from, middle) || jumps(course, middle, to);
}

bool jumps(const TurnCourse& course, const SegmentTurn& turn) {
  constexpr int looks = 200;
  for (std::size_t k = 0; k < 3; ++k) {
    if (std::abs(course.angles(0)[k] - turn.from[k]) > 1e-6 ||
        std::abs(course.angles(1)[k] - turn.to[k]) > 1e-6) {
      return true;
    }
  }
  for (int i = 0; i < looks; ++i) {
    if (jumps(course, i / static_cast<double>(looks), (i + 1) / static_cast<double>(looks))) {
      return true;
    }
  }
  return false;
}

/// How far the tool's direction is from the plane of the great circle, at most.
double off_circle(const KinematicChain& chain, const TurnCourse& course, const SegmentTurn& turn) {
  const Vec3 across = direction_of(chain, turn.from).cross(direction_of(chain, turn.to)).normalized();
  double most = 0;
  for (int i = 0; i <= 100; ++i) {
    most = std::max(most, std::abs(direction_of(chain, course.angles(i / 100.0)).dot(across)));
  }
  return most;
}

/// A 45 degree nutating table over a turntable.
KinematicChain nutating_table() {
  std::vector<ChainAxis> axes = table().axes();
  for (ChainAxis& axis : axes) {
    if (axis.name == 'A') {
      axis.direction = Vec3(0, 1, 1).normalized();
    }
  }
  return {axes, Vec3::Zero(), Vec3::UnitZ()};
}

TEST(TurnCourses, NeverJumpAndStayOnTheGreatCircleThatLeadsToTheEnd) {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> share(-1, 1);
  for (const KinematicChain& chain : {table(), nutating_table()}) {
    int on_circle = 0;
    for (int i = 0; i < 400; ++i) {
      const double tilt = i % 2 == 0 ? 80 * deg : 2 * deg;
      SegmentTurn turn;
      turn.great_circle = true;
      turn.from = {tilt * share(random), 0, 360 * deg * share(random)};
      const Vec3 end = direction_of(chain, {tilt * share(random), 0, 360 * deg * share(random)});
      int going_on = 0;
      for (const RotaryPlaces& places : chain.turn_to(end, std::vector<double>{turn.from[2], turn.from[0]})) {
        turn.to = {places.angles[1], 0, places.angles[0]};
        const TurnCourse course(chain, turn, 1);
        EXPECT_FALSE(jumps(course, turn)) << i << ", to " << turn.to[0] << ", " << turn.to[2];
        if (course.goes_on()) {
          ++going_on;
          EXPECT_LT(off_circle(chain, course, turn), 1e-9) << i;
        }
      }
      EXPECT_LE(going_on, 1) << "of the positions that hold one direction";
      on_circle += going_on;
    }
    EXPECT_GT(on_circle, 300);
  }
}

TEST(TurnCourses, GoThroughThePoleByTheSecondAxisAlone) {
  const KinematicChain chain = table();
  EXPECT_TRUE(TurnCourse(chain, turn_between(10, 30, -15, 30), 1).goes_on());
  EXPECT_FALSE(TurnCourse(chain, turn_between(10, 30, 15, 210), 1).goes_on());
  EXPECT_TRUE(TurnCourse(chain, turn_between(0, 30, 20, 30), 1).goes_on());
  EXPECT_FALSE(TurnCourse(chain, turn_between(0, 30, 20, 80), 1).goes_on()) << "C would have to jump";
}

TEST(TurnCourses, HaveTheDerivativesOfTheirAngles) {
  const KinematicChain chain = table();
  const TurnCourse course(chain, turn_between(12, -60, 25, 70), 8);
  const double h = 1e-3;
  for (double s = 0.1; s < 7.9; s += 0.3) {
    const std::vector<Series> at = course.at(s);
    for (std::size_t k = 0; k < 2; ++k) {
      const auto value = [&](double away) { return course.at(s + away)[k].value(); };
      EXPECT_NEAR(at[k].d1(), (value(h) - value(-h)) / (2 * h), 1e-6);
      EXPECT_NEAR(at[k].d2(), (value(h) - 2 * value(0) + value(-h)) / (h * h), 1e-5);
      EXPECT_NEAR(at[k].d3(), (value(2 * h) - 2 * value(h) + 2 * value(-h) - value(-2 * h)) / (2 * h * h * h),
                  1e-2);
    }
  }
}

TEST(TurnCourses, FindThePlaceNearestToThePole) {
  const KinematicChain chain = table();
  std::mt19937 random(8);
  std::uniform_real_distribution<double> share(0, 1);
  for (int i = 0; i < 50; ++i) {
    const SegmentTurn turn =
        turn_between(5 + 30 * share(random), 85 * share(random), 5 + 30 * share(random), -85 * share(random));
    const TurnCourse course(chain, turn, 1);
    double least = 10;
    double place = 0;
    for (int k = 0; k <= 2000; ++k) {
      const double tilt = std::abs(course.angles(k / 2000.0)[0]);
      if (tilt < least) {
        least = tilt;
        place = k / 2000.0;
      }
    }
    EXPECT_NEAR(*course.nearest_to_pole(), place, 1e-3);
  }
}

TEST(TurnCourses, AreLinearWithoutAGreatCircle) {
  const KinematicChain chain = table();
  SegmentTurn turn = turn_between(10, 0, 20, 90);
  turn.great_circle = false;
  const TurnCourse course(chain, turn, 10);
  EXPECT_NEAR(course.angles(2.5)[2], 22.5 * deg, 1e-12);
  EXPECT_NEAR(course.at(2.5)[0].d1(), 9 * deg, 1e-12) << "C stands first in the chain";
  EXPECT_EQ(course.at(2.5)[0].d2(), 0);
  EXPECT_FALSE(course.nearest_to_pole());
}

}  // namespace
}  // namespace feedscope

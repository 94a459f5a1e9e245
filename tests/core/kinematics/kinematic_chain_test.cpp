#include "core/kinematics/kinematic_chain.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "core/base/error.h"
#include "tests/core/kinematics/differences.h"

namespace feedscope {
namespace {

using std::numbers::pi;

constexpr double tool_length = 120;

ChainAxis slide(char name, const Vec3& direction, bool carries_part = false) {
  return {name, false, carries_part, direction};
}
ChainAxis turn(char name, const Vec3& direction, const Vec3& point, bool carries_part) {
  return {name, true, carries_part, direction, point};
}

/// Trunnion: C on A, both under the part; linear axes carry the tool.
KinematicChain table_table() {
  return {{turn('C', Vec3::UnitZ(), {10, -20, 0}, true), turn('A', Vec3::UnitX(), {0, -20, 35}, true),
           slide('X', Vec3::UnitX()), slide('Y', Vec3::UnitY()), slide('Z', Vec3::UnitZ())},
          {0, 0, 300},
          Vec3::UnitZ()};
}
/// Turning table and swivelling head.
KinematicChain head_table() {
  return {
      {turn('C', Vec3::UnitZ(), {0, 0, 0}, true), slide('Y', Vec3::UnitY(), true), slide('X', Vec3::UnitX()),
       slide('Z', Vec3::UnitZ()), turn('B', Vec3::UnitY(), {0, 0, 450}, false)},
      {0, 0, 300},
      Vec3::UnitZ()};
}
KinematicChain head_head() {
  return {{slide('X', Vec3::UnitX()), slide('Y', Vec3::UnitY()), slide('Z', Vec3::UnitZ()),
           turn('C', Vec3::UnitZ(), {5, 3, 0}, false), turn('B', Vec3::UnitY(), {5, 0, 500}, false)},
          {0, 0, 300},
          Vec3::UnitZ()};
}
/// B turns about a line 45 degrees between Y and Z.
KinematicChain nutating() {
  return {
      {turn('C', Vec3::UnitZ(), {0, 0, 0}, true), slide('X', Vec3::UnitX(), true), slide('Y', Vec3::UnitY()),
       slide('Z', Vec3::UnitZ()), turn('B', Vec3(0, 1, 1), {0, 30, 400}, false)},
      {0, 0, 300},
      Vec3::UnitZ()};
}
std::vector<KinematicChain> usual_chains() {
  return {table_table(), head_table(), head_head(), nutating()};
}

Vec3 random_direction(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return Vec3(normal(random), normal(random), normal(random)).normalized();
}

/// Any two rotary axes on any sides, linear axes neither at right angles nor in order.
KinematicChain random_chain(std::mt19937& random) {
  std::uniform_real_distribution<double> place(-300, 300);
  std::uniform_int_distribution<int> coin(0, 1);
  for (;;) {
    std::vector<ChainAxis> axes;
    std::vector<bool> on_part;
    for (int i = 0; i < 5; ++i) {
      on_part.push_back(coin(random) == 1);
    }
    std::sort(on_part.begin(), on_part.end(), std::greater());
    std::string kinds = "LLLRR";
    std::ranges::shuffle(kinds, random);
    for (std::size_t i = 0; i < 5; ++i) {
      axes.push_back({static_cast<char>('A' + i),
                      kinds[i] == 'R',
                      on_part[i],
                      random_direction(random),
                      {place(random), place(random), place(random)}});
    }
    Eigen::Matrix3d slides;
    int column = 0;
    std::vector<Vec3> turns;
    for (const ChainAxis& axis : axes) {
      if (axis.rotary) {
        turns.push_back(axis.direction);
      } else {
        slides.col(column++) = axis.direction;
      }
    }
    const Vec3 tool = random_direction(random);
    if (std::abs(slides.determinant()) > 0.2 && turns[0].cross(turns[1]).norm() > 0.3 &&
        turns[1].cross(tool).norm() > 0.3) {
      return {std::move(axes), {place(random), place(random), place(random)}, tool};
    }
  }
}

TEST(KinematicChain, AllAxesAtZeroHoldTheToolBeforeTheGauge) {
  for (const KinematicChain& chain : usual_chains()) {
    const ToolPose pose = chain.pose(std::vector<double>(5, 0.0), tool_length);
    EXPECT_LT((pose.tip - Vec3(0, 0, 180)).norm(), 1e-12);
    EXPECT_LT((pose.direction - Vec3::UnitZ()).norm(), 1e-15);
  }
}

TEST(KinematicChain, ATiltedTableTurnsThePartTheOtherWay) {
  // A by +90 degrees lifts the side of +Y of a table upright: in the part the tool then comes from +Y.
  const ToolPose pose = table_table().pose(std::vector{0.0, pi / 2, 0.0, 0.0, 0.0}, tool_length);
  EXPECT_LT((pose.direction - Vec3(0, 1, 0)).norm(), 1e-12);
  // The tip, 145 mm above the axis and 20 mm beside it in Y, comes to lie 145 mm beside and 20 mm below.
  EXPECT_LT((pose.tip - Vec3(0, -20 + 145, 35 - 20)).norm(), 1e-12);
  const ToolPose tilted = head_head().pose(std::vector{0.0, 0.0, 0.0, 0.0, pi / 6}, tool_length);
  EXPECT_LT((tilted.direction - Vec3(0.5, 0, std::sqrt(0.75))).norm(), 1e-12)
      << "a head turns the tool itself";
}

TEST(KinematicChain, RoundTripsMeetEveryDirectionWithinReach) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> angle(-pi, pi);
  std::uniform_real_distribution<double> place(-500, 500);
  std::vector<KinematicChain> chains = usual_chains();
  for (int i = 0; i < 200; ++i) {
    chains.push_back(random_chain(random));
  }
  int two_ways = 0;
  for (const KinematicChain& chain : chains) {
    for (int i = 0; i < 20; ++i) {
      std::vector<double> places(5);
      for (std::size_t axis = 0; axis < 5; ++axis) {
        places[axis] = chain.axes()[axis].rotary ? angle(random) : place(random);
      }
      const ToolPose pose = chain.pose(places, tool_length);
      const std::vector<double> from{places[chain.rotary()[0]], places[chain.rotary()[1]]};
      const auto ways = chain.turn_to(pose.direction, from);
      ASSERT_FALSE(ways.empty());
      two_ways += ways.size() == 2 ? 1 : 0;
      EXPECT_NEAR(ways[0].angles[0], from[0], 1e-6) << "the nearer one first";
      EXPECT_NEAR(ways[0].angles[1], from[1], 1e-6);
      for (const RotaryPlaces& way : ways) {
        const std::vector<double> found = chain.places(pose.tip, way.angles, tool_length);
        const ToolPose again = chain.pose(found, tool_length);
        EXPECT_LT((again.tip - pose.tip).norm(), 1e-9);
        EXPECT_LT((again.direction - pose.direction).norm(), 1e-7);
      }
    }
  }
  EXPECT_GT(two_ways, 3500);
}

TEST(KinematicChain, TheAnglesAreThoseOfClosedForms) {
  // Trunnion: C turns the part until the tool leans along Y, A tilts.
  const double tilt = 0.3;
  const double heading = 0.8;
  const Vec3 direction(std::sin(tilt) * std::cos(heading), std::sin(tilt) * std::sin(heading),
                       std::cos(tilt));
  const auto ways = table_table().turn_to(direction, std::vector{0.0, 0.0});
  ASSERT_EQ(ways.size(), 2U);
  std::vector<double> tilts{ways[0].angles[1], ways[1].angles[1]};
  std::ranges::sort(tilts);
  EXPECT_NEAR(tilts[0], -tilt, 1e-12);
  EXPECT_NEAR(tilts[1], tilt, 1e-12);
  // A nutating axis at 45 degrees reaches 90 degrees of tilt at half a turn, and no more.
  EXPECT_EQ(nutating().turn_to(Vec3(0, 1, 0), std::vector{0.0, 0.0}).size(), 1U);
  EXPECT_NEAR(std::abs(nutating().turn_to(Vec3(0, 1, 0), std::vector{0.0, 0.0})[0].angles[1]), pi, 1e-6);
  EXPECT_TRUE(nutating().turn_to(Vec3(0, 1, -0.1).normalized(), std::vector{0.0, 0.0}).empty());
}

TEST(KinematicChain, TravelChoosesTheWayOrRefusesIt) {
  std::vector<ChainAxis> axes = table_table().axes();
  axes[1].least = -0.1;
  axes[1].most = 2;
  axes[0].least = 0;
  axes[0].most = 4 * pi;
  const KinematicChain chain(axes, {0, 0, 300}, Vec3::UnitZ());
  const Vec3 direction(0, std::sin(0.5), std::cos(0.5));
  const auto ways = chain.turn_to(direction, std::vector{3 * pi, 0.0});
  ASSERT_EQ(ways.size(), 1U) << "a tilt of -0.5 is out of reach";
  EXPECT_NEAR(ways[0].angles[1], 0.5, 1e-12);
  EXPECT_GE(ways[0].angles[0], 0);
  EXPECT_NEAR(std::remainder(ways[0].angles[0], 2 * pi), 0, 1e-12);
  EXPECT_GT(ways[0].angles[0], pi) << "as near as whole turns allow";
  EXPECT_TRUE(chain.turn_to(Vec3(0, std::sin(2.5), std::cos(2.5)), std::vector{0.0, 0.0}).empty());
  EXPECT_EQ(chain.beyond_travel(std::vector{-0.2, 0.0, 0.0, 0.0, 0.0}), 0U);
  EXPECT_EQ(chain.beyond_travel(std::vector{0.0, 0.0, 9e9, 0.0, 0.0}), std::nullopt);
}

TEST(KinematicChain, AlongTheFirstAxisTheFirstAngleStays) {
  const auto ways = table_table().turn_to(Vec3::UnitZ(), std::vector{1.2, 0.4});
  ASSERT_EQ(ways.size(), 1U);
  EXPECT_TRUE(ways[0].singular);
  EXPECT_EQ(ways[0].angles[0], 1.2);
  EXPECT_NEAR(ways[0].angles[1], 0, 1e-12);
  const std::array<Series, 3> passing{Series(0), Series(0, 1, 0, 0), Series(1)};
  EXPECT_FALSE(table_table().turning(passing, std::vector{1.2, 0.0}).has_value());
}

TEST(KinematicChain, FourAxesHoldTheDirectionsOfTheirCone) {
  const KinematicChain chain({turn('A', Vec3::UnitX(), {0, 0, 0}, true), slide('X', Vec3::UnitX()),
                              slide('Y', Vec3::UnitY()), slide('Z', Vec3::UnitZ())},
                             {0, 0, 200}, Vec3::UnitZ());
  const auto ways = chain.turn_to(Vec3(0, std::sin(0.7), std::cos(0.7)), std::vector{0.0});
  ASSERT_EQ(ways.size(), 1U);
  EXPECT_NEAR(ways[0].angles[0], 0.7, 1e-12);
  EXPECT_TRUE(chain.turn_to(Vec3(1, 0, 1).normalized(), std::vector{0.0}).empty());
}

/// A tip at rest while the tool swings: the linear axes go round with it.
TEST(KinematicChain, LinearAxesCompensateWhereTheTipStands) {
  const KinematicChain chain = head_head();
  const double arm = (Vec3(0, 0, 300 - tool_length) - Vec3(5, 0, 500)).norm();
  const std::array<Series, 3> tip{Series(10), Series(20), Series(30)};
  const Series b(0.4, 1, 0, 0);
  const std::vector<Series> courses = chain.courses(tip, std::vector{Series(0), b}, tool_length);
  const double speed = std::hypot(courses[0].d1(), courses[2].d1());
  EXPECT_NEAR(speed, std::hypot(5, 320), 1e-9);
  EXPECT_NEAR(speed, arm, 1e-9);
  EXPECT_NEAR(std::hypot(courses[0].d2(), courses[2].d2()), arm, 1e-9) << "a circle about the pivot";
  EXPECT_NEAR(courses[1].d1(), 0, 1e-12);
}

/// Near the pole a great circle that misses it by `tilt` turns the first axis by 1/sin(tilt).
TEST(KinematicChain, SpeedOfTheFirstAxisGrowsAsOneOverTheSineOfTheTilt) {
  for (const double tilt : {0.5, 0.1, 0.01, 1e-4}) {
    // d(s) = cos s * d0 + sin s * UnitX, d0 leaning along Y: nearest to the pole at s = 0.
    const Series s(0, 1, 0, 0);
    const std::array<Series, 3> direction{sin(s), cos(s) * Series(std::sin(tilt)),
                                          cos(s) * Series(std::cos(tilt))};
    const auto turning = table_table().turning(direction, std::vector{0.0, tilt});
    ASSERT_TRUE(turning);
    EXPECT_NEAR(std::abs((*turning)[0].d1()), 1 / std::sin(tilt), 1e-6 / std::sin(tilt));
    EXPECT_NEAR((*turning)[1].d1(), 0, 1e-9 / tilt);
  }
}

/// On a cone of constant tilt the first axis turns evenly and the second stands.
TEST(KinematicChain, AConeTurnsTheFirstAxisEvenly) {
  const double tilt = 0.6;
  for (const double at : {-2.0, 0.3, 1.9}) {
    const Series s(at, 1, 0, 0);
    const std::array<Series, 3> direction{Series(std::sin(tilt)) * cos(s), Series(std::sin(tilt)) * sin(s),
                                          Series(std::cos(tilt))};
    const Vec3 now(direction[0].value(), direction[1].value(), direction[2].value());
    const auto from = table_table().turn_to(now, std::vector{0.0, 0.0})[0].angles;
    const auto turning = table_table().turning(direction, from);
    ASSERT_TRUE(turning);
    EXPECT_NEAR(std::abs((*turning)[0].d1()), 1, 1e-9);
    EXPECT_NEAR((*turning)[0].d2(), 0, 1e-9);
    EXPECT_NEAR((*turning)[1].d1(), 0, 1e-9);
  }
}

TEST(KinematicChain, DerivativesOfAllAxesAreThoseOfDifferences) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> rate(-1, 1);
  std::vector<KinematicChain> chains = usual_chains();
  for (int i = 0; i < 30; ++i) {
    chains.push_back(random_chain(random));
  }
  for (const KinematicChain& chain : chains) {
    const Vec3 start(rate(random), rate(random), rate(random));
    const Vec3 way(rate(random), rate(random), rate(random));
    const std::array<double, 2> angles{2 * rate(random), 2 * rate(random)};
    const std::array<double, 2> turns{rate(random), rate(random)};
    const auto courses = [&](const Series& s) {
      const std::array<Series, 3> tip{Series(100 * start.x()) + Series(10 * way.x()) * s,
                                      Series(100 * start.y()) + Series(10 * way.y()) * s * s,
                                      Series(100 * start.z()) + Series(10 * way.z()) * sin(s)};
      return chain.courses(
          tip,
          std::vector{Series(angles[0]) + Series(turns[0]) * s, Series(angles[1]) + Series(turns[1]) * s},
          tool_length);
    };
    const auto found = courses(Series(0, 1, 0, 0));
    for (std::size_t axis = 0; axis < 5; ++axis) {
      const test::Differences by_differences =
          test::differences([&](double s) { return courses(Series(s))[axis].value(); }, 0, 1e-3);
      const double size =
          std::max(1.0, std::abs(found[axis].d1()));  // of a chain whose axes are nearly parallel
      EXPECT_NEAR(found[axis].d1(), by_differences.d1, 1e-7 * size);
      EXPECT_NEAR(found[axis].d2(), by_differences.d2, 1e-4 * size);
      EXPECT_NEAR(found[axis].d3(), by_differences.d3, 1e-2 * size);
    }
  }
}

TEST(KinematicChain, RefusesWhatCannotHoldATool) {
  const auto fails = [](std::vector<ChainAxis> axes, const Vec3& tool, const std::string& with) {
    EXPECT_THAT([&] { KinematicChain(std::move(axes), Vec3::Zero(), tool); },
                testing::ThrowsMessage<InputError>(testing::HasSubstr(with)))
        << with;
  };
  const std::vector<ChainAxis> xyz{slide('X', Vec3::UnitX()), slide('Y', Vec3::UnitY()),
                                   slide('Z', Vec3::UnitZ())};
  const auto with = [&](std::vector<ChainAxis> more) {
    more.insert(more.begin(), xyz.begin(), xyz.end());
    return more;
  };
  const ChainAxis b = turn('B', Vec3::UnitY(), Vec3::Zero(), false);
  const ChainAxis c = turn('C', Vec3::UnitZ(), Vec3::Zero(), false);
  fails(xyz, Vec3::UnitZ(), "one or two rotary axes and has 0");
  fails(with({b, b, c}), Vec3::UnitZ(), "has 3");
  fails(with({c, c}), Vec3::UnitX(), "axis C of the kinematic chain: it is parallel to C");
  fails(with({b, c}), Vec3::UnitZ(), "axis C of the kinematic chain: it lies along the tool");
  fails({slide('X', Vec3::UnitX()), slide('Y', Vec3::UnitX()), slide('Z', Vec3::UnitZ()), b}, Vec3::UnitZ(),
        "lie in one plane");
  fails({slide('X', Vec3::UnitX()), b}, Vec3::UnitZ(), "three linear axes and has 1");
  fails(with({turn('B', Vec3::UnitY(), Vec3::Zero(), true)}), Vec3::UnitZ(),
        "axis B of the kinematic chain: it carries the part");
  ChainAxis empty = b;
  empty.least = 1;
  empty.most = 1;
  fails(with({empty}), Vec3::UnitZ(), "travel is empty");
  fails(with({turn('B', Vec3::Zero(), Vec3::Zero(), false)}), Vec3::UnitZ(), "direction has no length");
}

}  // namespace
}  // namespace feedscope

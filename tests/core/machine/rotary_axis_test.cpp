#include "core/machine/rotary_axis.h"

#include <gmock/gmock.h>

#include <cmath>
#include <random>

#include "core/base/error.h"
#include "core/base/units.h"
#include "core/feed/ramp.h"
#include "core/machine/machine.h"
#include "core/models/control_model.h"
#include "tests/support/folders.h"

namespace feedscope {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr double deg = units::pi / 180;

RotaryAxis axis_of(double velocity, double acceleration, double jerk) {
  RotaryAxis axis;
  axis.velocity = velocity;
  axis.acceleration = acceleration;
  axis.jerk = jerk;
  return axis;
}

Machine shipped(const std::string& id) {
  return MachineLibrary(std::filesystem::path(FEEDSCOPE_SOURCE_DIR) / "machines", all_model_settings())
      .load(id);
}

TEST(TurningTime, IsThatOfATrapezoidWithRoundedCorners) {
  // Every phase at its limit: V/A + A/J for the two ramps' shapes, and the way at V.
  EXPECT_DOUBLE_EQ(turning_time(axis_of(2, 4, 40), 10), 2.0 / 4 + 4.0 / 40 + 10.0 / 2);
  // Too short for either limit: four phases of constant jerk, D = 2 J (t/4)^3.
  EXPECT_DOUBLE_EQ(turning_time(axis_of(100, 100, 16), 1), 4 * std::cbrt(1.0 / 32));
  EXPECT_EQ(turning_time(axis_of(1, 1, 1), 0), 0);
  EXPECT_EQ(turning_time(axis_of(1, 2, 3), -4), turning_time(axis_of(1, 2, 3), 4));
}

TEST(TurningTime, IsHeldByTheProgrammedFeedAndByTheVelocityLimit) {
  const RotaryAxis axis = axis_of(2, 4, 40);
  RotaryAxis slower = axis;
  slower.velocity = 0.5;
  EXPECT_EQ(turning_time(axis, 3, 0.5), turning_time(slower, 3));
  EXPECT_EQ(turning_time(axis, 3, 50), turning_time(axis, 3));
}

TEST(TurningTime, IsThatOfTheRampsAlongAPath) {
  std::mt19937 random(22);
  std::uniform_real_distribution<double> exponent(-2, 2);
  const auto any = [&] { return std::pow(10, exponent(random)); };
  for (int i = 0; i < 1000; ++i) {
    const RotaryAxis axis = axis_of(any(), any(), any());
    const double way = any();
    const SpeedProfile profile = plan_profile(0, 0, 0, way, axis.velocity, {axis.acceleration, axis.jerk});
    EXPECT_NEAR(turning_time(axis, way), profile.duration(), 1e-5 * profile.duration());
  }
}

TEST(MachineKinematics, TurnTheToolAsISO841Says) {
  // However a positive A is made, by the table or by the head, the tool turns against the part as a
  // right-handed screw about +X: from +Z towards -Y. B: from +Z towards +X.
  const KinematicChain table = chain_of(shipped("five-axis-table-ac").kinematics);
  const Vec3 tilted = table.pose(std::vector<double>{0, 30 * deg, 0, 0, 0}, 100).direction;
  EXPECT_LT((tilted - Vec3(0, -std::sin(30 * deg), std::cos(30 * deg))).norm(), 1e-12);
  const KinematicChain head = chain_of(shipped("five-axis-head-bc").kinematics);
  const Vec3 swung = head.pose(std::vector<double>{0, 0, 0, 0, 30 * deg}, 100).direction;
  EXPECT_LT((swung - Vec3(std::sin(30 * deg), 0, std::cos(30 * deg))).norm(), 1e-12);
}

TEST(MachineKinematics, MoveTheTipWithTheLinearAxesWhicheverSideTheyCarry) {
  for (const char* id : {"five-axis-table-ac", "five-axis-head-b-table-c", "five-axis-head-bc"}) {
    const KinematicChain chain = chain_of(shipped(id).kinematics);
    std::vector<double> places(chain.size(), 0);
    for (std::size_t k = 0; k < 3; ++k) {
      places[chain.linear()[k]] = 10.0 * (1 + chain.axes()[chain.linear()[k]].name - 'X');
    }
    EXPECT_LT((chain.pose(places, 100).tip - Vec3(10, 20, 30 - 100)).norm(), 1e-12) << id;
  }
}

TEST(MachineKinematics, ComeBackToTheDirectionsThatTheyReach) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(-1, 1);
  for (const char* id : {"five-axis-table-ac", "five-axis-head-b-table-c", "five-axis-head-bc"}) {
    const KinematicChain chain = chain_of(shipped(id).kinematics);
    for (int i = 0; i < 200; ++i) {
      const Vec3 direction = Vec3(share(random), share(random), 0.3 + std::abs(share(random))).normalized();
      const auto found = chain.turn_to(direction, std::vector<double>{0, 0});
      ASSERT_FALSE(found.empty()) << id << direction.transpose();
      const Vec3 tip(100 * share(random), 100 * share(random), 100 * share(random));
      for (const RotaryPlaces& places : found) {
        const std::vector<double> axes = chain.places(tip, places.angles, 150);
        EXPECT_LT((chain.pose(axes, 150).direction - direction).norm(), 1e-9) << id;
        EXPECT_LT((chain.pose(axes, 150).tip - tip).norm(), 1e-9) << id;
      }
    }
  }
}

/// xyzac-trt-kins of LinuxCNC for the part at the middle of the table, by its own composition: the table
/// turns about Z, tilts about X through (y, z) = (20, 10) off the middle, and slides. Written from its
/// documentation (5-axis kinematics, XYZAC).
TEST(MachineKinematics, AreThoseOfLinuxCncsTrunnion) {
  const KinematicChain chain = chain_of(shipped("five-axis-table-ac").kinematics);
  const double a = 25 * deg;
  const double c = 40 * deg;
  const Vec3 off(0, 20, 10);
  const Vec3 tip(30, -15, 5);  // from the middle of the table
  const Eigen::Matrix3d spin(Eigen::AngleAxisd(-c, Vec3::UnitZ()));
  const Eigen::Matrix3d tilt(Eigen::AngleAxisd(-a, Vec3::UnitX()));
  const Vec3 slide = tilt * (spin * tip - off) + off;
  const std::vector<double> axes = chain.places(tip + Vec3(0, 0, -320), std::vector<double>{c, a}, 120);
  EXPECT_NEAR(axes[2], slide.x(), 1e-9);
  EXPECT_NEAR(axes[3], slide.y(), 1e-9);
  EXPECT_NEAR(axes[4], slide.z() - 320 + 120, 1e-9);
}

TEST(MachineKinematics, RefuseATextThatIsNoChain) {
  MachineKinematics kinematics = shipped("five-axis-table-ac").kinematics;
  const auto refuses = [&](const std::string& chain, const std::string& why) {
    kinematics.chain = chain;
    EXPECT_THAT([&] { chain_of(kinematics); }, ThrowsMessage<InputError>(HasSubstr(why))) << chain;
  };
  refuses("C A X Y Z", "lacks the word frame");
  refuses("C A X Y frame frame Z", "has the word frame twice");
  refuses("C A X Y frame Q", "has 'Q', which is no axis of this machine");
  refuses("C A X X frame Z", "has X twice");
  refuses("C X Y frame Z", "lacks axis A");
  refuses("C A X frame Z", "needs three linear axes and has 2");
}

TEST(MachineKinematics, RefuseAChainThatCannotHoldADirection) {
  MachineKinematics kinematics = shipped("five-axis-table-ac").kinematics;
  kinematics.rotary[0].direction = Vec3::UnitZ();
  EXPECT_THAT([&] { chain_of(kinematics); }, ThrowsMessage<InputError>(HasSubstr("parallel")));
}

/// 1 rev/s and 2 rev/s2 with a jerk that takes 0.1 s to them: ramps of 0.6 s, each 0.3 rev long.
TEST(RestToRest, IsWhereTheRampsOfConstantJerkAre) {
  const auto at = [](double time) { return rest_to_rest_at(time, 2, 1, 2, 20); };
  EXPECT_NEAR(rest_to_rest_time(2, 1, 2, 20), 2.6, 1e-12);
  EXPECT_EQ(at(0).way, 0);
  EXPECT_EQ(at(-1).way, 0);
  EXPECT_NEAR(at(0.1).way, 20 * 0.001 / 6, 1e-12);
  EXPECT_NEAR(at(0.1).velocity, 20 * 0.01 / 2, 1e-12);
  EXPECT_NEAR(at(0.3).velocity, 0.5, 1e-12);  // the middle of the ramp
  EXPECT_NEAR(at(0.6).way, 0.3, 1e-12);
  EXPECT_NEAR(at(0.6).velocity, 1, 1e-12);
  EXPECT_NEAR(at(1.3).way, 1, 1e-12);
  EXPECT_NEAR(at(2.0).way, 1.7, 1e-12);
  EXPECT_NEAR(at(2.6).way, 2, 1e-12);
  EXPECT_EQ(at(9).way, 2);
  EXPECT_EQ(at(9).velocity, 0);
}

TEST(RestToRest, KeepsItsLimitsAndIsSmoothOnRandomWays) {
  std::mt19937 random(22);
  std::uniform_real_distribution<double> exponent(-2, 2);
  for (int i = 0; i < 200; ++i) {
    const auto any = [&] { return std::pow(10, exponent(random)); };
    const double way = any();
    const double v = any();
    const double a = any();
    const double j = any();
    const double end = rest_to_rest_time(way, v, a, j);
    constexpr int steps = 2000;
    const double h = end / steps;
    double before = 0;
    const RestToRestPlace most = rest_to_rest_peaks(way, v, a, j);
    EXPECT_NEAR(most.velocity, rest_to_rest_at(end / 2, way, v, a, j).velocity, 1e-9 * v);
    EXPECT_LE(most.acceleration, a * (1 + 1e-12));
    for (int k = 1; k < steps; ++k) {
      const auto at = [&](double time) { return rest_to_rest_at(time, way, v, a, j); };
      const RestToRestPlace place = at(k * h);
      const double slope = (at((k + 0.01) * h).way - at((k - 0.01) * h).way) / (0.02 * h);
      ASSERT_NEAR(place.velocity, slope, 1e-4 * way / end) << way << ' ' << v << ' ' << a << ' ' << j;
      ASSERT_LE(place.velocity, v * (1 + 1e-12));
      ASSERT_LE(std::abs(place.velocity - before) / h, a * (1 + 1e-6));
      const double bend = (at((k + 0.01) * h).velocity - at((k - 0.01) * h).velocity) / (0.02 * h);
      ASSERT_NEAR(place.acceleration, bend, 0.02 * j * h) << way << ' ' << v << ' ' << a << ' ' << j;
      ASSERT_LE(std::abs(place.acceleration), most.acceleration * (1 + 1e-12));
      ASSERT_TRUE(place.jerk == 0 || std::abs(place.jerk) == j);
      before = place.velocity;
    }
    EXPECT_NEAR(rest_to_rest_at(end, way, v, a, j).way, way, 1e-12 * way);
  }
}

TEST(RotaryAxisKeys, AreSetAndReadInTheirUnits) {
  Machine machine = shipped("five-axis-table-ac");
  set_axis_value(machine, 'A', "velocity", 30.0);
  EXPECT_DOUBLE_EQ(machine.kinematics.find('A')->velocity, 2 * units::pi / 2);
  EXPECT_EQ(axis_value(machine, 'A', "velocity"), SettingValue(30.0));
  EXPECT_EQ(machine.provenance.at("A.velocity").source, "set by hand");
  set_axis_value(machine, 'A', "minimum", std::string());
  EXPECT_FALSE(machine.kinematics.find('A')->minimum);
  EXPECT_THAT([&] { set_axis_value(machine, 'B', "velocity", 30.0); },
              ThrowsMessage<InputError>(HasSubstr("unknown axis 'B'; the axes are X, Y, Z, A and C")));
  EXPECT_THAT([&] { set_axis_value(machine, 'A', "velocty", 30.0); },
              ThrowsMessage<InputError>(HasSubstr("did you mean 'velocity'?")));
}

}  // namespace
}  // namespace feedscope

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>
#include <string>

#include "core/base/units.h"
#include "core/models/control_model.h"
#include "core/toolpath/machine_path.h"
#include "tests/support/folders.h"

namespace feedscope {
namespace {

Machine five_axes() {
  return MachineLibrary(std::filesystem::path(FEEDSCOPE_SOURCE_DIR) / "machines", all_model_settings())
      .load("five-axis-table-ac");
}

std::shared_ptr<const Toolpath> turning_path(const std::string& text) {
  ReadOptions options;
  options.dialect = Dialect::sinumerik;
  options.unit = LengthUnit::mm;
  options.rotary_axes = "AC";
  return std::make_shared<const Toolpath>(
      build_toolpath(read_program(std::make_shared<const SourceText>("test.mpf", text), nullptr, options)));
}

class RotaryAxes : public testing::TestWithParam<const char*> {
 protected:
  Trajectory run(const std::string& text) const {
    const Machine machine = five_axes();
    const ControlModel& model = find_model(GetParam());
    return model.simulate(turning_path(text), machine, complete_settings(model, machine));
  }
};

double time_by(const Trajectory& trajectory, Cause cause) {
  double sum = 0;
  for (std::size_t i = 0; i < trajectory.pieces().size(); ++i) {
    const double end =
        i + 1 < trajectory.pieces().size() ? trajectory.pieces()[i + 1].time : trajectory.duration();
    sum += trajectory.pieces()[i].cause == cause ? end - trajectory.pieces()[i].time : 0;
  }
  return sum;
}

TEST_P(RotaryAxes, WaitForIndexingAsForADwell) {
  const Machine machine = five_axes();
  const double turn = turning_time(*machine.kinematics.find('C'), units::from_deg(170));
  const Trajectory indexed = run("G0 X10\nG0 A20 C170\nG1 X50 F3000\n");
  const Trajectory dwelled = run(fmt::format("G0 X10\nG4 F{:.12f}\nG1 X50 F3000\n", turn));
  EXPECT_NEAR(indexed.duration(), dwelled.duration(), 1e-9);
  EXPECT_NEAR(time_by(indexed, {CauseKind::indexing, 5}), turn, 1e-9);
}

TEST_P(RotaryAxes, KeepTheirVelocityAlongRandomFeedBlocks) {
  std::mt19937 random(22);
  std::uniform_real_distribution<double> share(-1, 1);
  std::string text = "TRAORI\nG0 X0 Y0 Z0\nG1 F20000\n";
  for (int i = 0; i < 60; ++i) {
    text += fmt::format("X{:.3f} Y{:.3f} A{:.3f} C{:.3f}\n", 5 * i + 2 * share(random), 3 * share(random),
                        20 * share(random), 40 * share(random));
  }
  const Machine machine = five_axes();
  const Trajectory trajectory = run(text);
  const Toolpath& path = *trajectory.path().programmed();
  ASSERT_GT(path.segment_turns.size(), 50);
  constexpr int samples = 4000;
  double largest = 0;
  for (int i = 0; i <= samples; ++i) {
    const State state = trajectory.state(trajectory.duration() * i / samples);
    const SegmentTurn* turn = path.segment_turn(trajectory.path().segment(state.element));
    const ElementKind kind = trajectory.path().kind(state.element);
    if (turn == nullptr || (kind != ElementKind::line && kind != ElementKind::arc)) {
      continue;
    }
    for (const std::size_t axis : {0, 2}) {
      const double limit = machine.kinematics.find("ABC"[axis])->velocity;
      const double slope = std::abs(turn->to[axis] - turn->from[axis]) / path.segments[turn->segment].length;
      EXPECT_LE(state.speed * slope, limit * (1 + 1e-6)) << "line " << path.segments[turn->segment].line;
      largest = std::max(largest, state.speed * slope / limit);
    }
  }
  // Filtered motion has no element of its own at a time.
  EXPECT_TRUE(largest > 0.8 || GetParam() == std::string("ward")) << "the limit is reached somewhere";
}

TEST_P(RotaryAxes, TakeTheLongerTheSlowerTheyAre) {
  Machine machine = five_axes();
  const ControlModel& model = find_model(GetParam());
  const auto path = turning_path("TRAORI\nG0 X0 Y0 Z0\nG1 X100 C180 F20000\n");
  double before = 0;
  for (const double velocity : {100.0, 10.0, 5.0}) {
    set_axis_value(machine, 'C', "velocity", velocity);
    const double time = model.simulate(path, machine, complete_settings(model, machine)).duration();
    EXPECT_GT(time, before) << velocity;
    EXPECT_GE(time, 0.5 / velocity * 60) << "half a turn";
    before = time;
  }
}

/// A straight line of 80 mm on which the tool swings from -15 to 15 degrees, half a degree past the axis of
/// C.
std::string past_the_axis() {
  constexpr int blocks = 160;
  const double side = std::tan(units::from_deg(0.5));
  std::string text;
  for (int i = 0; i <= blocks; ++i) {
    const double swing = std::tan(units::from_deg(15)) * (2.0 * i / blocks - 1);
    const double tilt = units::to_deg(std::atan(std::hypot(swing, side)));
    const double turn = units::to_deg(std::atan2(swing, side));
    text += i == 0 ? fmt::format("G0 X0 Y0 Z0 A{:.6f} C{:.6f}\nTRAORI\nG1 F3000\n", tilt, turn)
                   : fmt::format("X{:.3f} A{:.6f} C{:.6f}\n", 0.5 * i, tilt, turn);
  }
  return text;
}

TEST_P(RotaryAxes, TheWayToASingularPositionIsNotSlowedByTheLimitsThere) {
  Machine machine = five_axes();
  const ControlModel& model = find_model(GetParam());
  const ControlModel& optimal = find_model("optimal");
  const auto path = turning_path(past_the_axis());
  machine.settings.set("orientation_tolerance_deg", 1.0);  // else it holds the tip in the middle
  double before = HUGE_VAL;
  for (const double velocity : {25.0, 50.0, 100.0, 200.0}) {
    set_axis_value(machine, 'C', "velocity", velocity);
    const Trajectory trajectory = model.simulate(path, machine, complete_settings(model, machine));
    const double bound = optimal.simulate(path, machine, complete_settings(optimal, machine)).duration();
    EXPECT_LE(trajectory.duration(), before) << "a faster axis, " << velocity << " rev/min";
    if (velocity == 50) {  // up to there its velocity holds the tip, further on its jerk
      EXPECT_LT(trajectory.duration(), 0.99 * before);
    }
    EXPECT_LE(trajectory.duration(), 2 * bound) << velocity << "; the bound knows no jerk of rotary axes";
    before = trajectory.duration();
  }
  constexpr double hardly_a_limit = 1e4;  // [rev/s3]
  set_axis_value(machine, 'A', "jerk", hardly_a_limit);
  set_axis_value(machine, 'C', "jerk", hardly_a_limit);
  const double without_jerk = model.simulate(path, machine, complete_settings(model, machine)).duration();
  EXPECT_LE(without_jerk,
            1.75 * optimal.simulate(path, machine, complete_settings(optimal, machine)).duration());
}

std::string model_name(const testing::TestParamInfo<const char*>& info) {
  return info.param;
}

INSTANTIATE_TEST_SUITE_P(Models, RotaryAxes,
                         testing::Values("essid", "gassara", "tapie", "msaddek", "ward", "optimal"),
                         model_name);

/// C turns by 3 degrees a millimetre: its acceleration holds the ramps of the line, no jerk holds anything.
TEST(RotaryAxesOfTheBound, HoldItByVelocityAndAccelerationAlone) {
  const Machine machine = five_axes();
  const ControlModel& optimal = find_model("optimal");
  const RotaryAxis& c = *machine.kinematics.find('C');
  const double slope = units::from_deg(3);  // [rad/mm]
  const double length = 40;
  const auto path = turning_path("TRAORI\nG1 X40 C120 F60000\n");
  const Trajectory bound = optimal.simulate(path, machine, complete_settings(optimal, machine));
  const double speed = c.velocity / slope;
  const double acceleration = c.acceleration / slope;
  EXPECT_NEAR(bound.duration(), length / speed + speed / acceleration, 1e-6);
  const auto bent = turning_path("TRAORI\nG1 X40 C120 A5 F60000\nX60 Y10 C100 A20\nX70 C100 A3\nX90\n");
  const Trajectory without_jerk = optimal.simulate(bent, machine, complete_settings(optimal, machine));
  for (const Piece& piece : without_jerk.pieces()) {
    EXPECT_NE(piece.cause.kind, CauseKind::axis_jerk) << piece.time;
  }
  const ControlModel& essid = find_model("essid");
  EXPECT_LT(without_jerk.duration(),
            essid.simulate(bent, machine, complete_settings(essid, machine)).duration());
}

TEST(RotaryAxesOfCam, WaitToo) {
  const Machine machine = five_axes();
  const ControlModel& model = find_model("cam");
  const Trajectory trajectory = model.simulate(turning_path("G0 X10\nG0 A20\nG1 X50 F3000\n"), machine,
                                               complete_settings(model, machine));
  EXPECT_NEAR(time_by(trajectory, {CauseKind::indexing, 3}),
              turning_time(*machine.kinematics.find('A'), units::from_deg(20)), 1e-12);
}

/// 180 degrees at 60 degrees/s, and as fast as X where C is fast enough.
TEST(RotaryAxesOfLinuxCnc, TakeTheLongestTimeOfAnyAxis) {
  Machine machine = five_axes();
  const ControlModel& model = find_model("linuxcnc");
  const auto time_at = [&](double velocity, const std::string& end) {
    set_axis_value(machine, 'C', "velocity", velocity);
    const auto path = turning_path("G0 X0 Y0 Z0\n" + end);
    return model.simulate(path, machine, complete_settings(model, machine)).duration();
  };
  const double along_x = time_at(1000, "G0 X100\n");
  EXPECT_NEAR(time_at(10, "G0 X100 C180\n"), 3, 0.1);
  EXPECT_NEAR(time_at(10, "TRAORI\nG1 X100 C180 F20000\n"), 3, 0.1);
  EXPECT_NEAR(time_at(1000, "G0 X100 C1\n"), along_x, 0.002);
}

}  // namespace
}  // namespace feedscope

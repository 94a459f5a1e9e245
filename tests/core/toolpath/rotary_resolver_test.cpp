#include "core/toolpath/rotary_resolver.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "core/base/units.h"
#include "core/toolpath/machine_path.h"

namespace feedscope {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr double deg = units::pi / 180;

/// A trunnion: C on A in the table, the tool along Z. A from -100 to 50 degrees.
Machine trunnion() {
  Machine machine;
  machine.id = "trunnion";
  for (AxisLimits& axis : machine.axes) {
    axis = {500, 5000, 50000, 50000};
  }
  RotaryAxis a;
  a.name = 'A';
  a.velocity = 150 * deg;
  a.acceleration = 720 * deg;
  a.jerk = 7200 * deg;
  a.minimum = -100 * deg;
  a.maximum = 50 * deg;
  a.direction = Vec3::UnitX();
  a.point = Vec3(0, 0, -300);
  RotaryAxis c;
  c.name = 'C';
  c.velocity = 300 * deg;
  c.acceleration = 1440 * deg;
  c.jerk = 14400 * deg;
  c.point = Vec3(0, 0, -320);
  machine.kinematics.chain = "C A X Y frame Z";
  machine.kinematics.rotary = {a, c};
  return machine;
}

ReadProgram read_for(const std::string& text, Dialect dialect, const std::string& axes = "AC") {
  ReadOptions options;
  options.dialect = dialect;
  options.unit = LengthUnit::mm;
  options.rotary_axes = axes;
  return read_program(std::make_shared<const SourceText>("test.nc", text), nullptr, options);
}

MachinePath run_on(const Machine& machine, const std::string& text, Dialect dialect = Dialect::fanuc) {
  return on_machine(std::make_shared<const Toolpath>(build_toolpath(read_for(text, dialect))), machine,
                    Settings());
}

/// "A 45 C 90: 0.78 s by C" for every turn.
std::vector<std::string> turns_of(const Toolpath& path) {
  std::vector<std::string> turns;
  for (const RotaryTurn& turn : path.rotary_turns) {
    const auto at = [&](int axis) {
      return std::round(turn.to[static_cast<std::size_t>(axis)] / deg * 1e6) / 1e6 + 0.0;
    };
    turns.push_back(
        fmt::format("A {} C {} by {}", at(0), at(2), cause_axes[static_cast<std::size_t>(turn.axis)].name));
  }
  return turns;
}

double pause_time(const Toolpath& path) {
  double sum = 0;
  for (const ToolpathPause& pause : path.pauses) {
    sum += pause.kind == Pause::indexing ? pause.time : 0;
  }
  return sum;
}

double turn_time(char axis, double degrees, double feed = 0) {
  return turning_time(*trunnion().kinematics.find(axis), degrees * deg, feed);
}

TEST(RotaryMoves, LastAsLongAsTheSlowestAxisTurns) {
  const auto path = run_on(trunnion(), "G0 X10 Z50\nG0 A45 C20\nG0 X0\nA0 C180\n");
  EXPECT_THAT(turns_of(*path), ElementsAre("A 45 C 20 by A", "A 0 C 180 by C"));
  EXPECT_DOUBLE_EQ(pause_time(*path), turn_time('A', 45) + turn_time('C', 160));
  ASSERT_EQ(path->segments.size(), 4);
  EXPECT_EQ(path->segments[1].kind, SegmentKind::dwell);
  EXPECT_EQ(path->segments[1].line, 2);
  EXPECT_EQ(path->pause_of(path->segments[1]).axis, 3);
  EXPECT_EQ(path->segments[1].end, Vec3(10, 0, 50));
}

TEST(RotaryMoves, AtAFeedTakeItInDegreesAMinuteOfAllAxesTogether) {
  // 30 and 40 degrees are 50; at 600 degrees a minute A takes 0.6, C 0.8 of all limits.
  const auto path = run_on(trunnion(), "G1 X10 F500\nG1 A30 C40 F600\n");
  const double jerk = std::min(7200 / 0.6, 14400 / 0.8) * deg;
  const double acceleration = std::min(720 / 0.6, 1440 / 0.8) * deg;
  EXPECT_NEAR(pause_time(*path), rest_to_rest_time(50 * deg, 10 * deg, acceleration, jerk), 1e-12);
  EXPECT_NEAR(pause_time(*path), 5, 0.1);
}

TEST(RotaryMoves, UnderInverseTimeTakeTheTimeOfTheBlock) {
  const auto path = run_on(trunnion(), "G1 X10 F500\nG93 G1 A30 F10\n");
  EXPECT_NEAR(pause_time(*path), 6, 0.1);
  EXPECT_GT(pause_time(*path), 6);
}

TEST(RotaryMoves, BesideARapidTurnAlongIt) {
  const auto path = run_on(trunnion(), "G0 X10 Z50\nG0 X110 A45\n");
  EXPECT_EQ(pause_time(*path), 0);
  ASSERT_EQ(path->segment_turns.size(), 1U);
  const SegmentTurn& turn = path->segment_turns.front();
  EXPECT_EQ(turn.segment, 1U);
  EXPECT_NEAR(turn.limit.speed, 150 / 0.45, 1e-3 * 150 / 0.45) << "0.45 degrees a millimetre";
  EXPECT_NEAR(turn.ramp.acceleration, 720 / 0.45, 1e-9);
  EXPECT_NEAR(turn.ramp.jerk, 7200 / 0.45, 1e-9);
}

TEST(RotaryMoves, AtAFeedKeepItWhereTheWordsOfXYAndZMoveNothing) {
  for (const char* block : {"G1 A30 F600\n", "G1 X10 A30 F600\n", "G1 X10 Y0 A30 F600\n"}) {
    const auto path = run_on(trunnion(), std::string("G1 X10 Y0 F500\n") + block);
    EXPECT_NEAR(pause_time(*path), turn_time('A', 30, 10 * deg), 1e-9) << block;
  }
}

TEST(RotaryMoves, OfATiltedPlaneTakeTheAnglesOfTheChain) {
  // The plane turned by 30 degrees about X has its normal at 30 degrees from Z towards -Y: A 30.
  const char* expected = "A 30 C 0 by A";
  EXPECT_THAT(turns_of(*run_on(trunnion(), "G0 X1\nG68.2 X0 Y0 Z0 I0 J30 K0\nG53.1\nG0 X5\n")),
              ElementsAre(expected));
  EXPECT_THAT(turns_of(*run_on(trunnion(), "G0 X1\nCYCLE800(1,\"T\",0,57,0,0,0,30,0,0,0,0,0,1)\nG0 X5\n",
                               Dialect::sinumerik)),
              ElementsAre(expected));
  EXPECT_THAT(
      turns_of(*run_on(trunnion(),
                       "BEGIN PGM A MM\nL X+1 FMAX\nPLANE SPATIAL SPA+30 SPB+0 SPC+0 TURN FMAX\nL X+5 "
                       "FMAX\nPLANE RESET TURN FMAX\nEND PGM A MM\n",
                       Dialect::heidenhain)),
      ElementsAre(expected, "A 0 C 0 by A"));
}

TEST(RotaryMoves, GoToTheSideThatIsAskedFor) {
  const auto side = [](int direction) {
    return turns_of(*run_on(
        trunnion(), fmt::format("G0 X1\nCYCLE800(1,\"T\",0,57,0,0,0,30,0,0,0,0,0,{})\nG0 X5\n", direction),
        Dialect::sinumerik));
  };
  EXPECT_THAT(side(1), ElementsAre("A 30 C 0 by A"));
  EXPECT_THAT(side(-1), ElementsAre(testing::AnyOf("A -30 C 180 by C", "A -30 C -180 by C")));
  EXPECT_THAT(side(0), ElementsAre());
}

TEST(RotaryMoves, GoToTheAnglesThatTheControlHasCalculated) {
  const auto path =
      run_on(trunnion(),
             "BEGIN PGM A MM\nL X+1 FMAX\nPLANE SPATIAL SPA+30 SPB+0 SPC+0 STAY\nL A+Q120 C+Q122 "
             "FMAX\nL X+5 FMAX\nEND PGM A MM\n",
             Dialect::heidenhain);
  EXPECT_THAT(turns_of(*path), ElementsAre("A 30 C 0 by A"));
  EXPECT_EQ(path->segments[1].kind, SegmentKind::dwell) << "behind the line before, which is held back";
}

TEST(RotaryMoves, FollowIncrementsAndTheShortestWay) {
  EXPECT_THAT(
      turns_of(*run_on(trunnion(), "G0 X1\nC350\nC=DC(10)\nC=IC(90)\nG91 A10\nA10\n", Dialect::sinumerik)),
      ElementsAre("A 0 C 350 by C", "A 0 C 370 by C", "A 0 C 460 by C", "A 10 C 460 by A",
                  "A 20 C 460 by A"));
  EXPECT_THAT(turns_of(*run_on(trunnion(), "G0 X1\nG91 A10\nA10\nG90 A5\n")),
              ElementsAre("A 10 C 0 by A", "A 20 C 0 by A", "A 5 C 0 by A"));
}

TEST(RotaryMoves, BeyondTravelAndOutOfReachAreSaidWithTheirLine) {
  const auto beyond = run_on(trunnion(), "G0 X1\nA70\n");
  ASSERT_EQ(beyond.faults.size(), 1);
  EXPECT_EQ(beyond.faults[0].line, 2);
  EXPECT_EQ(beyond.faults[0].code, "rotary-travel");
  EXPECT_THAT(beyond.faults[0].message.english(),
              HasSubstr("axis A goes to 70 degrees, beyond its travel from -100 to 50"));
  const auto out = run_on(trunnion(), "G0 X1\nG68.2 X0 Y0 Z0 I0 J120 K0\nG53.1\n");
  ASSERT_EQ(out.faults.size(), 1);
  EXPECT_EQ(out.faults[0].code, "rotary-direction");
  EXPECT_EQ(pause_time(*out), 0);
}

TEST(RotaryMoves, AreNothingOnAMachineWithoutRotaryAxes) {
  Machine plain = trunnion();
  plain.kinematics = {};
  const auto path =
      std::make_shared<const Toolpath>(build_toolpath(read_for("G0 X1\nA45\nG0 X5\n", Dialect::fanuc, "")));
  EXPECT_EQ(on_machine(path, plain, Settings()).toolpath, path);
  EXPECT_THAT(not_counted(*path).other_axes, ElementsAre("A"));
}

TEST(RotaryMoves, LeaveAxesUncountedThatTheMachineLacks) {
  EXPECT_THAT(not_counted(*run_on(trunnion(), "G0 X1\nA45\nC5\nG0 X5\n")).other_axes, ElementsAre());
  EXPECT_THAT(not_counted(*run_on(trunnion(), "G0 X1\nB45\nC5\nG0 X5\n")).other_axes, ElementsAre("B"));
  EXPECT_THAT(not_counted(*run_on(trunnion(), "G0 X1\nA45\nG1 X5 A50 F100\n")).other_axes, ElementsAre());
}

TEST(RotaryMoves, AreReportedAsBeforeUnlessTheMachineHasTheAxis) {
  const auto messages = [](const std::string& axes) {
    std::vector<std::string> texts;
    for (const Diagnostic& d :
         read_for("G0 X1\nA45\nC5\nG1 X5 A50 F100\n", Dialect::fanuc, axes).diagnostics) {
      texts.push_back(fmt::format("{} {} {}", d.line, to_string(d.severity), d.code));
    }
    return texts;
  };
  EXPECT_THAT(messages(""),
              ElementsAre("2 warning unread-axis", "3 warning unread-axis", "4 error unread-axis"));
  EXPECT_THAT(messages("AC"), ElementsAre("4 warning rotary-feed"));
}

TEST(RotaryMoves, SayWhereAControlMayTakeAShorterWay) {
  const ReadProgram program = read_for("G0 X1\nC350\n", Dialect::fanuc);
  ASSERT_EQ(program.diagnostics.size(), 1);
  EXPECT_EQ(program.diagnostics[0].code, "rotary-way");
  EXPECT_EQ(program.diagnostics[0].message.english(), "axis C turns by 350 degrees, from 0 to 350");
}

TEST(RotaryMoves, ReachTheDirectionsOfRandomPlanes) {
  std::mt19937 random(22);
  std::uniform_real_distribution<double> share(-1, 1);
  ReadProgram program = read_for("G0 X1\n", Dialect::fanuc);
  const Machine machine = trunnion();
  const KinematicChain chain = chain_of(machine.kinematics);
  std::vector<Vec3> asked;
  for (int i = 0; i < 300; ++i) {
    RotaryMove move;
    move.motion = 1;
    move.line = static_cast<std::uint32_t>(i);
    move.direction = Vec3(share(random), share(random), 0.1 + std::abs(share(random))).normalized();
    asked.push_back(*move.direction);
    program.rotary_moves.push_back(move);
  }
  const auto path =
      on_machine(std::make_shared<const Toolpath>(build_toolpath(program)), machine, Settings());
  ASSERT_EQ(path->rotary_turns.size(), asked.size());
  EXPECT_TRUE(path.faults.empty());
  for (std::size_t i = 0; i < asked.size(); ++i) {
    const RotaryTurn& turn = path->rotary_turns[i];
    const std::vector<double> places{turn.to[2], turn.to[0], 0, 0, 0};
    EXPECT_LT((chain.pose(places, 0).direction - asked[i]).norm(), 1e-9);
    EXPECT_EQ(turn.from, i == 0 ? (std::array<double, 3>{}) : path->rotary_turns[i - 1].to);
    EXPECT_DOUBLE_EQ(turn.time,
                     std::max(turning_time(*machine.kinematics.find('A'), turn.to[0] - turn.from[0]),
                              turning_time(*machine.kinematics.find('C'), turn.to[2] - turn.from[2])));
  }
}

TEST(SegmentTurns, HoldTheRotaryAxisWithoutToolCentrePointControl) {
  // A turns by 4.5, C by 6 degrees a millimetre: A allows 150/4.5, C 300/6 mm/s.
  const auto path = run_on(trunnion(), "G0 Z1\nG1 X10 A45 C-60 F1000\nX20\n");
  ASSERT_EQ(path->segment_turns.size(), 1);
  const SegmentTurn& turn = path->segment_turns[0];
  EXPECT_EQ(turn.segment, 1);
  EXPECT_NEAR(turn.limit.speed, 150 / 4.5, 1e-9);
  EXPECT_EQ(turn.limit.axis, 3);
  EXPECT_EQ(turn.limit.by, TurnLimit::By::velocity);
  EXPECT_NEAR(turn.ramp.acceleration, 720 / 4.5, 1e-9);
  EXPECT_NEAR(turn.ramp.jerk, 7200 / 4.5, 1e-9);
  EXPECT_NEAR(path->segments[1].feed, 1000.0 / 60 * 10 / std::hypot(10, 45, 60), 1e-9)
      << "F holds along sqrt(mm2 + deg2)";
  EXPECT_NEAR(path->segments[2].feed, 1000.0 / 60, 1e-9);
  EXPECT_EQ(path->segment_turn(2), nullptr);
}

/// The trunnion with the tool and the part in their places: the part zero is on the axis of C.
MachinePath at_tip(const std::string& text, Dialect dialect = Dialect::sinumerik) {
  Machine machine = trunnion();
  machine.kinematics.tool_length = 150;
  Settings settings;
  settings.set("part_zero_x_mm", 0.0);
  settings.set("part_zero_y_mm", 0.0);
  settings.set("part_zero_z_mm", -320.0);
  return on_machine(std::make_shared<const Toolpath>(build_toolpath(read_for(text, dialect))), machine,
                    settings);
}

TEST(SegmentTurns, LetTheTableCarryTheTipRoundACircle) {
  // Tip and table turn alike, so that X, Y and Z stand still: only C limits, v = V R.
  const auto path = at_tip("TRAORI\nG0 X20 Y0 Z5\nG3 X-20 Y0 I-20 J0 C180 F100000\n");
  ASSERT_EQ(path->segment_turns.size(), 1);
  const SegmentTurn& turn = path->segment_turns[0];
  EXPECT_NEAR(turn.limit.speed, 300 * deg * 20, 1e-6);
  EXPECT_EQ(turn.limit.axis, 5);
  EXPECT_EQ(turn.limit.by, TurnLimit::By::velocity);
  EXPECT_NEAR(turn.ramp.acceleration, 1440 * deg * 20, 1e-6);
  EXPECT_EQ(turn.ramp.acceleration_axis, 5);
}

TEST(SegmentTurns, CountTheLinearAxesThatMakeUpForATurn) {
  // C turns back under a tip that stays near: at 100 mm from its axis X and Y run with the part.
  const auto path = at_tip("TRAORI\nG0 X100 Y0 Z5\nG1 X100.001 C90 F100000\n");
  ASSERT_EQ(path->segment_turns.size(), 1);
  const SegmentTurn& turn = path->segment_turns[0];
  const double radians_a_mm = 90 * deg / 0.001;
  // The velocity of X or Y, v r q', at most 500 mm/s, is the least: C alone allows 300 degrees/s.
  EXPECT_NEAR(turn.limit.speed, 500.0 / 100 / radians_a_mm, 1e-3 * turn.limit.speed);
  EXPECT_EQ(turn.limit.by, TurnLimit::By::velocity);
  EXPECT_LT(turn.limit.axis, 3);
}

TEST(SegmentTurns, KeepEveryAxisWithinItsLimitsByFiniteDifferences) {
  Machine machine = trunnion();
  const KinematicChain chain = chain_of(machine.kinematics);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> share(-1, 1);
  for (int i = 0; i < 50; ++i) {
    const std::array<double, 4> to{50 * share(random), 50 * share(random), 30 * share(random),
                                   90 * share(random)};
    const auto path = at_tip(fmt::format("TRAORI\nG0 X0 Y0 Z0\nG1 X{:.3f} Y{:.3f} A{:.3f} C{:.3f} F1000000\n",
                                         to[0], to[1], to[2], to[3]));
    ASSERT_EQ(path->segment_turns.size(), 1);
    const SegmentTurn& turn = path->segment_turns[0];
    const Vec3 end = path->segments.back().end;
    const double length = path->segments.back().length;
    const auto places = [&](double s) {
      const std::vector<double> angles{s / length * turn.to[2], s / length * turn.to[0]};
      return chain.places(s / length * end + Vec3(0, 0, -320), angles, 150);
    };
    const double h = 1e-3 * length;
    for (double s = h; s < length - h; s += length / 50) {
      const std::vector<double> before = places(s - h);
      const std::vector<double> here = places(s);
      const std::vector<double> after = places(s + h);
      for (const std::size_t k : chain.linear()) {
        const double first = std::abs(after[k] - before[k]) / (2 * h);
        const double second = std::abs(after[k] - 2 * here[k] + before[k]) / (h * h);
        EXPECT_LE(turn.limit.speed * first, 500 * 1.03);
        EXPECT_LE(turn.limit.speed * turn.limit.speed * second, 0.75 * 5000 * 1.06);
      }
      EXPECT_LE(turn.limit.speed * std::abs(turn.to[2]) / length, 300 * deg * (1 + 1e-9));
    }
  }
}

TEST(SegmentTurns, SayWhatIsMissingToFollowTheTip) {
  const auto path = run_on(trunnion(), "TRAORI\nG0 X100 Y0 Z5\nG1 X110 C90 F1000\n", Dialect::sinumerik);
  ASSERT_EQ(path.faults.size(), 1);
  EXPECT_EQ(path.faults[0].severity, Severity::warning);
  EXPECT_EQ(not_counted(*path).tip_followings, 1U);
  EXPECT_THAT(path.faults[0].message.english(), HasSubstr("not known without tool length and part zero"));
  EXPECT_NEAR(path->segment_turns.at(0).limit.speed, 300 / 9.0, 1e-9);
}

TEST(SegmentTurns, KnowTheTipInEveryDialect) {
  const auto tip = [](const std::string& text, Dialect dialect) {
    const ReadProgram program = read_for(text, dialect);
    return !program.rotary_moves.empty() && program.rotary_moves.back().at_tip;
  };
  EXPECT_TRUE(tip("G0 X1\nG43.4 H1\nG1 X5 A10 F100\n", Dialect::fanuc));
  EXPECT_FALSE(tip("G0 X1\nG43.4 H1\nG49\nG1 X5 A10 F100\n", Dialect::fanuc));
  EXPECT_TRUE(tip("G0 X1\nM428\nG43\nG1 X5 A10 F100\n", Dialect::linuxcnc));
  EXPECT_FALSE(tip("G0 X1\nM428\nM429\nG1 X5 A10 F100\n", Dialect::linuxcnc));
  EXPECT_TRUE(tip("TRAORI\nG1 X5 A=10 F100\n", Dialect::sinumerik));
  EXPECT_FALSE(tip("TRAORI\nTRAFOOF\nG1 X5 A=10 F100\n", Dialect::sinumerik));
  EXPECT_TRUE(tip("BEGIN PGM A MM\nL X+1 FMAX M128\nL X+5 A+10 F100\nEND PGM A MM\n", Dialect::heidenhain));
  EXPECT_FALSE(
      tip("BEGIN PGM A MM\nL X+1 FMAX M128\nL M129\nL X+5 A+10 F100\nEND PGM A MM\n", Dialect::heidenhain));
}

TEST(SegmentTurns, NameTheSlowestPlaceNearTheSingularPosition) {
  // At 5 degrees from the axis of C, which turns by 9 degrees a millimetre: 300/9 mm/s.
  const auto path = at_tip("TRAORI\nG0 X0 Y0 Z5 A5\nG1 X10 C90 F5000\nX20 C120\nX30 C121\n");
  ASSERT_EQ(path.faults.size(), 1);
  EXPECT_EQ(path.faults[0].severity, Severity::info);
  EXPECT_EQ(path.faults[0].line, 3);
  EXPECT_EQ(path.faults[0].message.english(),
            "axis C holds the feed at 2000 of 5000 mm/min near its singular position: the tool is 5 degrees "
            "from its axis");
  EXPECT_TRUE(at_tip("TRAORI\nG0 X0 Y0 Z5 A40\nG1 X10 C90 F5000\n").faults.empty());
}

/// Directions within 45 degrees of the spindle, none next to it.
std::vector<Vec3> random_directions(unsigned seed, int count) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> turn(-units::pi, units::pi);
  std::uniform_real_distribution<double> tilt(0.2, units::pi / 4);
  std::vector<Vec3> directions;
  for (int i = 0; i < count; ++i) {
    const double a = turn(random);
    const double b = tilt(random);
    directions.emplace_back(std::sin(b) * std::cos(a), std::sin(b) * std::sin(a), std::cos(b));
  }
  return directions;
}

/// A line for each direction, as `line` writes it with the number of the line.
template <typename Line>
std::string lines_of(const std::vector<Vec3>& directions, const Line& line) {
  std::string text;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    text += line(10 * (i + 1), directions[i]);
  }
  return text;
}

std::string traori(const std::vector<Vec3>& directions) {
  return "G90 F1000\nTRAORI\n" + lines_of(directions, [](std::size_t x, const Vec3& d) {
           return fmt::format("G1 X{} A3={:.15f} B3={:.15f} C3={:.15f}\n", x, 3 * d.x(), 3 * d.y(),
                              3 * d.z());
         });
}

TEST(ToolVectors, TurnTheAxesToTheirDirection) {
  const Machine machine = trunnion();
  const KinematicChain chain = chain_of(machine.kinematics);
  for (const unsigned seed : {1U, 2U, 3U}) {
    const std::vector<Vec3> directions = random_directions(seed, 100);
    const auto path = run_on(machine, traori(directions), Dialect::sinumerik);
    ASSERT_EQ(path->segment_turns.size(), directions.size()) << seed;
    for (std::size_t i = 0; i < directions.size(); ++i) {
      const SegmentTurn& turn = path->segment_turns[i];
      std::vector<double> places(chain.size(), 0);
      places[chain.rotary()[0]] = turn.to[2];
      places[chain.rotary()[1]] = turn.to[0];
      EXPECT_LT((chain.pose(places, 0).direction - directions[i]).norm(), 1e-9) << seed << ' ' << i;
      const std::vector<double> from{turn.from[2], turn.from[0]};
      const double way = std::hypot(turn.to[2] - turn.from[2], turn.to[0] - turn.from[0]);
      for (const RotaryPlaces& other : chain.turn_to(directions[i], from)) {
        EXPECT_LE(way, std::hypot(other.angles[0] - from[0], other.angles[1] - from[1]) + 1e-9);
      }
    }
  }
}

TEST(ToolVectors, AreTheSameInAllDialects) {
  const std::vector<Vec3> directions = random_directions(4, 30);
  const auto sinumerik = run_on(trunnion(), traori(directions), Dialect::sinumerik);
  const auto fanuc = run_on(
      trunnion(), "G21 G90 G94 F1000\nG43.5 H1\n" + lines_of(directions, [](std::size_t x, const Vec3& d) {
                    return fmt::format("G1 X{} I{:.15f} J{:.15f} K{:.15f}\n", x, d.x(), d.y(), d.z());
                  }));
  const auto heidenhain = run_on(
      trunnion(),
      "BEGIN PGM A MM\nTOOL CALL 1 Z S100 F1000\nL M128\n" +
          lines_of(directions,
                   [](std::size_t x, const Vec3& d) {
                     return fmt::format("LN X+{} Y+0 Z+0 NX+0 NY+0 NZ+1 TX{:+.15f} TY{:+.15f} TZ{:+.15f}\n",
                                        x, d.x(), d.y(), d.z());
                   }),
      Dialect::heidenhain);
  for (const auto& other : {fanuc, heidenhain}) {
    ASSERT_EQ(other->segment_turns.size(), sinumerik->segment_turns.size());
    for (std::size_t i = 0; i < directions.size(); ++i) {
      for (const std::size_t axis : {std::size_t{0}, std::size_t{2}}) {
        EXPECT_NEAR(other->segment_turns[i].to[axis], sinumerik->segment_turns[i].to[axis], 1e-9) << i;
      }
      EXPECT_NEAR(other->segment_turns[i].limit.speed, sinumerik->segment_turns[i].limit.speed, 1e-6) << i;
    }
  }
}

TEST(ToolVectors, OfFunctionTcpmAreFollowedUntilItIsReset) {
  const auto path =
      run_on(trunnion(),
             "BEGIN PGM A MM\nTOOL CALL 1 Z S100 F1000\nFUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS\n"
             "LN X+10 Y+0 Z+0 TX+0 TY-0.5 TZ+1\nFUNCTION RESET TCPM\nLN X+20 Y+0 Z+0 TX+0 TY+0 TZ+1\n",
             Dialect::heidenhain);
  ASSERT_EQ(path->segment_turns.size(), 1U);
  EXPECT_NEAR(path->segment_turns.front().to[0], std::atan(0.5), 1e-9);
}

TEST(ToolVectors, ThatCannotBeFollowedAreReported) {
  const auto codes = [](const std::string& text, Dialect dialect) {
    std::vector<std::string> found;
    for (const Diagnostic& diagnostic : read_for(text, dialect).diagnostics) {
      if (diagnostic.code == "rotary-direction") {
        found.push_back(diagnostic.message.english());
      }
    }
    return found;
  };
  EXPECT_THAT(codes("TRAORI\nG1 X1 F100 A3=0 B3=0 C3=0", Dialect::sinumerik),
              ElementsAre("A3, B3 and C3 are all zero: the tool has no direction"));
  EXPECT_THAT(codes("G43.5 H1\nG1 X1 F100 I0 J0 K0", Dialect::fanuc),
              ElementsAre("I, J and K are all zero: the tool has no direction"));
  EXPECT_THAT(codes("TOOL CALL 1 Z S1 F9\nLN X+1 TX+0 TY+0 TZ+1\n", Dialect::heidenhain),
              ElementsAre("a tool direction (TX TY TZ) without M128 or FUNCTION TCPM"));
  const auto below = run_on(trunnion(), "TRAORI\nG1 X10 F100 A3=0 B3=1 C3=-1\n", Dialect::sinumerik);
  ASSERT_EQ(below.faults.size(), 1U);
  EXPECT_THAT(below.faults.front().message.english(), HasSubstr("of the tool vector"));
  // From one side of the singular position to the other: C turns by 180 degrees or A changes its side.
  const auto across =
      run_on(trunnion(), "TRAORI\nG1 X10 F1000 B3=-0.9 C3=1\nX20 A3=0.9 B3=0 C3=1\n", Dialect::sinumerik);
  EXPECT_THAT(across.faults,
              testing::Contains(testing::Field(
                  &Diagnostic::message,
                  testing::Property(&Message::english, HasSubstr("turns by 90 degrees within one block")))));
}

TEST(SegmentTurns, AreGivenUpWhenCancelled) {
  const auto path = std::make_shared<const Toolpath>(
      build_toolpath(read_for("G43.4 H1\nG1 X10 A10 C20 F1000\nX20 A20 C40\n", Dialect::fanuc)));
  Progress progress;
  EXPECT_NO_THROW(on_machine(path, trunnion(), Settings(), &progress));
  progress.cancel();
  EXPECT_THROW(on_machine(path, trunnion(), Settings(), &progress), Cancelled);
}

}  // namespace
}  // namespace feedscope

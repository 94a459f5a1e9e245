#include "core/toolpath/rotary_positions.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <string>

#include "core/base/units.h"
#include "core/toolpath/machine_path.h"
#include "tests/core/toolpath/table_machine.h"

namespace feedscope {
namespace {

constexpr double deg = units::pi / 180;

/// With travel of A and a tool.
Machine limited_table() {
  Machine machine = table_machine();
  machine.kinematics.rotary.front().minimum = -100 * deg;
  machine.kinematics.rotary.front().maximum = 60 * deg;
  machine.kinematics.tool_length = 120;
  return machine;
}

ReadProgram program_of(const std::string& text, Dialect dialect = Dialect::sinumerik) {
  ReadOptions options;
  options.dialect = dialect;
  options.unit = LengthUnit::mm;
  options.rotary_axes = "AC";
  return read_program(std::make_shared<const SourceText>("test.mpf", text), nullptr, options);
}

MachinePath path_on_table(const std::string& text, const std::vector<double>& angles) {
  Settings settings;
  settings.set("part_zero_x_mm", 0.0);
  settings.set("part_zero_y_mm", 0.0);
  settings.set("part_zero_z_mm", -300.0);
  for (std::size_t i = 0; i < angles.size(); ++i) {
    settings.set(fmt::format("part_angle_{}_deg", "xyz"[i]), angles[i]);
  }
  return on_machine(std::make_shared<const Toolpath>(build_toolpath(program_of(text))), limited_table(),
                    settings);
}

/// A line on which the tool swings from -20 to 20 degrees in the plane of X, 2 degrees beside the axis of C;
/// `turn`: what the whole program is turned by.
std::string swing(const Eigen::Matrix3d& turn) {
  std::string text = "TRAORI\n";
  for (int i = 0; i <= 40; ++i) {
    const Vec3 tool = turn * Vec3(std::tan((i - 20) * deg), std::tan(2 * deg), 1).normalized();
    const Vec3 tip = turn * Vec3(i - 20.0, 3, 5);
    text += fmt::format("{} X{:.9f} Y{:.9f} Z{:.9f} A3={:.12f} B3={:.12f} C3={:.12f}\n",
                        i == 0 ? "G0" : "G1 F5000", tip.x(), tip.y(), tip.z(), tool.x(), tool.y(), tool.z());
  }
  return text;
}

TEST(TurnedParts, RunAsTheProgramThatIsTurnedInstead) {
  const std::vector<double> angles{8, -5, 30};
  Settings settings;
  settings.set("part_angle_x_deg", 8.0);
  settings.set("part_angle_y_deg", -5.0);
  settings.set("part_angle_z_deg", 30.0);
  const auto turned = path_on_table(swing(Eigen::Matrix3d::Identity()), angles);
  const Eigen::Matrix3d turn = part_on_machine(table_machine(), settings).turn;
  const auto other = path_on_table(swing(turn), {});
  EXPECT_LT((turn * Vec3::UnitX() - Eigen::AngleAxisd(30 * deg, Vec3::UnitZ()) *
                                        (Eigen::AngleAxisd(-5 * deg, Vec3::UnitY()) * Vec3::UnitX()))
                .norm(),
            1e-12)
      << "about X, then Y, then Z";
  ASSERT_EQ(turned->segment_turns.size(), other->segment_turns.size());
  ASSERT_GT(turned->segment_turns.size(), 30);
  for (std::size_t i = 0; i < turned->segment_turns.size(); ++i) {
    const SegmentTurn& one = turned->segment_turns[i];
    const SegmentTurn& two = other->segment_turns[i];
    if (turned->segments[one.segment].rapid) {
      continue;  // it begins as the machine stands
    }
    EXPECT_NEAR(one.to[0], two.to[0], 1e-8);
    EXPECT_NEAR(std::remainder(one.to[2] - two.to[2], 2 * units::pi), 0, 1e-7);
    EXPECT_NEAR(one.limit.speed, two.limit.speed, 1e-5 * two.limit.speed);
  }
  EXPECT_EQ(turned.faults.size(), other.faults.size());
}

TEST(TurnedParts, LeaveTheToolItsDirectionUnderTheWordsOfAxesToo) {
  const std::string words = "TRAORI\nG0 X0 Y0 Z0 A20 C30\nG1 F5000 X10 A25 C60\nX20 C90\n";
  const auto plain = path_on_table(words, {});
  const auto turned = path_on_table(words, {15, 0, 0});
  const KinematicChain chain = chain_of(limited_table().kinematics);
  const auto tool = [&](const std::array<double, 3>& angles) {
    return chain.pose(std::vector<double>{angles[2], angles[0], 0, 0, 0}, 0).direction;
  };
  ASSERT_EQ(plain->segment_turns.size(), 2U);
  ASSERT_EQ(turned->segment_turns.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    const Vec3 asked = turned->part.turn * tool(plain->segment_turns[i].to);
    EXPECT_LT((tool(turned->segment_turns[i].to) - asked).norm(), 1e-9);
  }
}

TEST(TurnedParts, StayWhereTheProgramOnlySendsAxesToAngles) {
  const auto path = path_on_table("G0 X0 Y0 Z0 A20\nG1 F5000 X10\n", {15, 0, 0});
  EXPECT_TRUE(path->part.turn.isIdentity());
  ASSERT_EQ(path->rotary_turns.size(), 1U);
  EXPECT_NEAR(path->rotary_turns[0].to[0], 20 * deg, 1e-12);
  ASSERT_EQ(path.faults.size(), 1U);
  EXPECT_EQ(path.faults[0].code, "rotary-position");
  EXPECT_THAT(path.faults[0].message.english(), testing::HasSubstr("the part stays as programmed"));
}

TEST(TurnedParts, MayBringTheToolOutOfReach) {
  const auto path = path_on_table(
      "TRAORI\nG0 X0 Y0 Z0 A3=0 B3=-0.9 C3=0.436\nG1 F5000 X10 A3=0 B3=-0.91 C3=0.4146\n", {100, 0, 0});
  ASSERT_FALSE(path.faults.empty());
  EXPECT_THAT(path.faults[0].message.english(), testing::HasSubstr("in the part as it is turned"));
}

TEST(EndlessAxes, GoTheWayThatIsAskedFor) {
  const auto turns = [](const std::string& text, Dialect dialect) {
    const auto path = on_machine(std::make_shared<const Toolpath>(build_toolpath(program_of(text, dialect))),
                                 limited_table(), Settings());
    std::vector<double> to;
    for (const RotaryTurn& turn : path->rotary_turns) {
      to.push_back(std::round(units::to_deg(turn.to[2]) * 1e6) / 1e6);
    }
    return to;
  };
  EXPECT_THAT(turns("G0 X1\nC350\nC=ACP(10)\nC=ACN(350)\nC=ACN(300)\n", Dialect::sinumerik),
              testing::ElementsAre(350, 370, 350, 300));
  EXPECT_THAT(turns("BEGIN PGM A MM\nL X+1 FMAX M126\nL C+350 FMAX\nL C+20 FMAX\nL C+350 FMAX M127\n"
                    "END PGM A MM\n",
                    Dialect::heidenhain),
              testing::ElementsAre(-10, 20, 350));
}

TEST(NearestPositions, CountTheWaysOfBothAxes) {
  // The tool leans by 30 degrees, then by as much to the side: C alone turns by 90 degrees, or A besides.
  const auto path = path_on_table(
      "TRAORI\nG0 X0 Y0 Z0 A3=0 B3=-0.5 C3=0.8660254037844386\nG1 F1000 X10 A3=0.5 B3=0 "
      "C3=0.8660254037844386\n",
      {});
  ASSERT_EQ(path->segment_turns.size(), 1U);
  EXPECT_NEAR(path->segment_turns[0].from[0], 30 * deg, 1e-9);
  EXPECT_NEAR(path->segment_turns[0].to[0], 30 * deg, 1e-9);
  EXPECT_NEAR(std::abs(path->segment_turns[0].to[2]), 90 * deg, 1e-9);
}

TEST(GreatCircles, AreFollowedWhereTheProgramAsksForThem) {
  const auto turn_with = [](const std::string& word) {
    const auto path = path_on_table(
        fmt::format("TRAORI {}\nG0 X0 Y0 Z0 A3=0.3 B3=0.1 C3=1\nG1 F5000 X20 A3=-0.3 B3=0.1 C3=1\n", word),
        {});
    return path->segment_turns.at(0);
  };
  const SegmentTurn even = turn_with("ORIAXES");
  const SegmentTurn circle = turn_with("ORIVECT");
  EXPECT_FALSE(even.great_circle);
  EXPECT_TRUE(circle.great_circle);
  EXPECT_NEAR(std::abs(circle.to[2] - circle.from[2]), 2 * std::atan(3), 1e-9) << "past the pole";
  EXPECT_NEAR(std::abs(even.to[2] - even.from[2]), units::pi - 2 * std::atan(3), 1e-9) << "the nearer one";
  // Past the pole by atan(0.1) C turns faster than on average, by which the tip is slower.
  EXPECT_LT(circle.limit.speed, 0.8 * even.limit.speed);
  EXPECT_NEAR(circle.tilt, std::atan(0.1), 1e-6);
}

TEST(GreatCircles, EndAtThePositionThatTheyLeadTo) {
  const auto turn_with = [](const std::string& word, const std::string& words) {
    const auto path =
        path_on_table(fmt::format("TRAORI {}\nG0 X0 Y0 Z0 A3=0 B3={:.12f} C3=1\nG1 F5000 X20 {}\n", word,
                                  -std::tan(2 * deg), words),
                      {});
    return path->segment_turns.at(0);
  };
  const std::string past_the_pole =
      fmt::format("A3={:.12f} B3={:.12f} C3=1", std::tan(2 * deg) * std::sin(100 * deg),
                  -std::tan(2 * deg) * std::cos(100 * deg));
  const SegmentTurn circle = turn_with("ORIVECT", past_the_pole);
  EXPECT_TRUE(circle.great_circle);
  EXPECT_NEAR(std::abs(circle.to[2] - circle.from[2]), 100 * deg, 1e-6);
  EXPECT_NEAR(circle.to[0], circle.from[0], 1e-6);
  const SegmentTurn even = turn_with("ORIAXES", past_the_pole);
  EXPECT_NEAR(std::abs(even.to[2] - even.from[2]), 80 * deg, 1e-6) << "the nearer one";
  EXPECT_NEAR(even.to[0], -even.from[0], 1e-6);

  const SegmentTurn asked = turn_with("ORIVECT", fmt::format("A={:.9f} C=80", -even.from[0] / deg));
  EXPECT_FALSE(asked.great_circle) << "no great circle leads to these angles: the axes go linearly";
  EXPECT_NEAR(asked.to[2], 80 * deg, 1e-9);
}

TEST(GreatCircleWords, AreThoseOfTheDialects) {
  const auto circles = [](const std::string& text, Dialect dialect) {
    std::vector<bool> found;
    for (const RotaryMove& move : program_of(text, dialect).rotary_moves) {
      found.push_back(move.great_circle);
    }
    return found;
  };
  EXPECT_THAT(circles("TRAORI\nORIVECT\nG1 X1 F100 A3=0.1 C3=1\nX2 A10 C20\nORIAXES X3 A3=0.2 C3=1\n"
                      "ORIPLANE X4 A3=0.3 C3=1\nG0 X5 A3=0 C3=1\n",
                      Dialect::sinumerik),
              testing::ElementsAre(true, true, false, true, false));
  EXPECT_THAT(circles("BEGIN PGM A MM\nTOOL CALL 1 Z S100 F1000\n"
                      "FUNCTION TCPM F TCP AXIS POS PATHCTRL VECTOR\nLN X+10 TX+0 TY-0.5 TZ+1\nL X+20 A+3\n"
                      "FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS\nLN X+30 TX+0 TY-0.2 TZ+1\n"
                      "FUNCTION TCPM F TCP AXIS POS PATHCTRL VECTOR\nL M128\nLN X+40 TX+0 TY-0.3 TZ+1\n",
                      Dialect::heidenhain),
              testing::ElementsAre(true, true, false, false));
}

}  // namespace
}  // namespace feedscope

#include "core/toolpath/turn_ceiling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/units.h"
#include "core/toolpath/machine_path.h"
#include "tests/core/toolpath/table_machine.h"

namespace feedscope {
namespace {

constexpr double from_table = 400;  // of the tip to the axis of C [mm]

/// A block along C's axis of 100 mm, in which the table turns.
MachinePath block_with(double feed, double turn) {
  Machine machine = table_machine();
  machine.kinematics.tool_length = 150;
  Settings settings;
  settings.set("part_zero_x_mm", from_table);
  settings.set("part_zero_y_mm", 0.0);
  settings.set("part_zero_z_mm", -300.0);
  ReadOptions options;
  options.dialect = Dialect::sinumerik;
  options.unit = LengthUnit::mm;
  options.rotary_axes = "AC";
  const std::string text =
      "TRAORI\nG0 X0 Y0 Z0\nG1 F" + std::to_string(feed) + " Z100 C" + std::to_string(turn) + "\n";
  const ReadProgram program =
      read_program(std::make_shared<const SourceText>("test.mpf", text), nullptr, options);
  return on_machine(std::make_shared<const Toolpath>(build_toolpath(program)), machine, settings);
}

/// X and Y of the machine are R cos(phi) and R sin(phi) with phi = w s: the tip may go V/(R w |sin phi|) and
/// V/(R w |cos phi|) at s.
TEST(TurnCeiling, FollowsTheVelocityOfEveryAxisHoweverFarTheyTurn) {
  for (const double turn : {430.0, 5000.0}) {
    const auto path = block_with(60000, turn);
    const double slope = from_table * units::from_deg(turn) / 100;
    const auto ceiling = [&](double s) {
      const double angle = units::from_deg(turn) * s / 100;
      return 500 / (slope * std::max(std::abs(std::sin(angle)), std::abs(std::cos(angle))));
    };
    const auto parts = path->turn_parts_of(path->segments.size() - 1);
    ASSERT_GT(parts.size(), turn / 15);
    double from = 0;
    for (const TurnPart& part : parts) {
      double slowest = HUGE_VAL;
      double fastest = 0;
      for (int i = 0; i <= 20; ++i) {
        const double there = ceiling(from + (part.end - from) * i / 20);
        slowest = std::min(slowest, there);
        fastest = std::max(fastest, there);
      }
      EXPECT_LE(part.limit.speed, slowest * (1 + 1e-9)) << part.end;
      EXPECT_GE(part.limit.speed, fastest / 1.011) << part.end;
      EXPECT_EQ(part.limit.by, TurnLimit::By::velocity);
      from = part.end;
    }
    EXPECT_EQ(from, 100);
    EXPECT_NEAR(path->segment_turns.back().limit.speed, 500 / slope, 1e-3 * 500 / slope);
  }
}

TEST(TurnCeiling, LeavesABlockWholeThatTheFeedLimits) {
  const auto path = block_with(60, 5000);
  EXPECT_TRUE(path->turn_parts.empty());
  EXPECT_GT(path->segment_turns.back().limit.speed, 1);
}

}  // namespace
}  // namespace feedscope

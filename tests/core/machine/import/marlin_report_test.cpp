#include <cmath>

#include "tests/core/machine/import/import_fixture.h"

namespace feedscope {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

constexpr const char* marlin_settings = R"(echo:; Linear Units:
echo:  G21 ; (mm)
echo:; Steps per unit:
echo: M92 X80.00 Y80.00 Z400.00 E93.00
echo:; Max feedrates (units/s):
echo:  M203 X500.00 Y400.00 Z5.00 E25.00
echo:; Max Acceleration (units/s2):
echo:  M201 X3000.00 Y2500.00 Z100.00 E10000.00
echo:; Acceleration (units/s2) (P<print-accel> R<retract-accel> T<travel-accel>):
echo:  M204 P1500.00 R3000.00 T1500.00
echo:; Advanced (B<min_segment_time_us> S<min_feedrate> T<min_travel_feedrate> X<max_jerk>):
echo:  M205 B20000.00 S0.00 T0.00 X8.00 Y9.00 Z0.30 E5.00
echo:; PID settings:
echo:  M301 P22.20 I1.08 D114.00
ok
)";

class MarlinReport : public test::ImportTest {
 protected:
  static std::string changed(const std::string& from, const std::string& to,
                             const std::string& text = marlin_settings) {
    return replaced(text, from, to);
  }
};

TEST_F(MarlinReport, GivesLimitsOfAxesAndPath) {
  const ImportedMachine imported = import(marlin_settings, "m503.txt");
  const Machine& machine = imported.machine;
  EXPECT_EQ(imported.kind, "listing of Marlin settings");
  EXPECT_EQ(machine.control, "Marlin");
  EXPECT_EQ(machine.model, "klipper");
  EXPECT_NEAR(machine.axes[0].velocity, 500, 1e-9);
  EXPECT_NEAR(machine.axes[2].velocity, 5, 1e-9);
  EXPECT_NEAR(machine.axes[1].acceleration, 2500, 1e-9);
  EXPECT_EQ(machine.settings.number("max_velocity_m_min"), 24);  // of Y, the slower one
  EXPECT_EQ(machine.settings.number("max_acceleration_m_s2"), 1.5);
  EXPECT_EQ(machine.settings.number("max_z_acceleration_m_s2"), 0.1);
  EXPECT_EQ(machine.settings.number("square_corner_velocity_mm_s"), 8);
  EXPECT_EQ(machine.settings.text("refuse"), "off");
  EXPECT_EQ(source(imported, "X.velocity"), "m503.txt, line 6: M203 X500.00 mm/s");
  EXPECT_EQ(source(imported, "max_acceleration_m_s2"), "m503.txt, line 10: M204 P1500.00 mm/s2");
  EXPECT_THAT(source(imported, "square_corner_velocity_mm_s"),
              StartsWith("assumed: m503.txt, line 12: M205 X8.00"));
  EXPECT_THAT(notes(imported, "m503.txt"), HasSubstr("there is no model of Marlin"));
  EXPECT_FALSE(has_errors(imported.notes));
}

TEST_F(MarlinReport, MakesACornerSpeedOfTheJunctionDeviation) {
  const ImportedMachine imported = import(changed("X8.00 Y9.00", "J0.02"), "a.txt");
  // v^2 = a d s/(1 - s) with s = sin 45 degrees
  const double s = std::sqrt(0.5);
  EXPECT_NEAR(imported.machine.settings.number("square_corner_velocity_mm_s"),
              std::sqrt(1500 * 0.02 * s / (1 - s)), 1e-9);
}

TEST_F(MarlinReport, ConvertsInches) {
  const ImportedMachine imported =
      import(changed("G21", "G20", changed("M203 X500.00", "M203 X20")), "a.txt");
  EXPECT_NEAR(imported.machine.axes[0].velocity, 20 * 25.4, 1e-6);
  EXPECT_EQ(source(imported, "X.velocity"), "a.txt, line 6: M203 [inch] X20 mm/s");
}

TEST_F(MarlinReport, ReadsTheVelocitiesOfRepRapFirmwarePerMinute) {
  const ImportedMachine imported =
      import("M566 X900 Y600 Z12\nM203 X6000 Y6000 Z180\nM201 X500 Y500 Z20\nG90\n", "config.g");
  EXPECT_EQ(imported.machine.control, "RepRapFirmware");
  EXPECT_NEAR(imported.machine.axes[0].velocity, 100, 1e-9);
  EXPECT_NEAR(imported.machine.settings.number("square_corner_velocity_mm_s"), 10, 1e-9);
  EXPECT_EQ(imported.machine.settings.number("max_acceleration_m_s2"), 0.5);
}

TEST_F(MarlinReport, ReportsContradictionsAndBadNumbers) {
  EXPECT_THAT(
      notes(import(changed("P1500", "P2600"), "a.txt"), "a.txt"),
      HasSubstr(
          "a.txt:10: warning: M204 P2600.00 exceeds M201 Y2500.00 (a.txt, line 8); the lower one is used"));
  EXPECT_THAT(notes(import(std::string(marlin_settings) + "M203 X100\n", "a.txt"), "a.txt"),
              HasSubstr("a.txt:16: warning: M203 X100, but M203 X500.00 in a.txt, line 6; X100 is used"));
  EXPECT_THAT(notes(import(changed("Z5.00", "Zslow"), "a.txt"), "a.txt"),
              HasSubstr("a.txt:6: error: M203 Zslow: 'slow' is not a number"));
  EXPECT_THAT(notes(import(changed("Z5.00", "Z0"), "a.txt"), "a.txt"),
              HasSubstr("M203 Z0 mm/s cannot be used"));
}

TEST_F(MarlinReport, IsNoProgramThatSetsLimits) {
  EXPECT_EQ(configuration_kind("M201 X500\nM203 X100\nM205 X8\nG28\nG1 X10 F3000\n"), "");
}

}  // namespace
}  // namespace feedscope

#include <gtest/gtest.h>

#include <string>

#include "tests/core/program/iso/iso_text.h"
#include "tests/core/program/motion_text.h"

namespace feedscope {
namespace {

/// Of the last motion.
PathControl control_of(Dialect dialect, const std::string& text) {
  const ReadProgram program = read_clean_as(dialect, text);
  return program.path_controls.at(program.motions.back().path_control);
}

TEST(IsoPathControl, IsTheMachinesUntilTheProgramSaysMore) {
  EXPECT_EQ(control_of(Dialect::linuxcnc, "G0 X1"), PathControl());
}

TEST(IsoPathControl, ExactStopsAreModal) {
  for (const char* const word : {"G61", "G61.1"}) {
    EXPECT_EQ(control_of(Dialect::linuxcnc, std::string(word) + "\nG0 X1\nX2").mode, PathMode::exact_stop);
    EXPECT_EQ(control_of(Dialect::linuxcnc, std::string(word) + " G0 X1\nG64 X2").mode, PathMode::continuous);
  }
}

TEST(IsoPathControl, G9StopsAtTheEndOfItsBlockOnly) {
  const ReadProgram program = read_clean_as(Dialect::fanuc, "G64 G1 X1 F100\nG9 X2\nX3");
  const auto mode = [&](std::size_t i) {
    return program.path_controls.at(program.motions[i].path_control).mode;
  };
  EXPECT_EQ(mode(0), PathMode::continuous);
  EXPECT_EQ(mode(1), PathMode::exact_stop);
  EXPECT_EQ(mode(2), PathMode::continuous);
}

TEST(IsoPathControl, G64HasToleranceAndJoinsLinesInItsUnit) {
  const PathControl both = control_of(Dialect::linuxcnc, "G64 P0.05 Q0.02\nG0 X1");
  EXPECT_EQ(both.contour_tolerance, 0.05);
  EXPECT_EQ(both.compaction, Switch::on);
  EXPECT_EQ(both.compaction_tolerance, 0.02);
  const PathControl inch = control_of(Dialect::linuxcnc, "G20 G64 P0.001\nG0 X1");
  EXPECT_NEAR(inch.contour_tolerance.value(), 0.0254, 1e-15);
  EXPECT_NEAR(inch.compaction_tolerance.value(), 0.0254, 1e-15);
  EXPECT_EQ(control_of(Dialect::linuxcnc, "G64 P0.05 Q0\nG0 X1").compaction, Switch::off);
  EXPECT_EQ(control_of(Dialect::linuxcnc, "G64 P0.05\nG64\nG0 X1").contour_tolerance, std::nullopt);
  EXPECT_EQ(control_of(Dialect::fanuc, "G64\nG0 X1").compaction, Switch::machine);
}

TEST(IsoPathControl, LookAheadIsSwitched) {
  const auto look_ahead = [](const char* text) {
    return control_of(Dialect::fanuc, std::string(text) + "\nG0 X1").look_ahead;
  };
  EXPECT_EQ(look_ahead("G05.1 Q1"), Switch::on);
  EXPECT_EQ(look_ahead("G05.1 Q1\nG05.1 Q0"), Switch::off);
  EXPECT_EQ(look_ahead("G08 P1"), Switch::on);
  EXPECT_EQ(look_ahead("G08 P1\nG08 P0"), Switch::off);
  EXPECT_EQ(look_ahead("G05 P10000"), Switch::on);
  EXPECT_EQ(look_ahead("G05 P10000\nG05 P0"), Switch::off);
}

/// As Fanuc writes it, with the axes that it is for (Series 15i/150i-MA, Operator's Manual, 4.16).
TEST(IsoPathControl, SmoothInterpolationIsNeitherLookAheadNorASpline) {
  const ReadProgram after = read_as(Dialect::fanuc, "G05.1 Q1\nG05.1 Q2 X0 Y0 Z0\nG1 X1 F100");
  const PathControl& smooth = after.path_controls.at(after.motions.back().path_control);
  EXPECT_EQ(smooth.look_ahead, Switch::machine);
  EXPECT_EQ(smooth.compressor, Switch::machine);
  const std::string said = said_of(Dialect::fanuc, "G1 X5 F100\nG05.1 Q2 X0 Y0 Z0\nX9\nG05.1 Q0\nX10");
  EXPECT_TRUE(said.starts_with("f:2:7: warning: G5.1 Q2 (smooth interpolation) is not supported [unread-g]"))
      << said;
  EXPECT_EQ(said.find('\n'), std::string::npos) << said << ": its axis words are no places";
  const ReadProgram program = read_as(Dialect::fanuc, "G1 X5 F100\nG05.1 Q2 X0 Y0 Z0\nX9");
  EXPECT_EQ(text_of(program), (Lines{"line 5 0 0 @1", "line 9 0 0 @3"}));
}

TEST(IsoPathControl, CornerOverrideAndTappingEndTheExactStop) {
  EXPECT_EQ(control_of(Dialect::fanuc, "G61\nG62\nG0 X1").mode, PathMode::continuous);
  EXPECT_EQ(control_of(Dialect::fanuc, "G61\nG63\nG0 X1").mode, PathMode::continuous);
}

TEST(IsoPathControl, G187NamesATolerance) {
  EXPECT_EQ(control_of(Dialect::fanuc, "G187 E0.02\nG0 X1").contour_tolerance, 0.02);
  EXPECT_EQ(control_of(Dialect::fanuc, "G187 E0.02\nG187\nG0 X1").contour_tolerance, std::nullopt);
}

TEST(IsoPathControl, ANegativeToleranceIsRefused) {
  EXPECT_EQ(said_of(Dialect::linuxcnc, "G0 X1\nG64 P-1\nX2"),
            "f:2:5: error: tolerance P-1 of G64 is negative [path-tolerance] (it is ignored; write a "
            "tolerance of zero or more)");
}

TEST(IsoPathControl, ATooSmallToleranceIsRaised) {
  EXPECT_EQ(
      said_of(Dialect::linuxcnc, "G0 X1\nG64 P0.0000001\nX2"),
      "f:2:5: warning: tolerance P0.0000001 of G64 is below 0.000001 mm [path-tolerance] (0.000001 mm is "
      "used, the smallest that is simulated)");
  const ReadProgram program = read_as(Dialect::linuxcnc, "G20\nG64 P0.00000001 Q0.00000001\nG0 X1");
  const PathControl& control = program.path_controls.at(program.motions.back().path_control);
  EXPECT_EQ(control.contour_tolerance, 1e-6);
  EXPECT_EQ(control.compaction_tolerance, 1e-6);
  EXPECT_EQ(control_of(Dialect::linuxcnc, "G64 P0\nG0 X1").contour_tolerance, 0);
}

}  // namespace
}  // namespace feedscope

// Words of single makes of controls: Haas, printers, tapes.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <tuple>

#include "tests/core/program/iso/iso_text.h"
#include "tests/core/program/motion_text.h"

namespace feedscope {
namespace {

/// Places of the holes: where feed moves end at Z-1.
Lines holes(const std::string& text) {
  Lines places;
  for (const std::string& line : text_of(read_clean_as(Dialect::fanuc, text))) {
    if (line.starts_with("line") && line.find(" -1 @") != std::string::npos) {
      places.push_back(line.substr(5, line.find(" -1 @") - 5));
    }
  }
  return places;
}

TEST(HaasPatterns, HolesOnACircleAnArcAndALine) {
  const std::string drill = "G0 X100 Y50\nG81 Z-1 R1 F100 L0\n";
  EXPECT_EQ(holes(drill + "G70 I10 J90 L4"), (Lines{"100 60", "90 50", "100 40", "110 50"}));
  EXPECT_EQ(holes(drill + "G71 I10 J0 K45 L3"), (Lines{"110 50", "107.071068 57.071068", "100 60"}));
  EXPECT_EQ(holes(drill + "G72 I10 J180 L3"), (Lines{"100 50", "90 50", "80 50"}));
}

TEST(HaasPatterns, NeedACycle) {
  EXPECT_EQ(said_of(Dialect::fanuc, "G0 X1\nG70 I10 J90 L4"),
            "f:2:1: error: G70 (hole pattern) needs an active drilling cycle, I and L [cycle-words] (nothing "
            "is drilled; for the units inch and mm program G20 or G21)");
}

TEST(HaasPecks, BecomeSmallerFromTheFirstToTheLeast) {
  // Pecks of 5, 4, 3, 2, 2 and what is left of 17.
  const ReadProgram program = read_clean_as(Dialect::fanuc, "G0 Z2\nG99 G83 X1 Z-15 R2 I5 J1 K2 F100\nX9");
  Lines feeds;
  for (const std::string& line : text_of(program)) {
    if (line.starts_with("line 1 ")) {
      feeds.push_back(line);
    }
  }
  EXPECT_EQ(feeds, (Lines{"line 1 0 -3 @2", "line 1 0 -7 @2", "line 1 0 -10 @2", "line 1 0 -12 @2",
                          "line 1 0 -14 @2", "line 1 0 -15 @2"}));
}

TEST(FineBoring, StepsAsideByIAndJ) {
  EXPECT_EQ(text_of(read_clean_as(Dialect::fanuc, "G0 Z2\nG99 G76 X1 Y2 Z-5 R2 I0.1 J-0.2 F100")),
            (Lines{"rapid 0 0 2 @1", "rapid 1 2 2 @2", "line 1 2 -5 @2", "rapid 1.1 1.8 -5 @2",
                   "rapid 1.1 1.8 2 @2", "rapid 1 2 2 @2"}));
}

TEST(HaasOffsets, FurtherOnesAreThoseOfG541) {
  EXPECT_EQ(text_of(read_clean_as(Dialect::fanuc, "G10 L20 P3 X100\nG154 P3\nG0 X1")),
            (Lines{"rapid 101 0 0 @3"}));
}

TEST(HaasWords, ThatAreNotReadDoNotMove) {
  for (const char* const word :
       {"G12 I10 Z-1 D1 F100", "G47 P0 X5 Y5 I0 J1 R1 Z-1 F10", "G150 X1 Y1 Z-1 P2"}) {
    const ReadProgram program = read_as(Dialect::fanuc, std::string("G0 Z5\n") + word);
    EXPECT_TRUE(has_errors(program.diagnostics)) << word;
    EXPECT_EQ(text_of(program), (Lines{"rapid 0 0 5 @1"})) << word;
  }
}

TEST(MacroArguments, MayHoldEBehindANumber) {
  const std::string macro = "\nM30\nO9000\nG0 X#8 Y#6 Z#9\nM99";
  EXPECT_EQ(text_of(read_clean_as(Dialect::fanuc, "O1\nG65P9000K1.E100.F200." + macro)),
            (Lines{"rapid 100 1 200 @5"}));
  EXPECT_EQ(text_of(read_clean_as(Dialect::fanuc, "O1\nG65P9000F600E41K2" + macro)),
            (Lines{"rapid 41 2 600 @5"}));
}

TEST(Tapes, AColonIsAnO) {
  EXPECT_EQ(text_of(read_clean_as(Dialect::fanuc, "%\n:1234\nG0 X1\nM98 P20\nM30\n:0020\nX2\nM99\n%")),
            (Lines{"rapid 1 0 0 @3", "rapid 2 0 0 @7"}));
}

/// Order of execution of LinuxCNC: F before G20 and G21.
TEST(LinuxCnc, TakesTheFeedInTheUnitBeforeItsBlock) {
  const ReadProgram program = read_as(Dialect::linuxcnc, "G20 F60\nG1 X1\nG1 X2 F60\n");
  ASSERT_EQ(program.motions.size(), 2U);
  EXPECT_DOUBLE_EQ(program.motions[0].feed, 1);
  EXPECT_DOUBLE_EQ(program.motions[1].feed, 25.4);
  EXPECT_DOUBLE_EQ(program.motions[1].target.x(), 50.8);
  ASSERT_EQ(program.diagnostics.size(), 1U);
  EXPECT_EQ(program.diagnostics[0].code, "feed-value");
  for (const Dialect dialect : {Dialect::fanuc, Dialect::grbl}) {
    const ReadProgram other = read_clean_as(dialect, "G20 F60\nG1 X1\n");
    EXPECT_DOUBLE_EQ(other.motions[0].feed, 25.4);
  }
}

TEST(Printers, CommandsWithNamesMoveNothingAndAreSaid) {
  const ReadProgram program = read_text(
      "start_print BED=60\n"
      "G1 X5 F600\n"
      "SET_VELOCITY_LIMIT ACCEL=2000 VELOCITY=100\n"
      "SET_VELOCITY_LIMIT ACCEL=1000\n"
      "G1 X9\n");
  EXPECT_EQ(program.dialect, Dialect::grbl);
  EXPECT_EQ(program.motions.size(), 2U);
  ASSERT_EQ(program.diagnostics.size(), 3U);
  EXPECT_EQ(program.diagnostics[0].severity, Severity::warning);
  EXPECT_EQ(program.diagnostics[0].line, 1U);
  EXPECT_EQ(program.diagnostics[1].severity, Severity::info);
  EXPECT_EQ(program.diagnostics[1].line, 3U);
  EXPECT_EQ(program.diagnostics[2].line, 4U);
}

/// Subprograms of a Sinumerik may have such names too.
TEST(Printers, OtherNamesStayThoseOfTheSinumerik) {
  EXPECT_EQ(read_text("MY_CONTOUR\nG1 X5 F600\nR1=4\nCYCLE832(0.01)\n").dialect, Dialect::sinumerik);
}

TEST(Printers, WaitMillisecondsAndSecondsAndDoNotLevelOnTheWay) {
  const ReadProgram program = read_as(Dialect::grbl, "M104 S200\nG0 X5\nG29\nG4 P500\nG4 S3\nG1 X9 F600");
  ASSERT_EQ(program.motions.size(), 4U);
  EXPECT_EQ(program.motions[1].dwell, 0.5);
  EXPECT_EQ(program.motions[2].dwell, 3);
  for (const std::string word :
       {"M18", "M84", "M106 S90", "M280 P0 S10", "M300 S30.00 (pen down)", "G1 X1 E0.5", "m82"}) {
    for (const std::string& text : {word + "\nG0 X5\nG4 P150\n", "G0 X5\nG4 P150\n" + word + "\n"}) {
      double dwell = 0;
      for (const MotionBlock& block : read_as(Dialect::grbl, text).motions) {
        dwell += block.dwell;
      }
      EXPECT_EQ(dwell, 0.15) << text;
    }
  }
  for (const std::string word : {"M3 S1000", "M8", "M30", "M0", "(M300)", "; E5", "M56 P1"}) {
    const ReadProgram waiting = without_events(read_as(Dialect::grbl, "G0 X5\nG4 P5\n" + word));
    EXPECT_EQ(waiting.motions.back().dwell, 5) << word;
  }
  EXPECT_EQ(said_of(Dialect::grbl, "G0 X5\nG4 P150"),
            "f:2:4: info: P150 is used as 150 seconds, as in grbl [dwell-unit] (for a control that takes "
            "milliseconds, write P0.15)");
  EXPECT_EQ(
      said_of(Dialect::linuxcnc, "G21 G0 X5\nG4 P1500"),
      "f:2:4: info: P1500 is used as 1500 seconds, as in LinuxCNC [dwell-unit] (for a control that takes "
      "milliseconds, write P1.5)");
  EXPECT_EQ(read_as(Dialect::grbl, "G0 X5\nG4 P0.5").motions.back().dwell, 0.5) << "grbl itself: seconds";
}

TEST(Points, ThatAreMissingOnNumbersBeyondAnyTravelAreSaid) {
  EXPECT_EQ(said_of(Dialect::fanuc, "G0 X25000"),
            "f:1:4: warning: X25000 without a decimal point is used as 25000 mm [decimal-point] (many "
            "controls use it in units of 0.001 mm; write a decimal point)");
  read_clean_as(Dialect::fanuc, "G0 X25000. Y500");
  EXPECT_EQ(
      said_of(Dialect::fanuc, "G0 X10\nG4 X1500"),
      "f:2:4: warning: X1500 without a decimal point is used as 1500 seconds [decimal-point] (many controls "
      "use it in units of 0.001 s; write a decimal point)");
  EXPECT_EQ(said_of(Dialect::iso, "G21 G0 X10\nG4 U60").substr(0, 49),
            "f:2:4: warning: U60 without a decimal point is us");
  read_clean_as(Dialect::fanuc, "G0 X10\nG4 X1500.\nG4 X10\nG4 P1500");
}

TEST(Points, AreMissedOnRadiiCentresAndPecksToo) {
  const auto said = [](const std::string& text) { return said_of(Dialect::fanuc, text).substr(0, 70); };
  EXPECT_EQ(said("G0 X0 Y0\nG2 X10. Y10. R10000 F100"),
            "f:2:14: warning: R10000 without a decimal point is used as 10000 mm [d");
  EXPECT_EQ(said("G0 X0 Y0\nG2 X0 Y20000. J10000 F100"),
            "f:2:15: warning: J10000 without a decimal point is used as 10000 mm [d");
  EXPECT_EQ(said("G0 Z5.\nG83 X1. Z-20. R2. Q5000 F100"),
            "f:2:19: warning: Q5000 without a decimal point is used as 5000 mm [dec");
  read_clean_as(Dialect::fanuc, "G0 Z5.\nG83 X1. Z-20. R2. Q5 F100\nG80\nG2 X0 Y20000. J10000.");
}

/// LinuxCNC sets the feed before the unit (Interp::execute_block); grbl converts F by the unit of its block
/// (gcode.c, "Set feed rate"), as Fanuc does.
TEST(Feeds, OfABlockThatChangesTheUnitAreInTheUnitThatTheControlTakes) {
  constexpr double inch = 25.4;
  for (const auto& [dialect, to_inch, to_mm] :
       {std::tuple{Dialect::linuxcnc, 1.0, inch}, {Dialect::grbl, inch, 1.0}, {Dialect::fanuc, inch, 1.0}}) {
    EXPECT_DOUBLE_EQ(read_as(dialect, "G21 G0 X0 Y0\nG20 G1 X2. F60.").motions.back().feed, to_inch);
    EXPECT_DOUBLE_EQ(read_as(dialect, "G20 G0 X0 Y0\nG21 G1 X2. F60.").motions.back().feed, to_mm);
    EXPECT_DOUBLE_EQ(read_clean_as(dialect, "G21 G0 X0 Y0\nG20\nG1 X2. F60.").motions.back().feed, inch);
  }
}

TEST(Motions, WithoutAMotionWordStopTheControlsThatHaveNone) {
  const auto error = [](const char* place, const char* what) {
    return fmt::format("f:{}: error: position words {} [motion-mode] (G0 is used; write the G word)", place,
                       what);
  };
  const std::string cycle = "G0 X0 Y0 Z9\nG81 X1 Y0 Z-5 R2 F300\nG80\nX5";
  EXPECT_EQ(said_of(Dialect::linuxcnc, "G21\n" + cycle),
            error("5:1", "after G80 without a new G0, G1, G2 or G3: LinuxCNC stops here with an error"));
  EXPECT_EQ(said_of(Dialect::grbl, "G21 G1 X5 F100\nG80\nX9"),
            error("3:1", "after G80 without a new G0, G1, G2 or G3: grbl stops here with an error"));
  EXPECT_EQ(said_of(Dialect::linuxcnc, "G21\nX5"),
            error("2:1", "before the first G0, G1, G2 or G3: LinuxCNC stops here with an error"));
  EXPECT_EQ(
      said_of(Dialect::grbl, "G21\nX5"),
      "f:2:1: warning: position words before the first G0, G1, G2 or G3 [motion-mode] (G0 is used; write "
      "the G word)");
  read_clean_as(Dialect::fanuc, "G21\n" + cycle);
}

TEST(Turning, IsSaid) {
  EXPECT_EQ(said_of(Dialect::fanuc, "G50 S3000\nG0 X50. Z2."),
            "f:1:1: warning: G50 with S belongs to a turning program [turning-program] (turning is not "
            "supported: X is used as a radius, G98 and G99 as those of drilling cycles)");
}

TEST(FanucCycles, EndInTheMotionBeforeThem) {
  EXPECT_EQ(text_of(read_clean_as(Dialect::fanuc, "G1 Z5 F100\nG99 G81 X1 Z-1 R5\nG80\nX9")),
            (Lines{"line 0 0 5 @1", "rapid 1 0 5 @2", "line 1 0 -1 @2", "rapid 1 0 5 @2", "line 9 0 5 @4"}));
}

TEST(CutterOffsets, NumberDStaysFromABlockBefore) {
  EXPECT_EQ(
      text_of(read_clean_as(Dialect::fanuc, "G10 L12 P3 R2\nG49 D3\nG41 G1 X10 F100\nX20\nG40 X30 Y5")).at(1),
      "line 20 2 0 @4");
}

TEST(RotaryAxes, AreSaidOnceEach) {
  const ReadProgram program = read_as(Dialect::fanuc, "G0 X1 A1 C1\nX2 A2 C2\nX3 A3 C3");
  EXPECT_EQ(program.diagnostics.size(), 2U);
  EXPECT_EQ(program.motions.size(), 3U);
}

}  // namespace
}  // namespace feedscope

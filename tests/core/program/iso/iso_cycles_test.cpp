#include <gtest/gtest.h>

#include <string>

#include "tests/core/program/iso/iso_text.h"
#include "tests/core/program/motion_text.h"

namespace feedscope {
namespace {

struct CycleCase {
  const char* name;
  const char* text;  ///< after "G0 Z50", a hole at X10 Y20
  Lines expected;
};

class IsoCycle : public testing::TestWithParam<CycleCase> {};

TEST_P(IsoCycle, MovesAsTheControlsDo) {
  const ReadProgram program = read_clean_as(Dialect::fanuc, std::string("G0 Z50\n") + GetParam().text);
  Lines expected = GetParam().expected;
  expected.insert(expected.begin(), "rapid 0 0 50 @1");
  EXPECT_EQ(text_of(program), expected);
}

INSTANTIATE_TEST_SUITE_P(
    Codes, IsoCycle,
    testing::Values(
        CycleCase{"G81",
                  "G98 G81 X10 Y20 Z-5 R2 F100",
                  {"rapid 10 20 50 @2", "rapid 10 20 2 @2", "line 10 20 -5 @2", "rapid 10 20 50 @2"}},
        CycleCase{"G81toR",
                  "G99 G81 X10 Y20 Z-5 R2 F100",
                  {"rapid 10 20 50 @2", "rapid 10 20 2 @2", "line 10 20 -5 @2", "rapid 10 20 2 @2"}},
        CycleCase{"G82",
                  "G99 G82 X10 Y20 Z-5 R2 P500 F100",
                  {"rapid 10 20 50 @2", "rapid 10 20 2 @2", "line 10 20 -5 @2", "dwell 10 20 -5 @2",
                   "rapid 10 20 2 @2"}},
        CycleCase{"G83",
                  "G99 G83 X10 Y20 Z-5 R2 Q3 F100",
                  {"rapid 10 20 50 @2", "rapid 10 20 2 @2", "line 10 20 -1 @2", "rapid 10 20 2 @2",
                   "rapid 10 20 -0.746 @2", "line 10 20 -4 @2", "rapid 10 20 2 @2", "rapid 10 20 -3.746 @2",
                   "line 10 20 -5 @2", "rapid 10 20 2 @2"}},
        CycleCase{"G73",
                  "G99 G73 X10 Y20 Z-5 R2 Q4 F100",
                  {"rapid 10 20 50 @2", "rapid 10 20 2 @2", "line 10 20 -2 @2", "rapid 10 20 -1.746 @2",
                   "line 10 20 -5 @2", "rapid 10 20 2 @2"}},
        CycleCase{"G84",
                  "G98 G84 X10 Y20 Z-5 R2 F100",
                  {"rapid 10 20 50 @2", "rapid 10 20 2 @2", "line 10 20 -5 @2", "line 10 20 2 @2",
                   "rapid 10 20 50 @2"}},
        CycleCase{"G74",
                  "G99 G74 X10 Y20 Z-5 R2 F100",
                  {"rapid 10 20 50 @2", "rapid 10 20 2 @2", "line 10 20 -5 @2", "line 10 20 2 @2"}},
        CycleCase{"G85",
                  "G99 G85 X10 Y20 Z-5 R2 F100",
                  {"rapid 10 20 50 @2", "rapid 10 20 2 @2", "line 10 20 -5 @2", "line 10 20 2 @2"}},
        CycleCase{"G86",
                  "G99 G86 X10 Y20 Z-5 R2 F100",
                  {"rapid 10 20 50 @2", "rapid 10 20 2 @2", "line 10 20 -5 @2", "rapid 10 20 2 @2"}},
        CycleCase{"G88",
                  "G99 G88 X10 Y20 Z-5 R2 P100 F100",
                  {"rapid 10 20 50 @2", "rapid 10 20 2 @2", "line 10 20 -5 @2", "dwell 10 20 -5 @2",
                   "rapid 10 20 2 @2"}},
        CycleCase{"G89",
                  "G99 G89 X10 Y20 Z-5 R2 P100 F100",
                  {"rapid 10 20 50 @2", "rapid 10 20 2 @2", "line 10 20 -5 @2", "dwell 10 20 -5 @2",
                   "line 10 20 2 @2"}},
        CycleCase{"otherHoles",
                  "G99 G81 X10 Y20 Z-5 R2 F100\nX30\nR3\nG80\nG0 X0",
                  {"rapid 10 20 50 @2", "rapid 10 20 2 @2", "line 10 20 -5 @2", "rapid 10 20 2 @2",
                   "rapid 30 20 2 @3", "line 30 20 -5 @3", "rapid 30 20 2 @3", "rapid 30 20 3 @4",
                   "line 30 20 -5 @4", "rapid 30 20 3 @4", "rapid 0 20 3 @6"}},
        CycleCase{"incremental",
                  "G91 G99 G81 X10 Y20 Z-7 R-48 K2 F100",
                  {"rapid 10 20 50 @2", "rapid 10 20 2 @2", "line 10 20 -5 @2", "rapid 10 20 2 @2",
                   "rapid 20 40 2 @2", "line 20 40 -5 @2", "rapid 20 40 2 @2"}},
        CycleCase{"storedOnly",
                  "G99 G81 X10 Y20 Z-5 R2 K0 F100\nX30 Y0",
                  {"rapid 30 0 50 @3", "rapid 30 0 2 @3", "line 30 0 -5 @3", "rapid 30 0 2 @3"}},
        CycleCase{"anotherCycle",
                  "G99 G81 X10 Y20 Z-5 R2 F100\nG82 X30 P100",
                  {"rapid 10 20 50 @2", "rapid 10 20 2 @2", "line 10 20 -5 @2", "rapid 10 20 2 @2",
                   "rapid 30 20 2 @3", "line 30 20 -5 @3", "dwell 30 20 -5 @3", "rapid 30 20 2 @3"}},
        CycleCase{"belowR",
                  "G0 Z-9\nG99 G81 X10 Y20 Z-5 R2 F100",
                  {"rapid 0 0 -9 @2", "rapid 0 0 2 @3", "rapid 10 20 2 @3", "line 10 20 -5 @3",
                   "rapid 10 20 2 @3"}},
        CycleCase{"polar",
                  "G16 G99 G81 X10 Y90 Z-5 R2 F100\nG91 Y90\nG15",
                  {"rapid 0 10 50 @2", "rapid 0 10 2 @2", "line 0 10 -5 @2", "rapid 0 10 2 @2",
                   "rapid -10 0 2 @3", "line -10 0 -5 @3", "rapid -10 0 2 @3"}}),
    [](const auto& tested) { return std::string(tested.param.name); });

/// As rs274 of LinuxCNC has them.
TEST(IsoCycles, OnLinuxCncG89FeedsAsFarAsTheCycleEnds) {
  const auto out = [](Dialect dialect, const std::string& cycle) {
    const Lines all = text_of(read_clean_as(dialect, "G0 Z50\n" + cycle + " X10 Y20 Z-5 R2 F100"));
    return Lines(all.begin() + 4, all.end());
  };
  const Lines rapid_on{"line 10 20 2 @2", "rapid 10 20 50 @2"};
  EXPECT_EQ(out(Dialect::linuxcnc, "G98 G89"), Lines{"line 10 20 50 @2"});
  EXPECT_EQ(out(Dialect::linuxcnc, "G99 G89"), Lines{"line 10 20 2 @2"});
  EXPECT_EQ(out(Dialect::linuxcnc, "G98 G85"), rapid_on);
  EXPECT_EQ(out(Dialect::fanuc, "G98 G89"), rapid_on);
}

TEST(IsoCycles, DrillAlongTheNormalOfThePlane) {
  EXPECT_EQ(text_of(read_clean_as(Dialect::linuxcnc, "G18 G0 Y50\nG99 G81 X10 Z20 Y-5 R2 F100")),
            (Lines{"rapid 0 50 0 @1", "rapid 10 50 20 @2", "rapid 10 2 20 @2", "line 10 -5 20 @2",
                   "rapid 10 2 20 @2"}));
  EXPECT_EQ(text_of(read_clean_as(Dialect::linuxcnc, "G19 G0 X50\nG99 G81 Y10 Z20 X-5 R2 F100")),
            (Lines{"rapid 50 0 0 @1", "rapid 50 10 20 @2", "rapid 2 10 20 @2", "line -5 10 20 @2",
                   "rapid 2 10 20 @2"}));
}

TEST(IsoCycles, DwellIsSecondsForLinuxCncAndMillisecondsForFanuc) {
  const std::string text = "G0 Z9\nG82 X1 Z-1 R1 P2 F100";
  EXPECT_EQ(read_clean_as(Dialect::linuxcnc, text).motions.at(4).dwell, 2);
  EXPECT_EQ(read_clean_as(Dialect::fanuc, text).motions.at(4).dwell, 0.002);
  EXPECT_EQ(read_clean_as(Dialect::fanuc, "G0 Z9\nG82 X1 Z-1 R1 P2. F100").motions.at(4).dwell, 2);
}

TEST(IsoCycles, FineAndBackBoringMoveOffTheWall) {
  const ReadProgram fine = read_as(Dialect::fanuc, "G0 Z9\nG98 G76 X10 Z-5 R2 Q1 P100 F100");
  EXPECT_EQ(text_of(fine),
            (Lines{"rapid 0 0 9 @1", "rapid 10 0 9 @2", "rapid 10 0 2 @2", "line 10 0 -5 @2",
                   "dwell 10 0 -5 @2", "rapid 11 0 -5 @2", "rapid 11 0 9 @2", "rapid 10 0 9 @2"}));
  const ReadProgram back = read_as(Dialect::fanuc, "G0 Z9\nG98 G87 X10 Z-5 R-20 Q1 F100");
  EXPECT_EQ(text_of(back), (Lines{"rapid 0 0 9 @1", "rapid 10 0 9 @2", "rapid 11 0 9 @2", "rapid 11 0 -20 @2",
                                  "rapid 10 0 -20 @2", "line 10 0 -5 @2", "rapid 11 0 -5 @2",
                                  "rapid 11 0 9 @2", "rapid 10 0 9 @2"}));
  ASSERT_EQ(fine.diagnostics.size(), 1U);
  EXPECT_EQ(format(fine.diagnostics[0], "f"),
            "f:2:9: info: the direction in which G76 retracts from the wall is a control setting "
            "[cycle-aside] (the positive direction of the plane's first axis is used)");
}

TEST(IsoCycles, FeedRulesTheWayDown) {
  const ReadProgram program = read_clean_as(Dialect::fanuc, "G95 S600 G0 Z9\nG84 X1 Z-5 R2 F1.5");
  EXPECT_EQ(program.motions.at(3).feed, 15);
  EXPECT_EQ(program.motions.at(4).feed, 15);
}

struct FaultCase {
  const char* text;
  const char* expected;
};

class IsoCycleFault : public testing::TestWithParam<FaultCase> {};

TEST_P(IsoCycleFault, NamesWordAndWhatIsTakenInstead) {
  const ReadProgram program = read_as(Dialect::fanuc, GetParam().text);
  ASSERT_EQ(program.diagnostics.size(), 1U);
  EXPECT_EQ(format(program.diagnostics[0], "f"), GetParam().expected);
}

INSTANTIATE_TEST_SUITE_P(
    All, IsoCycleFault,
    testing::Values(FaultCase{"G0 Z9\nG81 X1 R2 F100",
                              "f:2:5: error: G81 without Z, the bottom of the hole [cycle-words] (the hole "
                              "is skipped; program it in the cycle's first block)"},
                    FaultCase{"G0 Z9\nG81 X1 Z-2 F100",
                              "f:2:5: error: G81 without R, the retract plane [cycle-words] (the level "
                              "before the cycle is used; program it in the cycle's first block)"},
                    FaultCase{"G0 Z9\nG81 X1 Z5 R2 F100",
                              "f:2:5: error: the bottom of the hole at Z 5.0000 mm is on the wrong side of R "
                              "2.0000 mm [cycle-words] (the hole is skipped; correct one of them)"},
                    FaultCase{"G0 Z9\nG81 X1 Z-5 R2 K-1 F100",
                              "f:2:15: error: K-1 is not a number of repeats from 0 to 100000 [cycle-words] "
                              "(the cycle runs once)"},
                    FaultCase{"G0 Z9\nG83 X1 Z-5 R2 F100",
                              "f:2:5: error: G83 without Q [cycle-words] (the hole is drilled in one infeed; "
                              "write Q with the depth of a peck)"},
                    FaultCase{"G0 Z9\nG83 X1 Z-5 R2 Q0.00001 F100",
                              "f:2:15: error: G83 with pecks of 1e-05 mm [cycle-words] (the hole is drilled "
                              "in one infeed; write Q with the depth of a peck)"},
                    FaultCase{"G0 Z9\nG76 P0.05 Z-1 I-.075 J0.008 K0.045 F100",
                              "f:2:1: error: G76 (threading cycle) is not supported [unread-g] (positions "
                              "are skipped up to the next G0 to G3)"}));

}  // namespace
}  // namespace feedscope

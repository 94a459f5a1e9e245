#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "core/program/program.h"
#include "tests/core/program/read_text.h"

namespace feedscope {
namespace {

using testing::HasSubstr;

struct Case {
  const char* text;
  const char* expected;  ///< as printed, its place first; the only diagnostic of `text`
};

class IsoDiagnostics : public testing::TestWithParam<Case> {};

TEST_P(IsoDiagnostics, NamesPlaceThingValueAndWhatToDo) {
  const ReadProgram program = read_text(GetParam().text);
  ASSERT_EQ(program.diagnostics.size(), 1U) << GetParam().text;
  EXPECT_EQ(format(program.diagnostics[0], "f"), GetParam().expected);
}

INSTANTIATE_TEST_SUITE_P(
    Words, IsoDiagnostics,
    testing::Values(
        Case{"G0 X1\nG0 Y1..2",
             "f:2:4: error: \"Y1..2\" has no valid number [malformed-number] (the block does not move; "
             "correct the word or write a plain number)"},
        Case{"G0 X1\nG0 X2000000000",
             "f:2:4: error: \"X2000000000\" is above the largest number, 1000000000 [number-range] (the "
             "block does not move; correct the word or write a plain number)"},
        Case{"G0 X1 (tool 3",
             "f:1:7: error: the comment \"(tool 3\" is not closed [unclosed-comment] (the rest of the line "
             "is used as the comment; add the closing bracket)"},
        Case{"G0 X1\nN20 POCKETS(0.01)",
             "f:2:5: error: \"POCKETS(0.01)\" is not a word of ISO programs [unread-statement] (the block "
             "does not move; if the program has another dialect, give it with --dialect)"},
        Case{"G0 X1\nG1 X#<depth>+5 F100",
             "f:2:5: error: #<depth> has not been set [unset-variable] (the block does not move; set it "
             "before, "
             "or check how the name is written)"},
        Case{"G0 X1\nG0 X2 \xC3\xA4",
             "f:2:7: error: byte 0xC3 does not start a word [unknown-character] (the rest of the line is "
             "skipped and the block does not move; remove the character)"},
        Case{"G0 X1 Y2 X3",
             "f:1:10: error: X is programmed twice in this block [duplicate-word] (\"X3\" is used; remove "
             "the other)"},
        Case{"G0 X1 G1 F100",
             "f:1:7: error: G0 and G1 exclude each other in one block [conflicting-g] (G1 is used; remove "
             "the other)"},
        Case{"G0 X1 G77.7",
             "f:1:7: error: \"G77.7\" is not a known G word [unknown-g] (it is ignored; the control may run "
             "another path)"},
        Case{"G0 X1\nX2 K4",
             "f:2:4: warning: K4 has no meaning in this block [unused-word] (it is ignored; check whether G2 "
             "or G3 is missing)"},
        Case{"G0 X1 E3",
             "f:1:7: info: E (extruder) is not supported [unused-word] (it does not change the path)"},
        Case{"G0 X1 B90",
             "f:1:7: warning: axis B moves to 90, which is not simulated [unread-axis] (X, Y and Z are shown "
             "as programmed; the time of this axis is not included, so the cycle time is too short; reported "
             "once)"},
        Case{"G0 X1\nM98 P1000",
             "f:2:5: error: M98 calls program 1000, which is neither in the program nor in a file in its "
             "folder [subprogram] (its motion is missing; add the file \"O1000\" to the program's folder)"},
        Case{"G0 X1\nM198 P10",
             "f:2:6: error: M198 calls program 10, which is neither in the program nor in a file in its "
             "folder [subprogram] (its motion is missing; add the file \"O0010\" to the program's folder)"},
        Case{"G0 X1\nG05.1 Q1 R5",
             "f:2:10: info: R5 of G5.1 (machining condition from speed to accuracy) changes nothing in the "
             "simulation [machining-mode] (its parameters exist only in the control; set acceleration and "
             "jerk of the "
             "machine instead)"},
        Case{"G1 X1 B90 F100",
             "f:1:7: error: axis B moves to 90 in a feed move, which is not simulated [unread-axis] (X, Y "
             "and Z are shown as programmed; the time of this axis is not included, so the cycle time is too "
             "short; reported once)"},
        Case{"X1",
             "f:1:1: warning: position words before the first G0, G1, G2 or G3 [motion-mode] (G0 is used; "
             "write the G word)"}));

INSTANTIATE_TEST_SUITE_P(
    Codes, IsoDiagnostics,
    testing::Values(
        Case{"G0 X1\nG43 H1 Z2",
             "f:2:1: info: G43 (tool length compensation) is not supported [unread-g] (the path shown is "
             "that of the tool tip)"},
        Case{"G0 X1\nG33 X2 Z-5 K1",
             "f:2:1: error: G33 (thread cutting) is not supported [unread-g] (positions are skipped up to "
             "the next G0 to G3)"},
        Case{"G0 X1\nG53 Z0",
             "f:2:1: warning: G53 moves to a machine position, which the program does not contain "
             "[machine-position] (neither drawn nor timed unless the machine gives positions (home_z_mm, "
             "part_zero_z_mm, ...); the path continues where every axis is programmed again)"},
        Case{"G54 G0 X1\nG55 X1",
             "f:2:1: warning: G55 is selected after motion in G54 [work-offset] (offsets without a value are "
             "assumed as zero, so parts of the path overlap; give them as an import option, --offset "
             "G55=X,Y,Z)"}));

INSTANTIATE_TEST_SUITE_P(
    Feeds, IsoDiagnostics,
    testing::Values(
        Case{"G0 X1\nG1 Y1\nX2",
             "f:2:4: error: a feed move without a feed [feed-missing] (it runs as fast as the "
             "axes allow; write F before it)"},
        Case{"G1 X1 F100\nX2 F0",
             "f:2:4: error: feed F0 is not above zero [feed-value] (the last valid feed stays "
             "in force; write a feed above zero)"},
        Case{"G0 X1 F-5",
             "f:1:7: error: feed F-5 is not above zero [feed-value] (feed moves run as fast as the "
             "axes allow; write a feed above zero)"},
        Case{"G0 X1\nG4",
             "f:2:1: error: G4 without a time [dwell-time] (the dwell is skipped; write P, X or U with the "
             "time)"},
        Case{"G0 X1\nG4 P-1", "f:2:4: error: dwell time P-1 is negative [dwell-time] (the dwell is skipped)"},
        Case{"G0 X1\nG4 P2",
             "f:2:4: info: P2 without a decimal point is used as 2 milliseconds [dwell-unit] (write P2.0 for "
             "seconds)"}));

INSTANTIATE_TEST_SUITE_P(
    Arcs, IsoDiagnostics,
    testing::Values(
        Case{"G1 X10 F1\nG2 X20 Y0 I4 J0",
             "f:2:11: error: the arc's radius is 4.0000 mm at its start but 6.0000 mm at its end "
             "[arc-radius] (check the centre; a straight line to its end is used instead)"},
        Case{"G1 X10 F1\nG2 X20 Y0 I15 J0",
             "f:2:11: error: the arc's radius is 15.0000 mm at its start but 5.0000 mm at its end "
             "[arc-radius] (the centre would fit as a position (G90.1); a straight line to its end is used "
             "instead)"},
        Case{"G1 X10 F1\nG2 X20 R4",
             "f:2:8: error: radius 4.0000 mm is too small for ends 10.0000 mm apart [arc-radius] (the radius "
             "must be at least half the distance; a straight line to its end is used instead)"},
        Case{"G1 X10 F1\nG2 X20",
             "f:2:4: error: the arc has neither a centre (I, J, K) nor a radius (R) [arc-center] (a straight "
             "line to its end is used instead)"},
        Case{"G1 X10 F1\nG2 X20 I5 R5",
             "f:2:8: error: the arc has both a centre (I, J, K) and a radius (R) [arc-center] (R is used; "
             "remove one of them)"},
        Case{"G1 X10 F1\nG2 X10 I0",
             "f:2:8: error: the arc's centre is its start point [arc-center] (a straight line to its end is "
             "used instead)"},
        Case{"G1 X10 F1\nG2 X10 R5",
             "f:2:8: error: an arc given by its radius must not end where it starts [arc-ends] (write "
             "a full circle with its centre)"},
        Case{"G1 X10 F1\nG2 I5 P0",
             "f:2:7: error: P0 is not a number of turns from 1 to 10000 [arc-turns] (one turn is used)"},
        Case{"G1 X10 F1\nG2 X20 I5 K3",
             "f:2:11: warning: K3 is perpendicular to the plane of the arc [unused-word] (it is ignored; "
             "check whether G17, G18 or G19 is missing)"}));

INSTANTIATE_TEST_SUITE_P(
    Files, IsoDiagnostics,
    testing::Values(
        Case{"",
             "f: error: the program has no blocks [empty-program] (give a file with NC blocks such as \"G1 "
             "X10 F500\")"},
        Case{"(only)\n; comments\n%\n",
             "f: error: the program has no blocks [empty-program] (give a file with NC blocks such as \"G1 "
             "X10 F500\")"},
        Case{"M3 S100",
             "f: warning: no block of the program moves an axis [no-motion] (if the program has another "
             "dialect, give it with --dialect)"},
        Case{"G0 X1\nM30\n\nG0 X2",
             "f:4:1: info: the program ends in line 2; the text after it is not executed [text-after-end]"}));

TEST(IsoDiagnostics, ColumnsCountBytesFromOneInEveryStyle) {
  EXPECT_EQ(read_text("  G0  X1\tG1F1").diagnostics.at(0).column, 10U);
  EXPECT_EQ(read_text("(\xC3\xA4)G0X1G1F1").diagnostics.at(0).column, 9U);
  EXPECT_EQ(read_text("\xEF\xBB\xBFX1").diagnostics.at(0).column, 1U);
  EXPECT_EQ(read_text("G0X1\r\r\nG0X1G1F1\r\r\n").diagnostics.at(0).column, 5U);
  EXPECT_EQ(read_text("G0X1\r\r\nG0X1G1F1\r\r\n").diagnostics.at(0).line, 2U);
}

TEST(IsoDiagnostics, TextInMessagesIsShortAndPlain) {
  const ReadProgram program = read_text("G0 X1\nX[\xFE\xFF" + std::string(500, '1') + "]");
  ASSERT_EQ(program.diagnostics.size(), 1U);
  EXPECT_THAT(program.diagnostics[0].message.english(), HasSubstr("\"??1111"));
  EXPECT_LT(program.diagnostics[0].message.english().size(), 100U);
}

TEST(IsoDiagnostics, EveryGCodeOnceSaysAtMostOneThing) {
  for (int tenfold = 0; tenfold < 10000; ++tenfold) {
    const std::string word = "G" + std::to_string(tenfold / 10) + "." + std::to_string(tenfold % 10);
    const ReadProgram program = read_text("G0 X1\n" + word + "\nG0 X2");
    EXPECT_LE(program.diagnostics.size(), 1U) << word;
  }
}

}  // namespace
}  // namespace feedscope

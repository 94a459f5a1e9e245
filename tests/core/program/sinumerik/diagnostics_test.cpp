#include <gtest/gtest.h>

#include <string>

#include "tests/core/program/sinumerik/read_sinumerik.h"

namespace feedscope {
namespace {

struct Case {
  const char* text;
  const char* expected;  ///< as printed, its place first; the only diagnostic of `text`
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.text;
}

class SinumerikDiagnostics : public testing::TestWithParam<Case> {};

TEST_P(SinumerikDiagnostics, NamesPlaceThingValueAndWhatToDo) {
  const ReadProgram program = read_sinumerik(GetParam().text);
  ASSERT_EQ(program.diagnostics.size(), 1U) << GetParam().text;
  EXPECT_EQ(format(program.diagnostics[0], "f"), GetParam().expected);
}

INSTANTIATE_TEST_SUITE_P(
    Words, SinumerikDiagnostics,
    testing::Values(
        Case{"G0 X1\nG0 Y1..2",
             "f:2:4: error: \"Y1..2\" has no valid number [malformed-number] (the block does not move; "
             "correct the number)"},
        Case{"G0 X1\nG0 X2000000000",
             "f:2:4: error: \"X2000000000\" is above the largest number, 1000000000 [number-range] (the "
             "block does not move; correct the number)"},
        Case{"G0 X1 Y2 X3",
             "f:1:10: error: X is programmed twice in this block [duplicate-word] (\"X3\" is used; remove "
             "the other)"},
        Case{"G0 X1\nL=7",
             "f:2:1: error: \"L=7\" does not name a subprogram [subprogram-name] (write its number with "
             "digits only, as in L12; nothing is called)"},
        Case{"G0 X1 G1 F100",
             "f:1:7: error: G0 and G1 exclude each other in one block [conflicting-g] (G1 is used; remove "
             "the other)"},
        Case{"G0 X1 G77",
             "f:1:7: error: \"G77\" is not a known G word [unknown-g] (it is ignored; the control may run "
             "another path)"},
        Case{"G0 X1\nX2 K4",
             "f:2:4: warning: K4 has no meaning in this block [unused-word] (it is ignored; check whether G2 "
             "or G3 is missing)"},
        Case{"X1 F100",
             "f:1:1: warning: position words before the first G0, G1, G2 or G3 [motion-mode] (G1 is used; "
             "write the G word)"},
        Case{"G0 X1 B90\nX2 B45",
             "f:1:7: warning: axis B moves to 90, which is not simulated [unread-axis] (X, Y and Z are shown "
             "as programmed; the time of this axis is not included, so the cycle time is too short; reported "
             "once)"},
        Case{"G0 X1\nX2 ?",
             "f:2:4: error: \"?\" does not start a word or statement [syntax] (the rest of the line is "
             "skipped and the block does not move; correct it)"},
        Case{"G0 X1\nSPEED=5",
             "f:2:1: error: \"SPEED\" is not a known variable, address or axis [unknown-name] (its value is "
             "ignored; define a variable by DEF before it is used)"},
        Case{"G0 X1\nX=_X_HOME",
             "f:2:3: error: the program does not define \"_X_HOME\" [unknown-name] (the block does not move; "
             "define data of the machine (GUD) at the program's top, \"DEF REAL _X_HOME=\")"},
        Case{"G0 X1\nG[1]=2 X3",
             "f:2:1: error: \"G[1]=2 X3\" does not start a word or statement [syntax] (the rest of the line "
             "is skipped and the block does not move; correct it)"},
        Case{"G0 X1\nTRANS X5 G1",
             "f:2:1: error: G1 and TRANS exclude each other in one block [conflicting-g] (the coordinates "
             "are used for TRANS and nothing moves; write a block for each)"},
        Case{"G0 X1\nISOCALL SHAPE",
             "f:2:9: error: ISOCALL (call of a program in ISO dialect) is not supported [unread-function] "
             "(its motion is skipped)"},
        Case{"G0 X1\nSUPA Z0",
             "f:2:6: warning: SUPA moves to a machine position, which the program does not contain "
             "[machine-position] (neither drawn nor timed unless the machine gives positions (home_z_mm, "
             "part_zero_z_mm, ...); the path continues where every axis is programmed again)"},
        Case{"G54 G0 X1\nG505 X1",
             "f:2:1: warning: G505 is selected after motion in G54 [work-offset] (offsets without a value "
             "are assumed as zero, so parts of the path overlap; give them as an import option, --offset "
             "G505=X,Y,Z)"},
        Case{"G1 X1",
             "f:1:4: error: a feed move without a feed [feed-missing] (it runs as fast as the axes "
             "allow; write F before it)"},
        Case{
            "G1 X1 F100\nX2 F0",
            "f:2:4: error: feed F0 is not above zero [feed-value] (the last valid feed stays in force; write "
            "a feed above zero)"},
        Case{"G0 X1\nG4",
             "f:2:1: error: G4 without a time [dwell-time] (the dwell is skipped; write F with seconds or S "
             "with revolutions)"},
        Case{"G0 X1\nG4 F-1", "f:2:4: error: dwell time F-1 is negative [dwell-time] (the dwell is skipped)"},
        Case{"G0 X1\nG4 S5",
             "f:2:4: error: a dwell of 5 revolutions without a spindle speed [dwell-time] (the dwell is "
             "skipped; write S in a block before it)"}));

INSTANTIATE_TEST_SUITE_P(
    Functions, SinumerikDiagnostics,
    testing::Values(
        Case{"G0 X1\nTRAANG",
             "f:2:1: error: TRAANG (inclined axis) is not supported [unread-function] (X, Y and Z are shown "
             "as programmed)"},
        Case{"G0 X1\nTRAORI",
             "f:2:1: info: TRAORI (tool orientation) is not supported [unread-function] (the path shown is "
             "that of the tool tip)"},
        Case{"G0 X1\nG33 Z-5 K1 S100",
             "f:2:5: info: G33 (thread) is shown as a line [thread] (its feed is lead times spindle speed; "
             "the run-up of the spindle is not shown)"},
        Case{"G0 X1\nWHEN $A_IN[1] DO M8",
             "f:2:6: info: a synchronized action is not supported [synchronized-action] (the path does not "
             "change)"},
        Case{"G0 X1\n$P_BFRAME=CTRANS(X,5)",
             "f:2:1: error: assignment to \"$P_BFRAME\" is not supported [system-variable] (the path is "
             "shown without it)"},
        Case{"G0 X=$AA_IM[X]",
             "f:1:6: warning: \"$AA_IM\" is a control-internal value [system-variable] (0 is used; the "
             "control may run another path)"},
        Case{"G0 X=R5",
             "f:1:6: warning: R5 is used before the program sets it [unset-parameter] (0 is used; the "
             "control has a value of its own)"},
        Case{"G0 X1\nG641 ADIS=-1",
             "f:2:6: error: ADIS=-1 is negative [path-value] (write a distance of zero or more; the block "
             "does not move)"},
        Case{"G0 X1\nG642 CTOL=0.0000001",
             "f:2:6: warning: CTOL=0.0000001 is below 0.000001 mm [path-value] (0.000001 mm is used, the "
             "smallest that is simulated)"},
        Case{"G0 X1\nG641 ADIS=0.0000001",
             "f:2:6: warning: ADIS=0.0000001 is below 0.000001 mm [path-value] (0.000001 mm is used, the "
             "smallest that is simulated)"},
        Case{"G0 X1\nCYCLE832(0.01,_ROUGH)",
             "f:2:1: info: machining type 3 of CYCLE832 changes nothing in the simulation [machining-mode] "
             "(its "
             "parameters exist only in the control; set acceleration and jerk of the machine instead)"},
        Case{"G0 X1\nSCALE X0",
             "f:2:1: error: a scale factor is zero [scale-factor] (1 is used; write a factor other than "
             "zero)"},
        Case{"G0 X1\nCYCLE832(0.01)",
             "f:2:1: warning: CYCLE832 with tolerance 0.01 and machining type 0 switches its settings off "
             "[path-value] (write the type as the second value: 1 finishing, 2 semi-finishing, 3 roughing)"},
        Case{"G0 X1 F100\nCYCLE81(10,0,2,-5,,0,10)",
             "f:2:1: error: the depth of CYCLE81 at the tool's diameter or shank is not supported "
             "[hole-depth] (it is used as the depth of the tip)"},
        Case{"G0 X1\nCYCLE800(1,\"T\",0,57,0,0,0,30,0,0,0,0,0,-1)",
             "f:2:1: warning: the tool retracts before the axes turn (_FR 1 of CYCLE800) [swivel-retract] "
             "(where to, the machine's data says: this motion is neither drawn nor timed)"},
        Case{"G0 X1\nCYCLE800(0,\"\",0,0,0,0,0,0,0,30)",
             "f:2:1: error: CYCLE800 with mode 0 is not supported [swivel] (the plane is shown without "
             "rotation; program angles about one axis after the other)"},
        Case{"G0 X1\nCYCLE800(0,\"\",0,192,0,0,0,10)",
             "f:2:1: error: CYCLE800 with mode 192 is not supported [swivel] (the plane is shown without "
             "rotation; program angles about one axis after the other)"},
        Case{"G0 X1\nPOCKET3(5,0,2,-5)",
             "f:2:1: error: cycle POCKET3 is not supported [unread-cycle] (its motion is skipped)"},
        Case{"G0 X1\nHOLES2(0,0,10,0,0,0)",
             "f:2:1: error: 0 is not a number of holes from 1 to 1000 [hole-count] (the holes are skipped; "
             "correct the number)"},
        Case{"G0 X1\nSHAPE_1(5)",
             "f:2:1: error: subprogram \"SHAPE_1\" is neither in the program nor a file in its folder "
             "[subprogram-missing] (its motion is skipped; add it to the program or to its folder)"}));

INSTANTIATE_TEST_SUITE_P(
    Arcs, SinumerikDiagnostics,
    testing::Values(
        Case{"G0 X0\nG2 X20 F100",
             "f:2:4: error: the arc has neither a centre (I, J, K) nor a radius (CR) [arc-center] (a "
             "straight line to its end is used instead)"},
        Case{"G0 X0\nG2 X20 CR=4 F100",
             "f:2:8: error: radius 4.0000 mm is too small for ends 20.0000 mm apart [arc-radius] (the radius "
             "must be at least half the distance; a straight line to its end is used instead)"},
        Case{"G0 X0\nG2 X20 I10 TURN=-1 F100",
             "f:2:12: error: TURN=-1 is not a number of turns from 0 to 999 [arc-turns] (no extra turn is "
             "used)"},
        Case{"G0 X0\nG2 X20 AR=400 F100",
             "f:2:8: error: opening angle AR=400 is not between 0 and 360 degrees [arc-angle] (a straight "
             "line to its end is used instead)"},
        Case{"G0 X0\nCIP X20 I1=10 F100",
             "f:2:9: error: start, intermediate point (I1, J1, K1) and end of CIP are on one line "
             "[arc-middle] (a straight line to its end is used instead)"},
        Case{"CT X20 F100",
             "f:1:4: error: CT without a preceding motion in its plane [arc-tangent] (a straight line to its "
             "end is used instead)"},
        Case{"G1 X5 ANG=90 F100",
             "f:1:7: error: a line at ANG=90 does not reach the given coordinate [line-angle] (the line ends "
             "at the given coordinates; program its end)"}));

INSTANTIATE_TEST_SUITE_P(
    Statements, SinumerikDiagnostics,
    testing::Values(
        Case{"G0 X1\nX=5*",
             "f:2:4: error: a value is missing at the end of the expression [expression] (write a number, a "
             "variable or a function here)"},
        Case{"G0 X1\nX=1/0",
             "f:2:4: error: \"/\" has no finite value [expression-value] (check the values that go into it)"},
        Case{"G0 X1\nIF 1==1",
             "f:2:7: error: IF has no matching start or end [control-structure] (the line is skipped; check "
             "IF, ELSE, ENDIF and the starts and ends of loops)"},
        Case{"G0 X1\nGOTOF DONE",
             "f:2:7: error: label \"DONE\" does not exist after this line [unknown-label] (the jump is "
             "skipped; check the label and the direction of the jump)"},
        Case{"G0 X1\nDEF LIST SHAPE",
             "f:2:5: error: \"LIST SHAPE\" is not a supported type [definition] (write REAL, INT, BOOL, "
             "CHAR, STRING, AXIS or FRAME; the variables are not defined)"},
        Case{"G0 X1\n$P_PFRAME=CROTS(X,10)",
             "f:2:11: error: \"CROTS\" is not a supported frame [frame-value] (the frame does not change; "
             "write CTRANS, CROT, CSCALE, CMIRROR with axes and values, joined by \":\", or a variable that "
             "holds a frame)"},
        Case{"DEFINE SPEED_UP AS F200 ?5\nG1 X1 F1\n N2 SPEED_UP X5",
             "f:3:5: error: \"?5 X5\" does not start a word or statement [syntax] (the rest of the line is "
             "skipped and the block does not move; correct it)"},
        Case{"DEFINE FAST AS F200\nG1 X1 F1\nFAST ?",
             "f:3:6: error: \"?\" does not start a word or statement [syntax] (the rest of the line is "
             "skipped and the block does not move; correct it)"},
        Case{"G0 X1\nPOS[X]=5 POS[Y]=3",
             "f:2:4: info: positioning axes are shown as a rapid on a straight line [positioning-axis] (each "
             "axis moves at its own speed, set by FA or the machine)"},
        Case{"G0 X1\nY2 POS[X]=5",
             "f:2:7: error: positioning axes in a block with a path motion are not supported "
             "[positioning-axis] (their motion is skipped; position them in a block of their own)"},
        Case{"%_N_MAIN_MPF\nDEF REAL VALS[2]\nG0 X1\nSHAPE(VALS)\nM30\n%_N_SHAPE_SPF\nPROC SHAPE(VAR REAL "
             "ALL[3])\nRET",
             "f:7:24: error: array parameter \"ALL\" has 3 elements, the argument has 2 [definition] (pass "
             "an array of the same type and size)"},
        Case{"DEF REAL VALS[2]\nG0 X1\nVALS[2]=5",
             "f:3:6: error: \"VALS\" has no element 2, its largest index is 1 [array-index] (correct the "
             "index or the size in DEF)"},
        Case{"G0 X1\nDEF INT VALS[0]",
             "f:2:14: error: 0 is not a number of array elements from 1 to 100000 [array-size] (correct the "
             "size)"},
        Case{"G0 X1\nDEFINE HOME",
             "f:2:8: error: DEFINE needs a name, AS and words [macro] (its name is called as a subprogram; "
             "write DEFINE NAME AS G0 X5)"},
        Case{"G0 X1\nPOLY PO[X]=(1,2,3,4,5,6) F100",
             "f:2:23: error: a polynomial has more than 5 coefficients [polynomial] (the block does not "
             "move; write a polynomial of degree 5 or less)"}));

TEST(SinumerikDiagnostics, CurvesAreSaidOnceAndTheirWeightsWhereTheyAreWrong) {
  const ReadProgram program =
      read_sinumerik("G0 X1\nBSPLINE X5 PW=0 F100\nG0 X7\nASPLINE X8 Y1\nX9 Y2\nCSPLINE X10\nX11 Y7");
  ASSERT_GE(program.diagnostics.size(), 2U);
  EXPECT_EQ(format(program.diagnostics[0], "f"),
            "f:2:9: info: a curve is approximated by tangent arcs within 0.001 mm of it [curve-as-arcs]");
  EXPECT_EQ(format(program.diagnostics[1], "f"),
            "f:2:12: error: weight PW=0 is not above zero [spline-weight] (1 is used)");
}

TEST(SinumerikDiagnostics, RotaryAxesUnderOrientationAreSaidOnceEach) {
  const ReadProgram program = read_sinumerik("TRAORI\nG1 X1 A10 C5 F100\nX2 A20 C6\nX3 A30 C0");
  ASSERT_EQ(program.diagnostics.size(), 3U);
  EXPECT_EQ(format(program.diagnostics[1], "f"),
            "f:2:7: warning: axis A moves to 10 in a feed move, which is not simulated [unread-axis] (X, Y "
            "and Z are those of the tool's tip and shown as programmed; the time of this axis is not "
            "included, so the cycle time is too short; reported once)");
  EXPECT_FALSE(has_errors(program.diagnostics));
}

}  // namespace
}  // namespace feedscope

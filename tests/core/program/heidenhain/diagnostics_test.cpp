#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/core/program/heidenhain/read_heidenhain.h"

namespace feedscope {
namespace {

/// One wrong or unread block and what is said of it.
struct DiagnosticCase {
  const char* text;
  const char* said;
};
void PrintTo(const DiagnosticCase& c, std::ostream* out) {
  *out << c.text;
}
class HeidenhainDiagnostic : public testing::TestWithParam<DiagnosticCase> {};

TEST_P(HeidenhainDiagnostic, SaysPlaceThingAndValue) {
  const ReadProgram program = read_heidenhain(GetParam().text);
  std::vector<std::string> said;
  for (const Diagnostic& d : program.diagnostics) {
    said.push_back(fmt::format("{}:{}: {}: {} [{}]", d.line, d.column, to_string(d.severity),
                               d.message.english(), d.code));
    EXPECT_TRUE(!d.hint.empty() || d.severity == Severity::info);
  }
  EXPECT_THAT(said, testing::Contains(GetParam().said));
}

INSTANTIATE_TEST_SUITE_P(
    Path, HeidenhainDiagnostic,
    testing::Values(
        DiagnosticCase{"L X+1 K5 F100\n",
                       "1:7: error: \"K5 F100\" is not a word of this block [unread-word]"},
        DiagnosticCase{"L X F100\n", "1:5: error: \"F100\" is not a number or parameter [malformed-number]"},
        DiagnosticCase{"L X+1..2 F100\n", "1:5: error: \"1..\" has no valid number [malformed-number]"},
        DiagnosticCase{"L X+2000000000 F100\n",
                       "1:5: error: \"2000000000\" is above the largest number, 1000000000 [number-range]"},
        DiagnosticCase{"Q1 = 10 ^ 20\nL X+Q1 FMAX\n",
                       "2:4: error: the parameter's value 1e+20 is beyond the largest number, 1000000000 "
                       "[number-range]"},
        DiagnosticCase{"L X+1 FMAX MX\n", "1:12: error: M without a number [malformed-number]"},
        DiagnosticCase{"L X+1 FMAX M98\n",
                       "1:12: warning: M98 (open contour corners) is not supported [unread-m]"},
        DiagnosticCase{"L X+1 R5 F9\n",
                       "1:3: error: R belongs to another kind of motion than this block [unread-word]"},
        DiagnosticCase{"L X+1 DR+ F9\n",
                       "1:3: error: DR belongs to another kind of motion than this block [unread-word]"},
        DiagnosticCase{
            "L X+1 PA+5 F9\n",
            "1:3: error: PR or PA belongs to another kind of motion than this block [unread-word]"},
        DiagnosticCase{"L X+5 F9\nCC X+0 Y+0\nCP PA+90 PR+7 DR+\n",
                       "3:4: error: PR belongs to another kind of motion than this block [unread-word]"},
        DiagnosticCase{"L X+1 LEN5 F9\n",
                       "1:3: error: LEN belongs to another kind of motion than this block [unread-word]"},
        DiagnosticCase{
            "TOOL DEF 1 R4\nTOOL CALL 1 Z S1\nL X-20 Y-20 FMAX\nAPPR CT X+0 Y+0 CCA90 R-3 RL F9\nL X+9\n",
            "4:1: error: its radius R of -3.000 mm on the other side is not larger than the tool radius, "
            "4.000 mm [approach]"},
        DiagnosticCase{"L X+1 F0\n", "1:7: error: feed F0 is zero or negative [feed-value]"},
        DiagnosticCase{"L X+1 F AUTO\n", "1:7: error: feed F0 is zero or negative [feed-value]"},
        DiagnosticCase{"L X+1\n", "1:3: error: a feed move without a feed [feed-missing]"},
        DiagnosticCase{"L X+1 FT5\n", "1:7: error: FT5 (time of the block) is not supported [unread-word]"},
        DiagnosticCase{"L X+1 RL F9\n", "1:7: error: RL: the radius of the tool is not known [tool-radius]"},
        DiagnosticCase{"L Z-10 FMAX M91\n",
                       "1:3: warning: M91 moves to a machine position, which the program does not contain "
                       "[machine-position]"},
        DiagnosticCase{"L M140 MB MAX\n",
                       "1:3: warning: M140 MB MAX moves to a machine position, which the program does not "
                       "contain [machine-position]"},
        DiagnosticCase{"L A+10 F9\n",
                       "1:3: warning: axis A moves to 10, which is not simulated [unread-axis]"},
        DiagnosticCase{
            "LN X+1 NZ+1 F9\n",
            "1:8: info: surface normals and tool directions (LN) are not supported [unread-vector]"},
        DiagnosticCase{"L X+1 F9 M128 F500\n",
                       "1:10: info: M128 (tool centre point control) is not supported [unread-m]"},
        DiagnosticCase{"C X+1 Y+1 DR+ F9\n", "1:3: error: polar coordinates without a pole [pole]"},
        DiagnosticCase{"CC X+1 Y+0\nC X+2 F9\n", "2:3: error: the arc has no direction [arc-direction]"},
        DiagnosticCase{"L X+1 F9\nCC X+0 Y+0\nCP IPA-90 DR+\n",
                       "3:4: error: an angle of -90.000 degrees is opposite to the direction of the arc "
                       "[arc-direction]"},
        DiagnosticCase{"CR X+1 DR+ F9\n", "1:4: error: the arc has no radius [arc-radius]"},
        DiagnosticCase{"CR X+9 R+4 DR+ F9\n",
                       "1:4: error: radius 4.0000 mm is too small for ends 9.0000 mm apart [arc-radius]"},
        DiagnosticCase{"CC X+4 Y+0\nC X+9 DR+ F9\n",
                       "2:3: error: the arc's radius is 4.0000 mm at its start but 5.0000 "
                       "mm at its end [arc-radius]"},
        DiagnosticCase{
            "CT X+9 F9\n",
            "1:4: error: a tangent arc without a preceding motion in the working plane [tangent-arc]"},
        DiagnosticCase{"L X+9 F9\nCT X+5\n",
                       "2:4: error: the arc would end straight behind its start [tangent-arc]"},
        DiagnosticCase{
            "RND R2\n",
            "1:1: error: the rounding of 2.000 mm: the preceding block is not a contour element [corner]"},
        DiagnosticCase{
            "L X+9 F9\nRND R2\nTOOL CALL 1 Z S1\n",
            "2:1: error: the rounding of 2.000 mm: no contour element follows in the next block [corner]"},
        DiagnosticCase{"L X+9 F9\nRND R2\nCHF 1\nL Y+9\n",
                       "2:1: error: the rounding of 2.000 mm: another rounding or chamfer follows [corner]"},
        DiagnosticCase{"L X+9 F9\nRND R20\nL Y+9\n",
                       "2:1: error: the rounding of 20.000 mm: it does not fit between the adjacent elements "
                       "[corner]"},
        DiagnosticCase{"L X+9 F9\nRND R2\nL X+0\n",
                       "2:1: error: the rounding of 2.000 mm: the path turns back at the corner [corner]"},
        DiagnosticCase{"L X+9 Z+1 F9\nRND R2\nL Y+9\n",
                       "2:1: error: the rounding of 2.000 mm: the adjacent elements leave the working plane "
                       "[corner]"},
        DiagnosticCase{"L X+9 F9\nCHF 1\nCR X+0 Y+9 R+9 DR+\n",
                       "2:1: error: the chamfer of 1.000 mm: it is adjacent to an arc [corner]"},
        DiagnosticCase{"L X+9 F9\nCHF 0\nL Y+9\n", "2:1: error: chamfer 0 mm is zero or negative [corner]"},
        DiagnosticCase{"L X+9 F9\nRND F9\nL Y+9\n", "2:1: error: RND without a radius R [corner]"},
        DiagnosticCase{"APPR XT X+1 F9\n", "1:6: error: \"XT\" is not an approach or departure [approach]"},
        DiagnosticCase{"APPR LT X+1 F9\n", "1:1: error: its length LEN is missing or zero [approach]"},
        DiagnosticCase{"L X+9 F9\nAPPR LT X+1 LEN2\n",
                       "2:1: error: no contour follows the approach [approach]"},
        DiagnosticCase{"L X+9 F9\nAPPR LT X+1 LEN2\nL Z+1\n",
                       "2:1: error: the contour after the approach has no direction in the plane at its "
                       "start [approach]"},
        DiagnosticCase{"L X+9 Y+2 F9\nAPPR LCT X+9 Y+0 R5 R0\nL X+20\n",
                       "2:1: warning: an approach or departure without RL or RR [approach-side]"},
        DiagnosticCase{"DEP LT LEN2 F9\n",
                       "1:1: error: the departure does not follow a contour in the working plane "
                       "[approach]"}));

INSTANTIATE_TEST_SUITE_P(
    Statements, HeidenhainDiagnostic,
    testing::Values(
        DiagnosticCase{"G1 X5\n",
                       "1:1: error: \"G1 X5\" is not a statement of this dialect [unknown-statement]"},
        DiagnosticCase{"FL X+30 Y+10\n", "1:1: error: FL (free contour) is not supported [unread-statement]"},
        DiagnosticCase{"FC DR- R15 CLSD+\n",
                       "1:1: error: FC (free contour) is not supported [unread-statement]"},
        DiagnosticCase{"L X+1 A+10 F9\n",
                       "1:7: error: axis A moves to 10 in a feed move, which is not simulated [unread-axis]"},
        DiagnosticCase{"12 +5\n",
                       "1:4: error: \"+5\" is not a statement of this dialect [unknown-statement]"},
        DiagnosticCase{
            "PLANE PROJECTED PROPR+24 PROMIN+24 ROT+30 STAY\n",
            "1:1: error: PLANE (this form of tilted working plane) is not supported [unread-statement]"},
        DiagnosticCase{"PLANE POINTS P1X+0 P1Y+0 P1Z+0 P2X+1 P2Y+0 P2Z+0 P3X+2 P3Y+0 P3Z+0 STAY\n",
                       "1:1: error: the points of PLANE POINTS are on one line [plane]"},
        DiagnosticCase{"PLANE SPATIAL SPA+90 SPB+0 SPC+0 TURN MB MAX FMAX\n",
                       "1:1: warning: the tool retracts to the end of travel before the axes turn (MB MAX) "
                       "[swivel-retract]"},
        DiagnosticCase{"CYCL DEF 19.1 A+90 C+30\n",
                       "1:1: warning: the plane is tilted by angles of more than one axis [tilt-angles]"},
        DiagnosticCase{"Q1 = Q108\n", "1:6: warning: the tool radius Q108 is not known [unset-parameter]"},
        DiagnosticCase{
            "L X+5 FMAX\nFN 18: SYSREAD Q1 = ID270 NR1 IDX2\n",
            "2:1: warning: FN 18 reads the position of Y before the program has moved it [system-data]"},
        DiagnosticCase{"PLANE SPATIAL SPA+0 SPX+30 STAY\n",
                       "1:21: error: \"SPX+30 STAY\" is not valid in PLANE [unread-word]"},
        DiagnosticCase{"PLANE VECTOR BX+1 BY+0 BZ+0 NX+2 NY+0 NZ+0 STAY\n",
                       "1:1: error: the vectors of PLANE VECTOR do not span a plane [plane]"},
        DiagnosticCase{"CYCL DEF 7.1 X+5\nPLANE SPATIAL SPA+0 SPB+30 SPC+0 STAY\nCYCL DEF 7.1 X+9\n",
                       "3:1: warning: a datum shift replaces one that the plane was tilted about "
                       "[tilted-shift]"},
        DiagnosticCase{"FUNCTION MODE TURN\n",
                       "1:1: error: MODE (another machining mode) is not supported [unread-statement]"},
        DiagnosticCase{"FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS\n",
                       "1:1: info: FUNCTION (function of the machine) is not supported [unread-statement]"},
        DiagnosticCase{
            "L A+Q120 FMAX\n",
            "1:5: info: Q120 is the angle of a rotary axis that the control calculates for a tilted plane "
            "[unset-parameter]"},
        DiagnosticCase{
            "CALL SELECTED PGM\n",
            "1:1: error: \"CALL SELECTED PGM\" is not a statement of this dialect [unknown-statement]"},
        DiagnosticCase{"PATTERN DEF HEX1 (X+1)\n", "1:13: error: \"HEX1 (X+1)\" is not a pattern [pattern]"},
        DiagnosticCase{"PATTERN DEF ROW1 (X+1 Y+1 D+8 NUM0 ROT+0 Z+0)\n",
                       "1:13: error: 0 is not a number of places from 1 to 10000 [pattern]"},
        DiagnosticCase{"PATTERN DEF POS1 (X+1 W+1)\n",
                       "1:23: error: \"W+1)\" is not valid in a pattern [unread-word]"},
        DiagnosticCase{"TOOL CALL 1 Z S100 FZ0.1\n",
                       "1:20: warning: a feed per tooth without the number of teeth, which is in the tool "
                       "table [tooth-count]"},
        DiagnosticCase{"L X+9 Y+5 FMAX\nAPPR LT X+1 Y+0 LEN2 RL F9\nCT X+9 Y+3\n",
                       "3:4: error: a tangent arc without a preceding motion in the working plane "
                       "[tangent-arc]"},
        DiagnosticCase{"BLK FORM 0.1 Z X+0 Y+0 Z-5\nBLK FORM 0.2 X+9 Y+9 Z-5\n",
                       "2:1: warning: the upper corner of the blank is not above the lower one in every axis "
                       "[blank-form]"},
        DiagnosticCase{"TOOL CALL 5 Z S100 K5\n",
                       "1:20: error: \"K5\" is not valid in TOOL CALL [unread-word]"},
        DiagnosticCase{"CALL LBL 5\nL M30\nLBL 5\nL X+1 FMAX\nLBL 0\nLBL 5\n",
                       "6:0: warning: label 5 is defined twice [label]"},
        DiagnosticCase{"CALL LBL 5\n", "1:1: error: label 5 does not exist [label-missing]"},
        DiagnosticCase{"CALL LBL 5 REP 3\n", "1:1: error: label 5 does not exist [label-missing]"},
        DiagnosticCase{"FN 9: IF 1 EQU 1 GOTO LBL \"A\"\n",
                       "1:1: error: label \"A\" does not exist [label-missing]"},
        DiagnosticCase{"LBL 1.5\n", "1:5: error: 1.5 is not a label [label]"},
        DiagnosticCase{"LBL \"A\n", "1:5: error: the name of the label is not closed, or empty [label]"},
        DiagnosticCase{"CALL PGM PART2.H\n",
                       "1:1: error: program \"PART2.H\" was not found in the same folder [subprogram]"},
        DiagnosticCase{"Q1 = Q2\n", "1:6: warning: Q2 has no value [unset-parameter]"},
        DiagnosticCase{"Q1 = 1 / 0\n", "1:8: error: \"/\" has no finite value [expression-value]"},
        DiagnosticCase{"Q1 = ( 1\n", "1:8: error: \")\" is missing here [expression]"},
        DiagnosticCase{"Q1 = 1 2\n", "1:8: error: \"2\" does not belong to the formula [expression]"},
        DiagnosticCase{"Q1 = QS2\n", "1:6: error: QS2 holds a text, not a number [expression]"},
        DiagnosticCase{"Q2000 = 1\n", "1:1: error: parameter \"Q2000\" does not exist [parameter-number]"},
        DiagnosticCase{"Q1 + 5\n", "1:4: error: \"Q1 + 5\" is not an assignment [unread-statement]"},
        DiagnosticCase{"QS1 = 5\n", "1:7: error: \"5\" is not a text [unread-statement]"},
        DiagnosticCase{"FN 4: Q1 = +1 DIV +0\n",
                       "1:1: error: function 4 has no finite value for 1 and 0 [expression-value]"},
        DiagnosticCase{"FN 1: Q1 = +1 / +0\n", "1:15: error: \"/ +0\" is not valid in FN [unread-word]"},
        DiagnosticCase{"FN 14: ERROR = 1000\nL X+1 FMAX\n",
                       "1:1: error: the program stops here with an error (FN 14) [program-error]"},
        DiagnosticCase{"FN 16: F-PRINT TNC:\\A.A / TNC:\\B.TXT\n",
                       "1:1: info: FN 16 is not supported [unread-function]"},
        DiagnosticCase{"FN 28: TABREAD Q1 = 3\n", "1:1: warning: FN 28 is not supported [unread-function]"},
        DiagnosticCase{"FN 18: SYSREAD Q1 = ID20 NR8\n",
                       "1:1: warning: FN 18 reads ID20 NR8 IDX0, which depends on the machine [system-data]"},
        DiagnosticCase{
            "FN 18: SYSREAD Q1 = ID50 NR2 IDX5\n",
            "1:1: warning: FN 18 reads ID50 NR2 IDX5, which depends on the machine [system-data]"}));

INSTANTIATE_TEST_SUITE_P(
    Cycles, HeidenhainDiagnostic,
    testing::Values(
        DiagnosticCase{"CYCL DEF 251 RECTANGULAR POCKET ~\nQ215=0 ;OPERATION\n",
                       "1:1: error: cycle 251 (RECTANGULAR POCKET) is not supported [unread-cycle]"},
        DiagnosticCase{"CYCL DEF 4.0 POCKET MILLING\n",
                       "1:1: error: cycle 4 (POCKET MILLING) is not supported [unread-cycle]"},
        DiagnosticCase{"CYCL CALL\n", "1:1: error: a cycle is called, but none is defined [cycle-call]"},
        DiagnosticCase{"CYCL CALL PAT FMAX\n", "1:1: error: CYCL CALL PAT without PATTERN DEF [cycle-call]"},
        DiagnosticCase{"CYCL DEF 392 ATC Q240=0\n",
                       "1:1: info: cycle 392 (ATC) is not supported [unread-cycle]"},
        DiagnosticCase{
            "CYCL DEF 204 B Q200=1 Q249=-2 Q250=9 Q251=3 Q252=5 Q253=9 Q254=9 Q203=0 Q204=1 Q214=1\n"
            "CYCL CALL\n",
            "2:1: error: cycle 204 is not executed: its depth Q249 is not above zero; write it positive "
            "[cycle-value]"},
        DiagnosticCase{
            "CYCL DEF 204 B Q200=1 Q249=2 Q250=9 Q251=3 Q252=5 Q253=9 Q254=9 Q203=0 Q204=1 Q214=0\n"
            "CYCL CALL\n",
            "2:1: error: cycle 204 is not executed: the direction Q214 in which the tool passes the hole is "
            "not 1 to 4 [cycle-value]"},
        DiagnosticCase{"CYCL DEF 241 D Q200=1 Q201=-20 Q206=9 Q203=0 Q204=1 Q202=5\nCYCL CALL\n",
                       "2:1: error: cycle 241 is not executed: several infeeds (Q202 below its depth) are "
                       "not supported; write Q202=0 for one [cycle-value]"},
        DiagnosticCase{
            "CYCL DEF 200 D Q200=1 Q201=-20 Q206=9 Q202=20 Q203=0 Q204=1 Q395=1\nCYCL CALL\n",
            "2:1: warning: cycle 200: Q395=1 measures the depth to the cylinder of the drill [cycle-value]"},
        DiagnosticCase{
            "CYCL DEF 200 D Q200=1 Q201=-5 Q206=9 Q202=5 Q203=0 Q204=1\nCYCL DEF 220 P Q216=0 Q217=0 "
            "Q244=9 Q245=0 Q246=360 Q247=0 Q241=3 Q365=1\n",
            "2:1: info: cycle 220: Q365=1 goes from place to place on the circle [cycle-value]"},
        DiagnosticCase{"CYCL DEF 220 PATTERN Q241=3\n",
                       "1:1: error: cycle 220 repeats a cycle, but none is defined [cycle-call]"},
        DiagnosticCase{"CYCL DEF 240 CENTERING Q200=1\nCYCL CALL\n",
                       "2:1: error: cycle 240 has no value for Q201 [cycle-parameter]"},
        DiagnosticCase{"CYCL DEF 200 DRILLING Q200=1 X5\n",
                       "1:30: error: \"X5\" is not a parameter [cycle-parameter]"},
        DiagnosticCase{"CYCL DEF 200 DRILLING ~\n Q200=PREDEF ~\n Q201=-5\n",
                       "2:2: error: PREDEF for Q200 without a GLOBAL DEF [cycle-parameter]"},
        DiagnosticCase{"CYCL DEF 200 DRILLING Q206=FZ0.1\n",
                       "1:23: error: this value of Q206 is not supported [cycle-parameter]"},
        DiagnosticCase{"CYCL DEF 240 C Q200=1 Q201=2 Q206=9 Q203=0 Q204=1\nCYCL CALL\n",
                       "2:1: error: cycle 240 is not executed: its depth Q201 is above the surface; write it "
                       "negative [cycle-value]"},
        DiagnosticCase{"CYCL DEF 240 C Q200=1 Q201=-2 Q206=9 Q203=0 Q204=1\nQ201 = 0 - 10 ^ 20\nCYCL CALL\n",
                       "3:1: error: cycle 240: Q201 is -1e+20, beyond the largest number, 1000000000 "
                       "[cycle-parameter]"},
        DiagnosticCase{"CYCL DEF 200 D Q200=1 Q201=-200 Q206=9 Q202=0.001 Q203=0 Q204=1\nCYCL CALL\n",
                       "2:1: error: cycle 200 is not executed: it would take more than 10000 infeeds, or its "
                       "infeeds are negative; check Q202 and the other infeeds [cycle-value]"},
        DiagnosticCase{"CYCL DEF 208 B Q200=1 Q201=-2 Q206=9 Q334=1 Q203=0 Q204=1 Q335=9\nCYCL CALL\n",
                       "2:1: error: cycle 208 is not executed: the radius of the tool is not known; write a "
                       "TOOL DEF with R before the tool call [cycle-value]"},
        DiagnosticCase{"CYCL DEF 207 T Q200=1 Q201=-2 Q239=1 Q203=0 Q204=1\nCYCL CALL\n",
                       "2:1: error: cycle 207 is not executed: it has no pitch or the spindle no speed; "
                       "write S in the tool call [cycle-value]"},
        DiagnosticCase{"CYCL DEF 240 C Q200=1 Q343=1 Q201=-2 Q206=9 Q203=0 Q204=1\nCYCL CALL\n",
                       "2:1: error: cycle 240 is not executed: centring to a diameter needs the tool's point "
                       "angle; write Q343=0 and the depth [cycle-value]"},
        DiagnosticCase{"CYCL DEF 9.1 DWELL -1\n", "1:1: error: dwell time -1 is negative [dwell-time]"},
        DiagnosticCase{"CYCL DEF 32.1 T-0.5\n", "1:1: error: the tolerance T-0.5 is below zero [tolerance]"},
        DiagnosticCase{"CYCL DEF 32.1 T0.0000001\n",
                       "1:1: warning: the tolerance T0.0000001 is below 0.000001 mm [tolerance]"},
        DiagnosticCase{"CYCL DEF 11.1 SCL 0\n",
                       "1:19: error: scaling factor 0 is not from 0.000001 to 99.999999 [scale-factor]"},
        DiagnosticCase{"CYCL DEF 8.1 A\n", "1:14: error: \"A\" is not X, Y or Z [unread-word]"},
        DiagnosticCase{
            "L X+1 FMAX\nCYCL DEF 7.1 #5\n",
            "2:1: warning: a line of the datum table changes the datum after a motion [work-offset]"},
        DiagnosticCase{"L X+1 FMAX\nCYCL DEF 247 DATUM SETTING Q339=2\n",
                       "2:1: warning: cycle 247 changes the datum after a motion [work-offset]"}));

TEST(HeidenhainDiagnostics, RotaryAxesAndPlanesAreSaidOnce) {
  const ReadProgram program = read_heidenhain(
      "L X+1 A+1 FMAX\nL A+2 FMAX\nPLANE PROJECTED PROPR+1\nPLANE PROJECTED PROPR+1\nL A+3 FMAX\n");
  EXPECT_EQ(program.diagnostics.size(), 2U);
}

TEST(HeidenhainDiagnostics, ABlockWithAFaultDoesNotMove) {
  EXPECT_EQ(path_of(read_heidenhain("L X+1 FMAX\nL X+2 Y.. FMAX\nL Z+3 FMAX\n")), "r1,0,0 r1,0,3");
}

TEST(HeidenhainDiagnostics, EndlessLoopsAndCallsEnd) {
  const ReadProgram loop = read_heidenhain("LBL 1\nFN 9: IF 1 EQU 1 GOTO LBL 1\n", {.repeat_limit = 1000});
  EXPECT_THAT(loop.diagnostics, testing::Contains(testing::Field(&Diagnostic::code, "run-limit")));
  const ReadProgram calls = read_heidenhain("LBL 1\nCALL LBL 1\nLBL 0\n");
  EXPECT_THAT(calls.diagnostics, testing::Contains(testing::Field(&Diagnostic::code, "call-depth")));
}

}  // namespace
}  // namespace feedscope

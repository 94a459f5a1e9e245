#include "ui/language/reader_sentences.h"

#include <QtGlobal>
#include <array>

namespace feedscope::ui {

namespace {

constexpr std::array general_patterns{
    // The program as a whole (program/reader, read_program, machining, path_control).
    QT_TRANSLATE_NOOP("core", "cycles and curves have made more than %1 motions"),
    QT_TRANSLATE_NOOP(
        "core",
        "the rest is skipped; check the infeeds of the cycles, or raise the limit with --repeat-limit"),
    QT_TRANSLATE_NOOP("core", "loops and calls have run %1 lines without coming to an end"),
    QT_TRANSLATE_NOOP(
        "core",
        "loops and calls have run %1 lines without coming to an end; before that, %2, line %3: %4 (%5)"),
    QT_TRANSLATE_NOOP(
        "core", "the rest is skipped; check the loop's condition, or raise the limit with --repeat-limit"),
    QT_TRANSLATE_NOOP("core", "the program has no blocks"),
    QT_TRANSLATE_NOOP("core", "give a file with NC blocks such as \"G1 X10 F500\""),
    QT_TRANSLATE_NOOP("core", "no block of the program moves an axis"),
    QT_TRANSLATE_NOOP("core", "if the program has another dialect, give it with --dialect"),
    QT_TRANSLATE_NOOP("core", "the program ends in line %1; the text after it is not executed"),
    QT_TRANSLATE_NOOP("core",
                      "I J K are used as positions: as offsets from the start most arcs do not fit, as "
                      "positions all of them do"),
    QT_TRANSLATE_NOOP("core", "program G90.1 if that is right, G91.1 if not"),
    QT_TRANSLATE_NOOP("core", "this is a program for %1, which is not supported"),
    QT_TRANSLATE_NOOP("core",
                      "it is interpreted as ISO and the path shown may be wrong: %1; give --dialect to "
                      "interpret it as that dialect"),
    QT_TRANSLATE_NOOP(
        "core",
        "G15 H selects a work offset there, G56 H a tool length, VC1 is a variable and CALL a subprogram"),
    QT_TRANSLATE_NOOP("core", "%1 moves to a machine position, which the program does not contain"),
    QT_TRANSLATE_NOOP("core",
                      "neither drawn nor timed unless the machine gives positions (home_z_mm, "
                      "part_zero_z_mm, ...); the path continues where every axis is programmed again"),
    QT_TRANSLATE_NOOP("core", "%1 are all zero: the tool has no direction"),
    QT_TRANSLATE_NOOP("core",
                      "the rotary axes stay; write the vector from the tip to the spindle, such as %1"),
    QT_TRANSLATE_NOOP("core", "I, J and K"),
    QT_TRANSLATE_NOOP("core", "A3, B3 and C3"),
    QT_TRANSLATE_NOOP("core", "TX, TY and TZ"),
    QT_TRANSLATE_NOOP("core", "%1 is below %2 mm"),
    QT_TRANSLATE_NOOP("core", "%1 mm is used, the smallest that is simulated"),
    QT_TRANSLATE_NOOP("core", "tolerance %1 mm of CYCLE832 is below %2 mm"),
    QT_TRANSLATE_NOOP("core", "tolerance %1 of %2 is below %3 mm"),
    QT_TRANSLATE_NOOP("core", "the tolerance T%1 is below %2 mm"),
    // Text, numbers, expressions, calls, units (program/text, program/language).
    QT_TRANSLATE_NOOP("core", "%1 more of this kind up to line %2"),
    QT_TRANSLATE_NOOP("core",
                      "offsets without a value are assumed as zero, so parts of the path overlap; give them "
                      "as an import option, --offset %1=X,Y,Z"),
    QT_TRANSLATE_NOOP("core", "%1 has no valid number"),
    QT_TRANSLATE_NOOP("core", "correct the number"),
    QT_TRANSLATE_NOOP("core", "%1 is above the largest number, 1000000000"),
    QT_TRANSLATE_NOOP("core", "write a smaller number"),
    QT_TRANSLATE_NOOP("core", "%1 has no finite value"),
    QT_TRANSLATE_NOOP("core", "check the values that go into it"),
    QT_TRANSLATE_NOOP("core", "\"%1\" is missing here"),
    QT_TRANSLATE_NOOP("core", "check the brackets of the expression"),
    QT_TRANSLATE_NOOP("core", "the expression is nested more than %1 deep"),
    QT_TRANSLATE_NOOP("core", "split it into several assignments"),
    QT_TRANSLATE_NOOP("core", "a value is missing at the end of the expression"),
    QT_TRANSLATE_NOOP("core", "%1 is not a value, variable or function"),
    QT_TRANSLATE_NOOP("core", "write a number, a variable or a function here"),
    QT_TRANSLATE_NOOP("core", "calls are nested more than %1 deep"),
    QT_TRANSLATE_NOOP("core",
                      "this call is skipped; check whether the subprogram calls itself, or raise the limit "
                      "with --call-depth"),
    QT_TRANSLATE_NOOP("core", "the program does not define its unit; mm is used"),
    QT_TRANSLATE_NOOP("core", "give it as an import option: --unit mm or --unit inch"),
    QT_TRANSLATE_NOOP("core",
                      "%1 x %2 x %3 mm cut at %4 mm/min at most look like inches; give --unit inch, or "
                      "--unit mm if that is right"),
    // Files that cannot be read (program/text/source_text).
    QT_TRANSLATE_NOOP("core", "%1: is larger than 4 GiB; split the program"),
    QT_TRANSLATE_NOOP("core",
                      "%1: is not a text file (%2); give an NC program as ASCII, UTF-8 or Latin-1 text"),
    QT_TRANSLATE_NOOP("core", "it is UTF-16"),
    QT_TRANSLATE_NOOP("core", "it has %1 control characters"),
    QT_TRANSLATE_NOOP("core", "the rest is control characters only"),
    QT_TRANSLATE_NOOP("core", "%1: cannot be read: %2"),
    QT_TRANSLATE_NOOP(
        "core",
        "%1:%2: the line is %3 bytes long, more than the %4 of any NC program; check the file's line ends"),
    QT_TRANSLATE_NOOP("core", "%1: does not exist; check the path"),
    QT_TRANSLATE_NOOP("core", "%1: is a directory; give the NC program inside it"),
    QT_TRANSLATE_NOOP("core", "%1: cannot be opened: %2"),
    // Tools (program/tools).
    QT_TRANSLATE_NOOP("core", "tool table '%1', line %2: %3 is not a number"),
    QT_TRANSLATE_NOOP("core", "tool table '%1', line %2, column %3: %4"),
    QT_TRANSLATE_NOOP("core",
                      "'%1' is not a supported tool table; give lines such as \"T1 D10\" or "
                      "\"$TC_DP6[1,1]=5\", \"G10 L12 P1 R5\", or columns headed T and R"),
    QT_TRANSLATE_NOOP("core",
                      "the table in the program's folder is not used; correct it, or name another one"),
    QT_TRANSLATE_NOOP("core", "cutter radii are those of tool table '%1'"),
    QT_TRANSLATE_NOOP("core",
                      "give it as an import option (--tool %1=RADIUS) or in a tool table, or say that the "
                      "path is already compensated (--wear-only)"),
    QT_TRANSLATE_NOOP("core",
                      "give it as an import option (--tool =RADIUS) or in a tool table, or say that the path "
                      "is already compensated (--wear-only)"),
    QT_TRANSLATE_NOOP("core", "a number is missing"),
    QT_TRANSLATE_NOOP("core", "]= is missing"),
    QT_TRANSLATE_NOOP("core", "%1 is not a letter with a number"),
    // Arcs, corners, compensation, curves (program/path).
    QT_TRANSLATE_NOOP("core", "the %1 of %2 mm: %3"),
    QT_TRANSLATE_NOOP("core", "rounding"),
    QT_TRANSLATE_NOOP("core", "chamfer"),
    QT_TRANSLATE_NOOP("core", "no line or arc follows in the same plane"),
    QT_TRANSLATE_NOOP("core", "the corner stays sharp"),
    QT_TRANSLATE_NOOP("core", "the corner stays sharp; write it between two of them"),
    QT_TRANSLATE_NOOP("core", "the adjacent elements leave the working plane"),
    QT_TRANSLATE_NOOP("core", "it is adjacent to a rapid"),
    QT_TRANSLATE_NOOP("core", "it does not fit between the adjacent elements; %1 mm are used"),
    QT_TRANSLATE_NOOP("core", "the control reduces it too, by its own rule"),
    QT_TRANSLATE_NOOP("core", "the path turns back at the corner"),
    QT_TRANSLATE_NOOP("core", "it does not fit between the adjacent elements"),
    QT_TRANSLATE_NOOP("core", "the corner stays sharp; make it smaller"),
    QT_TRANSLATE_NOOP("core", "it is adjacent to an arc"),
    QT_TRANSLATE_NOOP("core", "the corner stays sharp; a chamfer is supported between two lines"),
    QT_TRANSLATE_NOOP("core", "cutter radius compensation begins on an arc"),
    QT_TRANSLATE_NOOP("core", "a straight line leads to the start of the offset arc; begin it on a line"),
    QT_TRANSLATE_NOOP("core", "cutter radius compensation ends on an arc"),
    QT_TRANSLATE_NOOP("core", "a straight line leads to its end instead; end it on a line"),
    QT_TRANSLATE_NOOP("core", "at this block a tool of radius %1 mm cuts %2 mm into the contour of line %3"),
    QT_TRANSLATE_NOOP("core", "use a smaller tool, or do not begin the contour in an inside corner"),
    QT_TRANSLATE_NOOP("core", "the plane changes while cutter radius compensation is on"),
    QT_TRANSLATE_NOOP("core", "it begins again in the other plane; end it before"),
    QT_TRANSLATE_NOOP("core", "the arc's radius, %1 mm, is smaller than the tool's, %2 mm"),
    QT_TRANSLATE_NOOP(
        "core",
        "a straight line to its end is used instead, which cuts into the contour; use a smaller tool"),
    QT_TRANSLATE_NOOP("core", "a tool of radius %1 mm does not fit between this block and its neighbours"),
    QT_TRANSLATE_NOOP("core", "the path shown cuts into the contour here; use a smaller tool"),
    QT_TRANSLATE_NOOP("core",
                      "the control does not check this before an arc: it runs a line backwards, an arc "
                      "nearly a whole turn, and cuts into the contour; use a smaller tool"),
    QT_TRANSLATE_NOOP("core", "axis %1 turns in feed motions of the tool's tip"),
    QT_TRANSLATE_NOOP("core", "its limits hold along each block and where blocks meet"),
    QT_TRANSLATE_NOOP("core",
                      "axis %1 turns in a feed motion of X, Y and Z without tool centre point control"),
    QT_TRANSLATE_NOOP("core",
                      "X, Y and Z are shown as programmed, not as the tool moves on the part; the limits of "
                      "the axis hold along each block"),
    QT_TRANSLATE_NOOP("core", "axis %1 turns by %2 degrees, from %3 to %4"),
    QT_TRANSLATE_NOOP(
        "core",
        "a control whose axis takes the shortest way turns less; its time is that of the way as written"),
    QT_TRANSLATE_NOOP("core", "the tool's direction and axis %1 are given in one block"),
    QT_TRANSLATE_NOOP("core", "the direction is used; remove one of them"),
    QT_TRANSLATE_NOOP("core", "tool orientation"),
    QT_TRANSLATE_NOOP("core", "tool vectors turn the rotary axes"),
    QT_TRANSLATE_NOOP(
        "core",
        "the tool goes along a great circle in each block, to the position that it leads to; rounded "
        "where blocks meet"),
    QT_TRANSLATE_NOOP(
        "core",
        "to the nearer of two positions, the axes linearly along each block; rounded where blocks meet"),
    QT_TRANSLATE_NOOP("core", "X, Y and Z are those of the tool's tip and shown as programmed"),
    QT_TRANSLATE_NOOP("core", "X, Y and Z are shown as programmed"),
    QT_TRANSLATE_NOOP("core", "axis %1 moves to %2, which is not simulated"),
    QT_TRANSLATE_NOOP("core", "axis %1 moves to %2 in a feed move, which is not simulated"),
    QT_TRANSLATE_NOOP("core", "tool orientation moves to %1, which is not simulated"),
    QT_TRANSLATE_NOOP("core", "tool orientation moves to %1 in a feed move, which is not simulated"),
    QT_TRANSLATE_NOOP(
        "core", "%1; the time of this axis is not included, so the cycle time is too short; reported once"),
    QT_TRANSLATE_NOOP("core", "a rounding or chamfer of a non-uniformly scaled contour is not supported"),
    QT_TRANSLATE_NOOP("core", "the arc is scaled non-uniformly and becomes an ellipse"),
    QT_TRANSLATE_NOOP("core", "it is approximated by lines within 0.001 mm"),
    QT_TRANSLATE_NOOP("core", "a feed move while the position of %1 is not known"),
    QT_TRANSLATE_NOOP(
        "core", "the axis is assumed where it was before the move to the machine position; program it first"),
    QT_TRANSLATE_NOOP("core", "a curve is approximated by tangent arcs within 0.001 mm of it"),
    QT_TRANSLATE_NOOP(
        "core",
        "a curve under cutter compensation or at a rounded corner is approximated by lines within 0.001 mm"),
    QT_TRANSLATE_NOOP("core", "the program has more than 65536 different path control settings"),
    QT_TRANSLATE_NOOP("core", "the last one stays in force; split the program"),
    QT_TRANSLATE_NOOP("core", "the arc's centre is its start point"),
    QT_TRANSLATE_NOOP("core", "a straight line to its end is used instead"),
    QT_TRANSLATE_NOOP("core", "the centre would fit as %1"),
    QT_TRANSLATE_NOOP("core", "an offset (G91.1)"),
    QT_TRANSLATE_NOOP("core", "a position (G90.1)"),
    QT_TRANSLATE_NOOP("core", "check the centre"),
    QT_TRANSLATE_NOOP("core", "the centre would fit as %1; a straight line to its end is used instead"),
    QT_TRANSLATE_NOOP("core", "the arc's radius is %1 mm at its start but %2 mm at its end"),
    QT_TRANSLATE_NOOP("core", "radius %1 mm is too small for ends %2 mm apart"),
    QT_TRANSLATE_NOOP("core", "the radius must be at least half the distance; %1"),
    QT_TRANSLATE_NOOP("core", "an arc given by its radius must not end where it starts"),
    QT_TRANSLATE_NOOP("core", "write a full circle with its centre"),
    QT_TRANSLATE_NOOP("core", "a feed per revolution without a spindle speed"),
    QT_TRANSLATE_NOOP("core", "a feed move without a feed"),
    QT_TRANSLATE_NOOP("core", "it runs as fast as the axes allow; write S before it"),
    QT_TRANSLATE_NOOP("core", "it runs as fast as the axes allow; write F before it"),
    QT_TRANSLATE_NOOP("core", "the program has more than 65535 different spindle speeds"),
    QT_TRANSLATE_NOOP("core", "motions with further ones have no spindle speed and no cutting load"),
    // Short lines (analysis/chord_error) and loops cut off (analysis/run).
    QT_TRANSLATE_NOOP("core",
                      "short lines lie about %1 mm from the curve that they stand for: chord error, "
                      "estimated from %2 lines"),
    QT_TRANSLATE_NOOP(
        "core", "Heidenhain advises a contour tolerance of 110 to 200 % of the chord error: %1 to %2 mm"),
    QT_TRANSLATE_NOOP("core",
                      "%1, line %2: %3; the program is not simulated: check its loops, raise the limit "
                      "(--repeat-limit), or simulate the part that was read (--simulate-cut-off)"),
    // Motions beyond any machine (analysis/beyond_machines).
    QT_TRANSLATE_NOOP("core", "a motion of %1 km is longer than any machine makes"),
    QT_TRANSLATE_NOOP("core", "%1 goes to %2 km, beyond the travel of any machine"),
    QT_TRANSLATE_NOOP("core", "%1 days pass up to this line, which runs at F%2 mm/min: more than a year"),
    QT_TRANSLATE_NOOP("core", "%1 days pass up to this line, which waits for %2 of them: more than a year"),
    QT_TRANSLATE_NOOP("core", "a rotary axis goes to %1 degrees, beyond what any machine turns"),
    QT_TRANSLATE_NOOP("core",
                      "the program is not simulated; check the number, its decimal point and the unit"),
    QT_TRANSLATE_NOOP(
        "core",
        "%1, line %2: %3; the program is not simulated; check the number, its decimal point and the unit"),
    // Rotary axes of the machine (toolpath/rotary_*).
    QT_TRANSLATE_NOOP("core",
                      "how X, Y and Z follow the rotary axes is not known without tool length and part zero"),
    QT_TRANSLATE_NOOP("core",
                      "where rotary axes turn, their own limits hold and those of X, Y and Z as without "
                      "them; give tool_length_mm and part_zero_x_mm, _y_mm, _z_mm"),
    QT_TRANSLATE_NOOP("core", "two positions of the rotary axes give the tool vector and are equally near"),
    QT_TRANSLATE_NOOP("core", "one of them is used; a control may choose the other"),
    QT_TRANSLATE_NOOP("core", "axis %1 turns by %2 degrees within one block for a tool vector"),
    QT_TRANSLATE_NOOP(
        "core",
        "a control may stop, limit the turn or go another way; near the singular position smaller steps of "
        "the tool vector, or a part that is clamped at a tilt, make it turn less"),
    QT_TRANSLATE_NOOP("core",
                      "axis %1 holds the feed at %2 of %3 mm/min near its singular position: the tool is %4 "
                      "degrees from its axis"),
    QT_TRANSLATE_NOOP("core",
                      "lines %1 to %2, one of %3 such places; tilting the part by some degrees in the "
                      "clamping takes the path away from it"),
    QT_TRANSLATE_NOOP(
        "core", "the part stays as programmed: the program sends the rotary axes of one machine to angles"),
    QT_TRANSLATE_NOOP("core",
                      "part_angle_x_deg, _y_deg and _z_deg turn the part under programs with tool vectors, "
                      "tilted planes or tool centre point control; post this one again"),
    QT_TRANSLATE_NOOP("core", "axis %1 goes to %2 degrees, beyond its travel from %3 to %4"),
    QT_TRANSLATE_NOOP("core", "the time of the whole way is counted; a control refuses the block"),
    QT_TRANSLATE_NOOP("core",
                      "no position of the rotary axes of machine '%1' gives the tool the direction %2, %3, "
                      "%4 of the tool vector"),
    QT_TRANSLATE_NOOP("core",
                      "no position of the rotary axes of machine '%1' gives the tool the direction %2, %3, "
                      "%4 of the tilted plane"),
    QT_TRANSLATE_NOOP("core",
                      "no position of the rotary axes of machine '%1' gives the tool the direction %2, %3, "
                      "%4 of the tool vector in the part as it is turned"),
    QT_TRANSLATE_NOOP("core",
                      "no position of the rotary axes of machine '%1' gives the tool the direction %2, %3, "
                      "%4 of the tilted plane in the part as it is turned"),
    QT_TRANSLATE_NOOP("core", "the rotary axes stay; tilt less, or choose another machine"),
    QT_TRANSLATE_NOOP("core",
                      "no position of the rotary axes with %1 of axis %2 gives the tool the direction of the "
                      "tilted plane within its travel"),
    QT_TRANSLATE_NOOP("core", "a positive angle"),
    QT_TRANSLATE_NOOP("core", "a negative angle"),
    QT_TRANSLATE_NOOP("core", "the other position is used; ask for the other side"),
};

}  // namespace

std::span<const char* const> general_sentences() {
  return general_patterns;
}

}  // namespace feedscope::ui

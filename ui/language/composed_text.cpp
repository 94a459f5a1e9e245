#include "ui/language/composed_text.h"

#include <QCoreApplication>
#include <QHash>
#include <QLocale>
#include <QRegularExpression>
#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "ui/language/core_texts.h"
#include "ui/language/language.h"
#include "ui/language/reader_sentences.h"
#include "ui/language/text_pattern.h"

namespace feedscope::ui {

namespace {

/// Patterns of the core's fmt::format() texts, a place for each part, in addition to those of the readers.
/// Their places may contain names and texts without a pattern.
constexpr std::array sentences{
    QT_TRANSLATE_NOOP("core", "motion of %1"),
    // Unit of a program (program/program_unit).
    QT_TRANSLATE_NOOP("core", "%1, by the program"),
    QT_TRANSLATE_NOOP("core", "%1, by --unit"),
    QT_TRANSLATE_NOOP("core", "%1, assumed: the program does not define its unit"),
    // Notes on a run (analysis/run_notes).
    QT_TRANSLATE_NOOP("core",
                      "The program is written for %1, but %2 has a %3: path and times are those of "
                      "that control. No published machine has a %4 control; use your own machine file."),
    QT_TRANSLATE_NOOP("core",
                      "The program is written for %1, but %2 has a %3: path and times are those of "
                      "that control. Use machine %4, whose control reads it."),
    QT_TRANSLATE_NOOP("core", "The program was read with work offsets other than those of the machine (%1)."),
    QT_TRANSLATE_NOOP("core",
                      "The contour tolerance of %1 mm is %2 % of the estimated chord error of the "
                      "short lines (%3 mm); Heidenhain advises 110 to 200 %."),
    QT_TRANSLATE_NOOP("core",
                      "The drive of axis %1 is poorly damped: it overshoots a step by %2 %; a smaller "
                      "%3 or %4 damps it better."),
    QT_TRANSLATE_NOOP(
        "core",
        "Line %1 asks for a feed of %2 mm/min; all axes of this machine together reach %3 mm/min: "
        "what is lost against the programmed feed tells little there."),
    QT_TRANSLATE_NOOP("core", "No drive is given for %1: followed exactly."),
    QT_TRANSLATE_NOOP("core",
                      "%1 limits %2 s of the cycle time (%3 %), but the recordings that the machine was "
                      "identified from do not determine it."),
    QT_TRANSLATE_NOOP("core", "1 line of the program is refused by the control and not run (line %1)."),
    QT_TRANSLATE_NOOP("core", "%1 lines of the program are refused by the control and not run (lines %2)."),
    QT_TRANSLATE_NOOP("core", "Rotary axes: line %1: %2."),
    QT_TRANSLATE_NOOP("core", "Rotary axes: line %1: %2. %3 more."),
    QT_TRANSLATE_NOOP("core", "Positions of rotary axes that the machine does not reach: line %1: %2."),
    QT_TRANSLATE_NOOP("core",
                      "Positions of rotary axes that the machine does not reach: line %1: %2. %3 more."),
    // Circles of the program (analysis/circularity).
    QT_TRANSLATE_NOOP("core",
                      "The program has no full circle: no cut runs a whole turn in XY, ZX or YZ by "
                      "arcs about one centre. Circles of short lines are not recognised."),
    QT_TRANSLATE_NOOP("core", "The program has %1 full circles; the first %2 are evaluated."),
    QT_TRANSLATE_NOOP("core", "Not evaluated: 1 helix with full turns."),
    QT_TRANSLATE_NOOP("core", "Not evaluated: %1 helices with full turns."),
    QT_TRANSLATE_NOOP("core", "Not evaluated: 1 full circle outside the planes XY, ZX and YZ."),
    QT_TRANSLATE_NOOP("core", "Not evaluated: %1 full circles outside the planes XY, ZX and YZ."),
    // A trace on its program (analysis/agreement/trace_remarks).
    QT_TRANSLATE_NOOP("core",
                      "the trace does not belong to this program: %1 % of its way runs along the path, and "
                      "along %2 % of it"),
    QT_TRANSLATE_NOOP("core",
                      "open the program that was recorded, or give the zero point it ran with; times and "
                      "feeds of the two tell nothing together"),
    QT_TRANSLATE_NOOP("core", "as it is, the trace is nowhere on this program: %1; %2"),
    QT_TRANSLATE_NOOP("core",
                      "the trace fits this program with its axes in another order: its %1 as X, its %2 as Y, "
                      "its %3 as Z"),
    QT_TRANSLATE_NOOP(
        "core", "name the columns in this order; for X and Y exchanged, as --columns time=1,x=3,y=2,z=4"),
    QT_TRANSLATE_NOOP("core", "the trace has the shape of this program, %1 times as large"),
    QT_TRANSLATE_NOOP("core", "give each of its axes the unit, as --columns time=1,x=2:%1,y=3:%2,z=4:%3"),
    QT_TRANSLATE_NOOP("core", "the trace fits this program with %1 in the other direction"),
    QT_TRANSLATE_NOOP("core", "give its column a minus sign, as --columns time=1,x=2:-mm"),
    QT_TRANSLATE_NOOP("core", "the trace runs along the path of this program from its end to its start"),
    QT_TRANSLATE_NOOP("core",
                      "simulate the program that was recorded, with its blocks in the order that the control "
                      "ran them in"),
    QT_TRANSLATE_NOOP("core", "the trace does not move"),
    QT_TRANSLATE_NOOP("core", "record while the program runs, and check the columns of the positions"),
    QT_TRANSLATE_NOOP("core", "the trace is in inches; it is used as 25.4 times what it says"),
    QT_TRANSLATE_NOOP("core", "give its columns the unit, as --columns x=2:in, where that is right"),
    QT_TRANSLATE_NOOP("core",
                      "the trace is 25.4 times as large as the program; it is used as that part of it"),
    QT_TRANSLATE_NOOP("core",
                      "its positions are in mm, not in inches: say so, as --columns x=2:mm, where that is "
                      "right"),
    QT_TRANSLATE_NOOP("core", "axis %1 of the trace is mirrored; it is used with the other sign"),
    QT_TRANSLATE_NOOP("core", "give its column a minus sign, as --columns x=2:-mm, where that is right"),
    QT_TRANSLATE_NOOP("core", "axis %1 does not move in the trace, but by %2 mm in the program"),
    QT_TRANSLATE_NOOP("core",
                      "if it was not recorded, name the columns of the others alone, as --columns "
                      "time=1,x=2: times and the motion of these axes can be compared then"),
    QT_TRANSLATE_NOOP("core",
                      "the trace does not have %1, which the program moves: feeds, corners and distances "
                      "are those of %2 alone"),
    QT_TRANSLATE_NOOP("core",
                      "times and limits of the axes that are there can be told; record X, Y and Z for the "
                      "others"),
    QT_TRANSLATE_NOOP("core",
                      "the trace is farther than %1 mm from the path of the program for %2 s in %3 "
                      "stretches, the longest from %4 s on at %5"),
    QT_TRANSLATE_NOOP("core",
                      "the trace is farther than %1 mm from the path of the program for %2 s from %3 s on at "
                      "%4"),
    QT_TRANSLATE_NOOP("core",
                      "they are marked and their feeds not compared; the control did there what the "
                      "program does not say"),
    QT_TRANSLATE_NOOP("core",
                      "nothing was recorded for %1 s in %2 stretches, the longest from %3 s on at %4"),
    QT_TRANSLATE_NOOP("core", "nothing was recorded for %1 s from %2 s on at %3"),
    QT_TRANSLATE_NOOP("core",
                      "the trace stands still for %1 s from %2 s on at line %3, where the program does not"),
    QT_TRANSLATE_NOOP("core", "the trace stands still in %1 more places, for %2 s in all"),
    QT_TRANSLATE_NOOP("core",
                      "its times are in milliseconds: give their column the unit, as --columns time=1:ms"),
    QT_TRANSLATE_NOOP("core",
                      "where the simulation runs at the programmed feed, the trace runs at %1 % of it"),
    QT_TRANSLATE_NOOP(
        "core",
        "a feed override, or times of another rate: set the feed override of the simulation to it, or "
        "give the right rate; else limits that are found from the trace are those of the override"),
    QT_TRANSLATE_NOOP("core",
                      "the trace runs at %1 % of the programmed feed: its sampling rate is wrong, or a feed "
                      "override was set"),
    QT_TRANSLATE_NOOP(
        "core",
        "give the right rate, at most %1 samples a second, as --columns linuxcnc,rate=%2; or set the feed "
        "override of the simulation"),
    QT_TRANSLATE_NOOP(
        "core",
        "the trace runs at %1 % of the simulated feed at even speed and where the machine speeds "
        "up or slows down: its sampling rate is wrong"),
    QT_TRANSLATE_NOOP(
        "core",
        "the trace stands still for %1 % of the time of the dwells of the program: its sampling "
        "rate is wrong"),
    QT_TRANSLATE_NOOP(
        "core",
        "give the right rate or unit of its times; else limits that are found from the trace are wrong"),
    QT_TRANSLATE_NOOP(
        "core",
        "give the right rate, %1 samples a second, as --columns linuxcnc,rate=%2; else limits that are "
        "found from the trace are wrong"),
    QT_TRANSLATE_NOOP("core",
                      "a feed hold, or a stop that the simulation does not know; half a second before it and "
                      "behind it is not "
                      "compared, and its time not counted"),
    QT_TRANSLATE_NOOP("core",
                      "a feed hold, or a stop that the simulation does not know; its time is in that of the "
                      "trace"),
    QT_TRANSLATE_NOOP("core", "the time of the whole is right; feeds, ramps and corners there are not known"),
    QT_TRANSLATE_NOOP("core", "the trace covers %1 % of the path of the program, %2; only that is compared"),
    QT_TRANSLATE_NOOP("core",
                      "feeds, ramps and corners there can be compared and limits be told; the cycle time is "
                      "not known"),
    QT_TRANSLATE_NOOP("core",
                      "the program lines of the trace are not those of this program; it is matched by "
                      "position alone"),
    QT_TRANSLATE_NOOP("core", "record the line of the file, or number its blocks"),
    QT_TRANSLATE_NOOP("core", "the trace holds %1 passes through the program; the first is compared"),
    QT_TRANSLATE_NOOP("core",
                      "the trace is nowhere within %1 mm of the path of the program; it is of another "
                      "program, or its zero point is another"),
    QT_TRANSLATE_NOOP("core",
                      "the run does not follow the path of the program within the tolerance of the "
                      "comparison"),
    QT_TRANSLATE_NOOP("core", "trace and run have no part of the path in common"),
    // Recordings that cannot be fitted (identification/trace_case, section_case, section_times).
    QT_TRANSLATE_NOOP(
        "core",
        "%1: the trace does not belong to its program: %2 % of its way runs along the path within "
        "%3 mm, and along %4 % of it; give the program that was recorded, with the zero point it "
        "ran with"),
    QT_TRANSLATE_NOOP("core", "%1: the trace holds too little of its program to find anything from it"),
    QT_TRANSLATE_NOOP("core", "%1: no limits can be found from this trace: %2; %3"),
    QT_TRANSLATE_NOOP("core",
                      "%1:%2: not a table of section times; the first row must have the titles, such as "
                      "section,seconds"),
    QT_TRANSLATE_NOOP(
        "core",
        "%1:%2: '%3' is not a section and its time; a row is like 12,1.234, with a time above 0 and "
        "below %4 s"),
    QT_TRANSLATE_NOOP("core", "%1: section times given: %2; at least %3 can tell something"),
    QT_TRANSLATE_NOOP("core", "%1:%2: section %3 has a time in line %4 already; keep one of the two"),
    QT_TRANSLATE_NOOP("core", "%1: the sections take %2 times what machine '%3' takes in the simulation; %4"),
    QT_TRANSLATE_NOOP(
        "core",
        "%1:%2: %3 has no section '%4'; a section is marked by the comments SECTION 12 BEGINS and "
        "SECTION 12 ENDS, or is given by its lines, as 40-55"),
    // Reading a trace (trace/trace_builder, trace/table_columns).
    QT_TRANSLATE_NOOP("core", "the time goes back from %1 s to %2 s"),
    QT_TRANSLATE_NOOP("core", "only the longest part between two such places is used"),
    QT_TRANSLATE_NOOP("core", "the time goes back %1 times; the longest part with %2 of %3 samples is used"),
    QT_TRANSLATE_NOOP("core", "the time goes back once; the longest part with %1 of %2 samples is used"),
    QT_TRANSLATE_NOOP("core", "record one run in one trace"),
    QT_TRANSLATE_NOOP("core", "%1 positions that are missing for long are those before them"),
    QT_TRANSLATE_NOOP("core", "recorders that write changes alone leave them out"),
    QT_TRANSLATE_NOOP("core", "the sample at %1 s lies %2 mm beside those before and behind it"),
    QT_TRANSLATE_NOOP("core", "it is not compared; the others are right"),
    QT_TRANSLATE_NOOP("core", "the position jumps by %1 mm within %2 ms at %3 s"),
    QT_TRANSLATE_NOOP("core",
                      "samples are missing there without a gap in the times: all later times, and the cycle "
                      "time, are too short by an unknown time"),
    QT_TRANSLATE_NOOP("core", "%1 more jumps of the position"),
    QT_TRANSLATE_NOOP("core", "check how the trace was recorded"),
    QT_TRANSLATE_NOOP("core", "%1 missing positions are interpolated between their neighbours"),
    QT_TRANSLATE_NOOP("core", "signals recorded at one rate need none"),
    QT_TRANSLATE_NOOP("core", "%1 ms without a sample at %2 s"),
    QT_TRANSLATE_NOOP("core", "what happened there is not known; ramps and corners there tell nothing"),
    QT_TRANSLATE_NOOP("core", "%1 more stretches without samples, %2 s in all"),
    QT_TRANSLATE_NOOP("core", "record less signals, or at a lower rate"),
    QT_TRANSLATE_NOOP("core", "samples are %1 ms apart, give or take %2 ms"),
    QT_TRANSLATE_NOOP("core", "times are used as they stand"),
    QT_TRANSLATE_NOOP("core",
                      "one sample each %1 ms: ramps and corners that last less than %2 ms cannot be told "
                      "apart"),
    QT_TRANSLATE_NOOP("core", "record at 1 to 4 ms; times and velocities of long moves are right as it is"),
    QT_TRANSLATE_NOOP("core", "a row without numbers is skipped, the first is '%1'"),
    QT_TRANSLATE_NOOP("core", "%1 rows without numbers are skipped, the first is '%2'"),
    QT_TRANSLATE_NOOP("core", "remove rows that are not data, or check the columns"),
    QT_TRANSLATE_NOOP("core", "%1 samples at the time of the one before are skipped"),
    QT_TRANSLATE_NOOP("core", "record the time with more digits"),
    QT_TRANSLATE_NOOP("core", "%1 samples with a time a little before that of the sample ahead are skipped"),
    QT_TRANSLATE_NOOP("core",
                      "the times jitter by more than a period: record the time of the control's cycle"),
    QT_TRANSLATE_NOOP("core", "the table has no head: what its columns are is judged by their values"),
    QT_TRANSLATE_NOOP("core", "say what they are: --columns time=1:s,x=2:mm,y=3:mm,z=4:mm"),
    QT_TRANSLATE_NOOP("core", "the time has no unit and rises by %1 a sample: milliseconds are assumed"),
    QT_TRANSLATE_NOOP("core", "say it: --columns time=%1:ms"),
    QT_TRANSLATE_NOOP("core", "the trace has no times: one sample each millisecond is assumed"),
    QT_TRANSLATE_NOOP(
        "core",
        "say the rate in samples a second, as --columns linuxcnc,rate=1000; or give the machine "
        "its servo period"),
    QT_TRANSLATE_NOOP("core",
                      "the trace has no times: one sample each %1 ms is taken from the servo period of the "
                      "machine"),
    QT_TRANSLATE_NOOP(
        "core",
        "if it was recorded at another rate, say it in samples a second, as --columns linuxcnc,rate=1000"),
    QT_TRANSLATE_NOOP("core", "traces of this kind have times of their own: the rate is not used"),
    QT_TRANSLATE_NOOP("core", "leave out rate= and period="),
    QT_TRANSLATE_NOOP(
        "core",
        "the positions of the trace move at %1 % of the feed that it records: its sampling rate "
        "is wrong"),
    QT_TRANSLATE_NOOP("core",
                      "give the right rate, %1 samples a second, as --columns linuxcnc,rate=%2; or leave the "
                      "column of the feed "
                      "out"),
    QT_TRANSLATE_NOOP("core", "the trace has no set positions of %1: the actual ones are used instead"),
    QT_TRANSLATE_NOOP(
        "core",
        "feeds, ramps and corners contain what the drives do; record the set positions too to tell them "
        "apart"),
    QT_TRANSLATE_NOOP("core", "the XML ends early: %1"),
    QT_TRANSLATE_NOOP("core", "the records before it are used"),
};

/// Patterns whose places contain only numbers and texts with a pattern.
constexpr std::array clauses{
    // Items that are not in the cycle time (analysis/not_counted).
    QT_TRANSLATE_NOOP("core", "%1 tool change"),
    QT_TRANSLATE_NOOP("core", "%1 tool changes"),
    QT_TRANSLATE_NOOP("core", "%1 spindle start"),
    QT_TRANSLATE_NOOP("core", "%1 spindle starts"),
    QT_TRANSLATE_NOOP("core", "%1 program stop (M0, M1)"),
    QT_TRANSLATE_NOOP("core", "%1 program stops (M0, M1)"),
    QT_TRANSLATE_NOOP("core", "%1 move to or from a machine position"),
    QT_TRANSLATE_NOOP("core", "%1 moves to or from machine positions"),
    QT_TRANSLATE_NOOP("core", "%1 turn of rotary axes for a tilted plane"),
    QT_TRANSLATE_NOOP("core", "%1 turns of rotary axes for tilted planes"),
    QT_TRANSLATE_NOOP("core",
                      "%1 possible delay by X, Y and Z that follow rotary axes (tool length or part zero "
                      "unknown)"),
    QT_TRANSLATE_NOOP("core",
                      "%1 possible delays by X, Y and Z that follow rotary axes (tool length or part zero "
                      "unknown)"),
    // Path control (program/path_control); names of units.
    QT_TRANSLATE_NOOP("core", "exact stops"),
    QT_TRANSLATE_NOOP("core", "exact stops (%1)"),
    QT_TRANSLATE_NOOP("core", "continuous"),
    QT_TRANSLATE_NOOP("core", "contour tolerance %1 mm"),
    QT_TRANSLATE_NOOP("core", "blends from %1 mm before the corner"),
    QT_TRANSLATE_NOOP("core", "orientation tolerance %1 deg"),
    QT_TRANSLATE_NOOP("core", "compaction tolerance %1 mm"),
    QT_TRANSLATE_NOOP("core", "compaction on"),
    QT_TRANSLATE_NOOP("core", "compaction off"),
    QT_TRANSLATE_NOOP("core", "smooth curves on"),
    QT_TRANSLATE_NOOP("core", "smooth curves off"),
    QT_TRANSLATE_NOOP("core", "feed forward on"),
    QT_TRANSLATE_NOOP("core", "feed forward off"),
    QT_TRANSLATE_NOOP("core", "look-ahead on"),
    QT_TRANSLATE_NOOP("core", "look-ahead off"),
    QT_TRANSLATE_NOOP("core", "jerk limited"),
    QT_TRANSLATE_NOOP("core", "acceleration in steps"),
    QT_TRANSLATE_NOOP("core", "acceleration falling with speed"),
    QT_TRANSLATE_NOOP("core", "as the machine"),
    QT_TRANSLATE_NOOP("core", "fine"),
    QT_TRANSLATE_NOOP("core", "coarse"),
    QT_TRANSLATE_NOOP("core", "interpolation end"),
    QT_TRANSLATE_NOOP("core", "inch"),
    // Messages of the reader (base/diagnostic).
    QT_TRANSLATE_NOOP("core", "error"),
    QT_TRANSLATE_NOOP("core", "warning"),
    QT_TRANSLATE_NOOP("core", "info"),
    QT_TRANSLATE_NOOP("core", "line %1"),
    QT_TRANSLATE_NOOP("core", "lines %1 to %2"),
    QT_TRANSLATE_NOOP("core", "also in line %1"),
    QT_TRANSLATE_NOOP("core", "also in lines %1 and %2"),
    QT_TRANSLATE_NOOP("core", "%1 more up to line %2"),
    QT_TRANSLATE_NOOP("core", "%1 more"),
    // Guarantees of a control model (models/guarantees).
    QT_TRANSLATE_NOOP("core",
                      "The source covers lines and their corners; arcs and helices follow the shared rules."),
    QT_TRANSLATE_NOOP("core", "The source covers arcs; lines follow the shared rules."),
    QT_TRANSLATE_NOOP("core",
                      "The programmed path is followed by straight blocks, arcs by chords within the "
                      "arc tolerance; no corner is blended. Ends of blocks are rounded to whole steps "
                      "of the axes."),
    QT_TRANSLATE_NOOP(
        "core", "The programmed path is followed by straight blocks, arcs by chords; no corner is blended."),
    QT_TRANSLATE_NOOP("core", "The programmed path is followed exactly; no corner is blended."),
    QT_TRANSLATE_NOOP("core", "The distance of programmed corners from the path is not bounded."),
    QT_TRANSLATE_NOOP("core",
                      "The distance of programmed corners from the path is not bounded; tangent "
                      "transitions between blocks are passed exactly."),
    QT_TRANSLATE_NOOP("core", "Every programmed corner lies within the contour tolerance of the path."),
    QT_TRANSLATE_NOOP("core",
                      "Every programmed corner lies within the contour tolerance of the path; tangent "
                      "transitions between blocks are passed exactly."),
    QT_TRANSLATE_NOOP("core",
                      "Every programmed corner lies within %1 times the contour tolerance of the path."),
    QT_TRANSLATE_NOOP("core",
                      "Every programmed corner lies within %1 times the contour tolerance of the path; "
                      "tangent transitions between blocks are passed exactly."),
    QT_TRANSLATE_NOOP("core",
                      "The programmed feed is kept along every block; where two blocks overlap their "
                      "speeds add."),
    QT_TRANSLATE_NOOP("core",
                      "The programmed feed is met to whole steps and counts of a timer; very slow "
                      "feeds are exceeded."),
    QT_TRANSLATE_NOOP("core", "Never faster than %1; rapids run at the maximum velocity of the control."),
    QT_TRANSLATE_NOOP("core", "Never faster than %1; rapids never faster than the axes allow."),
    QT_TRANSLATE_NOOP("core", "Never faster than %1 times %2."),
    QT_TRANSLATE_NOOP("core", "the largest programmed feed between two standstills"),
    QT_TRANSLATE_NOOP("core", "the programmed feed"),
    QT_TRANSLATE_NOOP("core", "On lines: %1."),
    QT_TRANSLATE_NOOP("core", "On arcs: %1."),
    QT_TRANSLATE_NOOP("core", "On corner blends: %1."),
    QT_TRANSLATE_NOOP("core", "On smooth curves: %1."),
    QT_TRANSLATE_NOOP("core",
                      "%1 of every axis: along and across the path it stays within %2 each, together "
                      "within %3 times the limit"),
    QT_TRANSLATE_NOOP("core",
                      "%1 of every axis: along the path the change of the acceleration (v'') and the "
                      "part due to curvature (v^3 k^2) each stay within %2, together within %3 times "
                      "the limit"),
    QT_TRANSLATE_NOOP("core", "across the path (3 v v' k) it is not bounded"),
    QT_TRANSLATE_NOOP("core", "the limit"),
    QT_TRANSLATE_NOOP("core", "%1 times the limit"),
    QT_TRANSLATE_NOOP("core", "%1 of every axis are kept"),
    QT_TRANSLATE_NOOP("core", "%1 of every axis is kept"),
    QT_TRANSLATE_NOOP("core", "%1 of every axis stay within %2 times the limit"),
    QT_TRANSLATE_NOOP("core", "%1 of every axis stays within %2 times the limit"),
    QT_TRANSLATE_NOOP("core", "%1 are not bounded"),
    QT_TRANSLATE_NOOP("core", "%1 is not bounded"),
    QT_TRANSLATE_NOOP("core", "velocity"),
    QT_TRANSLATE_NOOP("core", "acceleration"),
    QT_TRANSLATE_NOOP("core", "jerk"),
    QT_TRANSLATE_NOOP("core", "jerk (blend_jerk)"),
    QT_TRANSLATE_NOOP(
        "core", "Where rotary axes turn, every axis of the machine stays within %1 times its velocity."),
    QT_TRANSLATE_NOOP(
        "core",
        "Where rotary axes turn in rapids, every axis of the machine stays within %1 times its velocity."),
    QT_TRANSLATE_NOOP("core", "The speed jumps along the path."),
    QT_TRANSLATE_NOOP(
        "core", "The speed is continuous; the acceleration jumps where the curvature of the path does."),
    QT_TRANSLATE_NOOP("core", "Velocity and acceleration are continuous everywhere."),
    QT_TRANSLATE_NOOP("core",
                      "Where the program asks for BRISK, no jerk along the path is bounded: its "
                      "acceleration changes within one interpolation period."),
    QT_TRANSLATE_NOOP("core", "BRISK of the program is not followed."),
    QT_TRANSLATE_NOOP("core",
                      "A junction that touches an arc and turns by up to 0.01 rad is passed as if it "
                      "were tangent: there the velocity of an axis jumps by up to 1 % of the feed "
                      "(1 mm/s at 6000 mm/min)."),
    QT_TRANSLATE_NOOP("core", "Full stops at dwells only."),
    QT_TRANSLATE_NOOP("core", "Full stops %1."),
    QT_TRANSLATE_NOOP("core", "at corners of lines"),
    QT_TRANSLATE_NOOP("core", "at corners that touch an arc"),
    QT_TRANSLATE_NOOP("core", "at reversals"),
    QT_TRANSLATE_NOOP("core", "before and after every rapid"),
};

/// Lists and ranges: two parts, numbers or texts with a pattern, and the text between them.
constexpr std::array joints{QT_TRANSLATE_NOOP("core", "%1; %2"), QT_TRANSLATE_NOOP("core", "%1 and %2"),
                            QT_TRANSLATE_NOOP("core", "%1, %2"), QT_TRANSLATE_NOOP("core", "%1 to %2")};

struct Pattern {
  const char* text;
  bool has_names;
  TextPattern shape;
};

/// All patterns, those with more words first: "cycle %1 (%2) is not supported" before "%1 is not supported".
class Patterns {
 public:
  Patterns() {
    add(sentences, true);
    add(clauses, false);
    for (const auto& of_reader :
         {general_sentences(), iso_sentences(), sinumerik_sentences(), heidenhain_sentences(),
          control_sentences(), import_sentences(), failure_sentences()}) {
      add(of_reader, true);
    }
    std::ranges::stable_sort(all_, std::ranges::greater(),
                             [](const Pattern& p) { return p.shape.fixed_size(); });
    for (const Pattern& pattern : all_) {
      if (const auto beginning = pattern.shape.beginning()) {
        by_beginning_[*beginning];
      }
    }
    for (const Pattern& pattern : all_) {
      if (const auto beginning = pattern.shape.beginning()) {
        by_beginning_[*beginning].push_back(&pattern);
      } else {
        any_beginning_.push_back(&pattern);
        for (auto& same : by_beginning_) {
          same.push_back(&pattern);
        }
      }
    }
  }

  /// The patterns that may match a text with this beginning.
  const std::vector<const Pattern*>& of(QChar beginning) const {
    const auto found = by_beginning_.constFind(beginning);
    return found == by_beginning_.constEnd() ? any_beginning_ : *found;
  }

 private:
  void add(std::span<const char* const> texts, bool have_names) {
    for (const char* text : texts) {
      all_.push_back({text, have_names, TextPattern(QString::fromUtf8(text))});
    }
  }

  std::vector<Pattern> all_;
  QHash<QChar, std::vector<const Pattern*>> by_beginning_;
  std::vector<const Pattern*> any_beginning_;  ///< patterns that begin with a place
};

std::optional<QString> known_text(const QString& text);

/// Translates numbers, and axes, whose names stay.
std::optional<QString> number(const QString& text) {
  static const QRegularExpression digits(QStringLiteral("^([XYZ]|-?\\d+(\\.\\d+)?(e[-+]?\\d+)?)$"));
  return digits.match(text).hasMatch() ? std::optional(QString(text).replace('.', QLocale().decimalPoint()))
                                       : std::nullopt;
}

std::optional<QString> by_pattern(const Pattern& pattern, const QString& text) {
  const auto found = pattern.shape.match(text);
  if (!found) {
    return std::nullopt;
  }
  std::vector<QString> parts;
  for (const TextPattern::Part& part : *found) {
    const std::optional<QString> known = part.is_program_text ? part.text : known_text(part.text);
    if (!known && !pattern.has_names) {
      return std::nullopt;
    }
    parts.push_back(known.value_or(part.text));
  }
  return TextPattern::fill(QCoreApplication::translate("core", pattern.text), parts);
}

std::optional<QString> by_joint(const char* joint, const QString& text) {
  const QString between =
      QString::fromUtf8(joint).section(QStringLiteral("%1"), 1).section(QStringLiteral("%2"), 0, 0);
  for (qsizetype at = text.indexOf(between); at >= 0; at = text.indexOf(between, at + 1)) {
    const std::optional<QString> first = known_text(text.left(at));
    const std::optional<QString> second = first ? known_text(text.mid(at + between.size())) : std::nullopt;
    if (second) {
      return QCoreApplication::translate("core", joint).arg(*first, *second);
    }
  }
  return std::nullopt;
}

/// None if no pattern matches.
std::optional<QString> known_text(const QString& text) {
  if (const auto digits = number(text)) {
    return digits;
  }
  if (const QString whole = core_text(text.toStdString()); whole != text) {
    return whole;
  }
  if (text.isEmpty()) {
    return std::nullopt;
  }
  static const Patterns patterns;
  for (const Pattern* pattern : patterns.of(text.front())) {
    if (const auto made = by_pattern(*pattern, text)) {
      return made;
    }
  }
  for (const char* joint : joints) {
    if (const auto made = by_joint(joint, text)) {
      return made;
    }
  }
  return std::nullopt;
}

}  // namespace

QString composed_text(const std::string& text) {
  return composed_text(QString::fromStdString(text));
}

QString composed_text(const QString& text) {
  return speaks_english() ? text : known_text(text).value_or(text);
}

}  // namespace feedscope::ui
